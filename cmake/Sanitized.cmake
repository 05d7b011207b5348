# The library once more, under the address and undefined-behaviour sanitizers. The objects of a test, compiled once, are
# linked with either: to compile them twice takes longer than to run them. The preset `sanitize` (scripts/sanitize.sh)
# puts the tests' own code and the tool under the sanitizers, too.
option(SIGNUM_SANITIZED_TESTS "Unit and property tests also with a library under the sanitizers" OFF)
if(NOT SIGNUM_SANITIZED_TESTS)
  return()
endif()

if(SIGNUM_OPTIONS_UNDER_SANITIZERS)
  message(FATAL_ERROR "SIGNUM_SANITIZED_TESTS is for a build without sanitizers of its own")
endif()

set(SIGNUM_SANITIZERS -fsanitize=address,undefined -fno-sanitize=null,object-size,alignment
    -fno-sanitize-recover=all)
# Shared, so that its own templates are called where a test has the same without a sanitizer. Not optimized, which
# takes half the time; contracts are checked.
add_library(signum_sanitized SHARED ${library_sources})
describe_library(signum_sanitized)
target_compile_options(signum_sanitized PRIVATE -fno-semantic-interposition ${SIGNUM_IEEE_OPTIONS} -O0 -g1 -UNDEBUG
                       -fno-omit-frame-pointer ${SIGNUM_SANITIZERS})
target_link_options(signum_sanitized PRIVATE ${SIGNUM_SANITIZERS} "LINKER:-Bsymbolic-functions")
set_target_properties(signum_sanitized PROPERTIES EXCLUDE_FROM_ALL ON)
if(SIGNUM_UNITY_BUILD)
  get_target_property(headers signum PRECOMPILE_HEADERS)
  target_precompile_headers(signum_sanitized PRIVATE ${headers})
endif()

# NAME OBJECTS LIBRARY...: a program of these objects, and a test, sanitized.NAME, that runs it.
add_custom_target(sanitized_tests)
function(add_sanitized_test name objects)
  add_executable(${name}_sanitized $<TARGET_OBJECTS:${objects}>)
  target_link_libraries(${name}_sanitized PRIVATE signum_sanitized ${ARGN})
  target_link_options(${name}_sanitized PRIVATE ${SIGNUM_SANITIZERS})
  set_target_properties(${name}_sanitized PROPERTIES EXCLUDE_FROM_ALL ON)
  add_dependencies(sanitized_tests ${name}_sanitized)
  add_test(NAME sanitized.${name} COMMAND ${name}_sanitized)
  # Numbers of GMP are allocated by the million; to note who asked, and whom for, is enough.
  set_tests_properties(sanitized.${name} PROPERTIES LABELS sanitized TIMEOUT 600 ENVIRONMENT_MODIFICATION
                       ASAN_OPTIONS=path_list_prepend:malloc_context_size=2)
endfunction()
