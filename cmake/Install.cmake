# Headers, library, tool and a package: find_package(signum) then gives signum::signum.
include(CMakePackageConfigHelpers)
set(package_directory "${CMAKE_INSTALL_LIBDIR}/cmake/signum")

# What a user's program may include; tests/structure/consumer.cmake checks that each stands alone,
# without Boost and GMP.
set(public_headers
  signum.hpp
  core/index.hpp core/sign.hpp core/site.hpp core/strided_sites.hpp
  exact/sign_of_sum.hpp
  predicates/ccw.hpp predicates/power.hpp predicates/euclidean.hpp predicates/manhattan.hpp
  predicates/supremum.hpp predicates/arithmetic.hpp predicates/space.hpp
  triangulation/metric.hpp triangulation/arrays.hpp triangulation/options.hpp
  triangulation/tessellation.hpp triangulation/triangulate.hpp
  triangulation/validate.hpp triangulation/vertices.hpp triangulation/dynamic.hpp
  triangulation/edge_list.hpp triangulation/space.hpp
  kinetic/kinetic_tessellation.hpp
  spatial/ball_diagram.hpp spatial/compare.hpp spatial/touching_rectangular.hpp
  spatial/touching_spheres.hpp spatial/triangulate.hpp spatial/validate.hpp spatial/vertices.hpp
  spatial/any_dimension/triangulate.hpp spatial/any_dimension/validate.hpp
  voronoi/voronoi.hpp voronoi/curve.hpp voronoi/conic.hpp voronoi/clip.hpp voronoi/polygon.hpp
  voronoi/contacts.hpp voronoi/compare.hpp voronoi/space_cells.hpp voronoi/space_polyhedra.hpp
  motion/simulation.hpp motion/queries.hpp motion/meeting_time.hpp motion/shaking_wall.hpp)
# What these include in their turn: the filters, which are inline. Nobody includes them by name.
set(headers_behind
  core/contract.hpp core/handle.hpp
  kinetic/moving_site.hpp
  motion/ball.hpp motion/effects.hpp motion/meeting.hpp motion/obstacle.hpp motion/vector.hpp
  filters/bounds.hpp filters/environment.hpp filters/interval.hpp filters/rounding_count.hpp
  filters/tally.hpp
  filters/verdict.hpp
  predicates/additive.hpp
  predicates/euclidean/filter.hpp
  predicates/power/edge.hpp predicates/power/in_circle.hpp predicates/power/infinite.hpp
  predicates/power/ties.hpp predicates/power/weight.hpp
  predicates/space/ccw.hpp predicates/space/euclidean.hpp predicates/space/in_sphere.hpp
  predicates/space/nearer.hpp predicates/space/rectangular.hpp
  predicates/rectangular/forms.hpp predicates/rectangular/squares.hpp
  triangulation/structure/corners.hpp triangulation/structure/cycle.hpp)
foreach(header IN LISTS public_headers headers_behind)
  cmake_path(GET header PARENT_PATH folder)
  install(FILES "${header}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/signum/${folder}")
endforeach()
install(FILES bindings/c/signum.h DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/signum")

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
              cmake/FindMPFR.cmake cmake/HeaderAndLibrary.cmake
        DESTINATION "${package_directory}")
