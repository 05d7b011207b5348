# Headers, library, tool and a package: find_package(signum) then gives signum::signum.
include(CMakePackageConfigHelpers)
set(package_directory "${CMAKE_INSTALL_LIBDIR}/cmake/signum")

# The headers that a user's program may reach. What only the library's own sources include stays
# here; tests/structure/consumer.cmake checks that the rest stands alone, without Boost and GMP.
install(DIRECTORY core exact filters predicates triangulation voronoi
        DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/signum"
        FILES_MATCHING PATTERN "*.hpp"
        REGEX "exact/multiprecision\\.hpp$" EXCLUDE
        REGEX "voronoi/vector\\.hpp$" EXCLUDE
        PATTERN "cold_*.hpp" EXCLUDE)

install(TARGETS signum EXPORT signum-targets)
if(TARGET signum_tool)
  install(TARGETS signum_tool)
endif()
install(EXPORT signum-targets NAMESPACE signum:: DESTINATION "${package_directory}")

configure_package_config_file(cmake/signum-config.cmake.in "${PROJECT_BINARY_DIR}/signum-config.cmake"
                              INSTALL_DESTINATION "${package_directory}")
# Before version 1 a new minor version may break.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/signum-config-version.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/signum-config.cmake"
              "${PROJECT_BINARY_DIR}/signum-config-version.cmake" cmake/FindGMP.cmake
        DESTINATION "${package_directory}")
