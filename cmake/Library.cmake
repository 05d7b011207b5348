# What the library is to those who link it: signum::signum, static or shared as BUILD_SHARED_LIBS says. Beside a
# shared one, which exports its interface alone (packaging/exports.map), there is a static one of the same objects,
# signum::signum_static. signum_internals is the one that has every name: for the tool and the tests.

# Who links the library needs GMP, MPFR and threads, not the warnings and not Boost, which is headers alone.
function(describe_library target)
  add_library(signum::${target} ALIAS ${target})
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(${target} PRIVATE ${SIGNUM_NUMBERS} Threads::Threads
                        $<BUILD_INTERFACE:signum_warnings> $<BUILD_INTERFACE:Boost::headers>)
endfunction()

describe_library(signum)
# Before version 1 a minor version may break: it is part of the name.
set_target_properties(signum PROPERTIES VERSION ${PROJECT_VERSION}
                      SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

set(exports "${PROJECT_SOURCE_DIR}/packaging/exports.map")
include(CheckLinkerFlag)
check_linker_flag(CXX "LINKER:--version-script=${exports}" SIGNUM_HAS_VERSION_SCRIPTS)
if(BUILD_SHARED_LIBS AND SIGNUM_HAS_VERSION_SCRIPTS AND NOT SIGNUM_EXPORT_ALL)
  target_link_options(signum PRIVATE "LINKER:--version-script=${exports}" "LINKER:-Bsymbolic-functions")
  set_target_properties(signum PROPERTIES LINK_DEPENDS "${exports}")
  add_library(signum_static STATIC $<TARGET_OBJECTS:signum>)
  describe_library(signum_static)
  set_target_properties(signum_static PROPERTIES OUTPUT_NAME signum LINKER_LANGUAGE CXX)
  add_library(signum_internals ALIAS signum_static)
else()
  add_library(signum_internals ALIAS signum)
endif()
