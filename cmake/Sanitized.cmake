# The library once more, under the address and undefined-behaviour sanitizers. The objects of a test, compiled once, are
# linked with either: to compile them twice takes longer than to run them. The preset `sanitize` (scripts/sanitize.sh)
# puts the tests' own code and the tool under the sanitizers, too.
if(SIGNUM_OPTIONS_UNDER_SANITIZERS)
  message(FATAL_ERROR "SIGNUM_SANITIZED_TESTS is for a build without sanitizers of its own")
endif()

set(SIGNUM_SANITIZERS -fsanitize=address,undefined -fno-sanitize=null,object-size,alignment
    -fno-sanitize-recover=all)
# Shared, so that its own templates are called where a test has the same without a sanitizer. Optimized a little: what
# more takes to compile less takes to run; contracts are checked.
add_library(signum_sanitized SHARED ${predicate_sources} ${library_sources})
describe_library(signum_sanitized "" ${SIGNUM_NUMBERS} ${SIGNUM_THREADS} Threads::Threads)
target_compile_options(signum_sanitized PRIVATE -fno-semantic-interposition ${SIGNUM_IEEE_OPTIONS} -Og -g1 -UNDEBUG
                       -fno-omit-frame-pointer ${SIGNUM_SANITIZERS})
target_link_options(signum_sanitized PRIVATE ${SIGNUM_SANITIZERS} "LINKER:-Bsymbolic-functions")
set_target_properties(signum_sanitized PROPERTIES EXCLUDE_FROM_ALL ON)
if(SIGNUM_UNITY_BUILD)
  target_precompile_headers(signum_sanitized PRIVATE ${headers_of_numbers})
endif()
