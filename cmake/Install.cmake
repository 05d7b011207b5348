# Headers, libraries, tool and a package: find_package(signum) then gives signum::signum and signum::predicates,
# find_package(signum COMPONENTS predicates) the latter alone.
include(CMakePackageConfigHelpers)
set(package_directory "${CMAKE_INSTALL_LIBDIR}/cmake/signum")

# What a user's program may include is signum.hpp and what it includes by name; what these include in their turn, the
# filters, which are inline, is installed with it. tests/structure/consumer.cmake checks that each header stands alone,
# without Boost and GMP.
set(headers signum.hpp)
set(unread signum.hpp)
while(unread)
  list(POP_FRONT unread header)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${header}")
  cmake_path(GET header PARENT_PATH folder)
  file(STRINGS "${header}" includes REGEX "^#include \"")
  foreach(line IN LISTS includes)
    string(REGEX REPLACE "^#include \"(.*)\"$" "\\1" included "${line}")
    cmake_path(APPEND folder "${included}" OUTPUT_VARIABLE included)
    cmake_path(NORMAL_PATH included)
    if(NOT included IN_LIST headers)
      list(APPEND headers "${included}")
      list(APPEND unread "${included}")
    endif()
  endforeach()
endwhile()
# What needs a library of the user's own, which is no dependency of the package.
file(GLOB interop_headers RELATIVE "${PROJECT_SOURCE_DIR}" CONFIGURE_DEPENDS bindings/interop/*.hpp bindings/interop/cgal/*.hpp)
set(c_headers bindings/c/signum.h)
if(SIGNUM_ONLY_PREDICATES)
  list(FILTER headers INCLUDE REGEX "^(core|exact|filters|predicates)/")
  set(interop_headers)
  set(c_headers)
endif()
foreach(header IN LISTS headers interop_headers)
  cmake_path(GET header PARENT_PATH folder)
  string(REGEX REPLACE "^bindings/" "" folder "${folder}")
  install(FILES "${header}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/signum/${folder}" COMPONENT development)
endforeach()
if(TARGET signum_classic)
  list(APPEND c_headers bindings/classic/classic.h)
endif()
install(FILES ${c_headers} DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/signum" COMPONENT development)

option(SIGNUM_DEBIAN "Make Debian packages with cpack: scripts/package.sh" OFF)
# Its parts are those of a distribution's packages: library, development, tool.
install(TARGETS signum_predicates EXPORT signum-predicates-targets ARCHIVE COMPONENT development)
install(EXPORT signum-predicates-targets NAMESPACE signum:: DESTINATION "${package_directory}" COMPONENT development)
set(libraries)
foreach(library IN ITEMS signum signum_static signum_classic)
  if(TARGET ${library})
    list(APPEND libraries ${library})
  endif()
endforeach()
if(libraries)
  install(TARGETS ${libraries} EXPORT signum-targets
          RUNTIME COMPONENT library
          LIBRARY COMPONENT library NAMELINK_COMPONENT development
          ARCHIVE COMPONENT development)
  install(EXPORT signum-targets NAMESPACE signum:: DESTINATION "${package_directory}" COMPONENT development)
endif()
# All that `cmake --install` looks for, for who builds no more than this: ./run.
add_custom_target(signum_package)
add_dependencies(signum_package signum_predicates ${libraries})
if(TARGET signum_tool)
  add_dependencies(signum_package signum_tool)
endif()
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT licence)
if(TARGET signum_tool)
  install(TARGETS signum_tool COMPONENT tool)
  if(NOT SIGNUM_DEBIAN)
    install(FILES packaging/signum.1 DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT tool)
  endif()
  install(FILES packaging/completions/signum.bash RENAME signum COMPONENT tool
          DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions")
  set(SIGNUM_ZSH_FOLDER "${CMAKE_INSTALL_DATADIR}/zsh/site-functions" CACHE STRING "Where zsh looks for completions")
  mark_as_advanced(SIGNUM_ZSH_FOLDER)
  install(FILES packaging/completions/_signum DESTINATION "${SIGNUM_ZSH_FOLDER}" COMPONENT tool)
endif()

configure_package_config_file(cmake/signum-config.cmake.in "${PROJECT_BINARY_DIR}/signum-config.cmake"
                              INSTALL_DESTINATION "${package_directory}")
# Before version 1 a new minor version may break.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/signum-config-version.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/signum-config.cmake"
              "${PROJECT_BINARY_DIR}/signum-config-version.cmake" cmake/FindGMP.cmake
              cmake/FindMPFR.cmake cmake/HeaderAndLibrary.cmake
        DESTINATION "${package_directory}" COMPONENT development)

if(SIGNUM_ONLY_PREDICATES)
  return()
endif()

# For pkg-config. Who links the static library needs what it is linked with, the C++ library included, for a
# program in C; where there is no other library, that is everyone.
set(libraries ${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES})
list(FILTER libraries INCLUDE REGEX "^(stdc\\+\\+|c\\+\\+|c\\+\\+abi|m)$")
list(TRANSFORM libraries PREPEND " -l")
list(JOIN libraries "" libraries)
string(APPEND libraries " -pthread")
set(requires "")
if(SIGNUM_WITH_GMP)
  list(APPEND requires mpfr gmp)
endif()
if(SIGNUM_WITH_TBB)
  list(APPEND requires tbb)
endif()
list(JOIN requires ", " requires)
if(requires)
  string(PREPEND requires " ")
endif()
set(PC_LIBRARIES "")
set(PC_REQUIRES "")
set(PC_PRIVATE_LIBRARIES "${libraries}")
set(PC_PRIVATE_REQUIRES "${requires}")
if(NOT BUILD_SHARED_LIBS)
  set(PC_LIBRARIES "${libraries}")
  set(PC_REQUIRES "${requires}")
  set(PC_PRIVATE_LIBRARIES "")
  set(PC_PRIVATE_REQUIRES "")
endif()
file(RELATIVE_PATH PREFIX_FROM_PC "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" PREFIX_FROM_PC "${PREFIX_FROM_PC}")
configure_file(packaging/signum.pc.in "${PROJECT_BINARY_DIR}/signum.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/signum.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT development)

if(SIGNUM_DEBIAN)
  include("${PROJECT_SOURCE_DIR}/packaging/debian/packages.cmake")
endif()
