# What comes without CMake files of its own: finds a header and a library, and gives the target
# NAME::NAME, linked with more targets where it needs them. A macro: find_package() reads NAME_FOUND
# in the scope of the module that calls it.
macro(find_header_and_library name header library)
  find_path(${name}_INCLUDE_DIR ${header})
  find_library(${name}_LIBRARY ${library})
  mark_as_advanced(${name}_INCLUDE_DIR ${name}_LIBRARY)
  include(FindPackageHandleStandardArgs)
  find_package_handle_standard_args(${name} REQUIRED_VARS ${name}_LIBRARY ${name}_INCLUDE_DIR)
  if(${name}_FOUND AND NOT TARGET ${name}::${name})
    add_library(${name}::${name} INTERFACE IMPORTED)
    target_include_directories(${name}::${name} SYSTEM INTERFACE "${${name}_INCLUDE_DIR}")
    target_link_libraries(${name}::${name} INTERFACE "${${name}_LIBRARY}" ${ARGN})
  endif()
endmacro()
