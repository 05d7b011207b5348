# Debian packages by CPack, a part of the installation each: libsignum0.1, libsignum-dev, signum. scripts/package.sh
# configures, makes and checks them.
set(SIGNUM_MAINTAINER "The signum authors <maintainers@signum.invalid>" CACHE STRING "Whom the packages name")
set(version ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libsignum${version})
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libsignum-dev)
set(CPACK_DEBIAN_TOOL_PACKAGE_NAME signum)

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL library development tool)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${SIGNUM_MAINTAINER}")
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_LIST_DIR}/triggers;${PROJECT_BINARY_DIR}/shlibs")
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "Signs of geometric predicates that are right for all finite doubles, and the
generalized Delaunay tessellations and Voronoi diagrams of discs, diamonds and
squares, in the plane and in space, that stand on them.
.
The shared library.")
set(shlibs "")
foreach(library IN ITEMS libsignum libsignum_classic)
  string(APPEND shlibs "${library} ${version} libsignum${version} (>= ${PROJECT_VERSION})\n")
endforeach()
file(WRITE "${PROJECT_BINARY_DIR}/shlibs" "${shlibs}")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libsignum${version} (= ${PROJECT_VERSION})")
if(SIGNUM_WITH_GMP)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libgmp-dev, libmpfr-dev")
endif()
if(SIGNUM_WITH_TBB)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libtbb-dev")
endif()
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "Headers, static library, CMake package and pkg-config file of signum: signs of
geometric predicates that are right for all finite doubles, and tessellations
and Voronoi diagrams in four metrics.")

set(CPACK_DEBIAN_TOOL_PACKAGE_SECTION math)
set(CPACK_DEBIAN_TOOL_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TOOL_PACKAGE_RECOMMENDS "gnuplot-nox, librsvg2-bin")
set(CPACK_DEBIAN_TOOL_DESCRIPTION "Computes generalized Delaunay tessellations and Voronoi diagrams of discs,
diamonds and squares in the plane and of balls in space, judges them from
scratch, and simulates balls that move and strike in the exact order.")

# What Debian wants of each: its licence and its history.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(component IN ITEMS LIBRARY DEVELOPMENT TOOL)
  set(name "${CPACK_DEBIAN_${component}_PACKAGE_NAME}")
  string(TOLOWER ${component} part)
  set(folder "${PROJECT_BINARY_DIR}/debian/${name}")
  configure_file("${CMAKE_CURRENT_LIST_DIR}/copyright" "${folder}/copyright" COPYONLY)
  file(WRITE "${folder}/changelog" "signum (${PROJECT_VERSION}) unstable; urgency=medium

  * See CHANGELOG.md of the sources.

 -- ${SIGNUM_MAINTAINER}  ${date}
")
  execute_process(COMMAND gzip -9nf "${folder}/changelog" COMMAND_ERROR_IS_FATAL ANY)
  install(FILES "${folder}/copyright" "${folder}/changelog.gz" DESTINATION "share/doc/${name}" COMPONENT ${part})
endforeach()
# Debian's manual pages are compressed.
if(TARGET signum_tool)
  execute_process(COMMAND gzip -9nc "${PROJECT_SOURCE_DIR}/packaging/signum.1"
                  OUTPUT_FILE "${PROJECT_BINARY_DIR}/debian/signum.1.gz" COMMAND_ERROR_IS_FATAL ANY)
  install(FILES "${PROJECT_BINARY_DIR}/debian/signum.1.gz" DESTINATION share/man/man1 COMPONENT tool)
endif()
include(CPack)
