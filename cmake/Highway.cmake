# What asks batches of predicates by vectors (predicates/batch/): Highway's headers; without them one question after
# another. Nothing of it is linked, and no header of ours includes it.
set(SIGNUM_WITH_HIGHWAY AUTO CACHE STRING "Batches by vectors, with Highway's headers: ON, OFF, or AUTO, where they are found")
set_property(CACHE SIGNUM_WITH_HIGHWAY PROPERTY STRINGS AUTO ON OFF)
if(SIGNUM_WITH_HIGHWAY)
  find_path(HIGHWAY_INCLUDE_DIR hwy/highway.h)
  mark_as_advanced(HIGHWAY_INCLUDE_DIR)
  if(HIGHWAY_INCLUDE_DIR)
    message(STATUS "Batches of predicates by vectors, with Highway")
    add_compile_definitions(SIGNUM_WITH_HIGHWAY)
    include_directories(SYSTEM "${HIGHWAY_INCLUDE_DIR}")
  elseif(NOT SIGNUM_WITH_HIGHWAY STREQUAL AUTO)
    message(FATAL_ERROR "Highway's headers are not found: install them (Debian: libhwy-dev) or configure without \
-DSIGNUM_WITH_HIGHWAY=ON")
  endif()
endif()
