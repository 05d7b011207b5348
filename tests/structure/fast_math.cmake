# A compiler that says that it takes liberties with IEEE arithmetic is refused, in our words. The
# library's own sources undo them.
set(our_words "signum needs IEEE arithmetic")
set(scratch "${BUILD}/Testing/fast_math")
file(MAKE_DIRECTORY "${scratch}")
file(GLOB headers RELATIVE "${SOURCES}" "${SOURCES}/predicates/*.hpp")
list(APPEND headers core/contract.hpp core/error_free.hpp)
set(hostile -ffast-math -Ofast -ffinite-math-only -funsafe-math-optimizations
    "-fassociative-math -fno-signed-zeros -fno-trapping-math")

# Compiles a program that includes one header, up to the first error.
function(try header flags code output)
  set(source "${scratch}/header.cpp")
  file(WRITE "${source}" "#include <signum/${header}>\n")
  separate_arguments(options UNIX_COMMAND "${flags}")
  execute_process(COMMAND "${compiler}" ${FLAGS} ${options} -std=c++20 "-I${BUILD}/include"
                          -fsyntax-only -Wfatal-errors "${source}"
                  RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE error)
  set(${code} "${result}" PARENT_SCOPE)
  set(${output} "${out}${error}" PARENT_SCOPE)
endfunction()

# What a compiler that tells nobody would make of an error-free transform.
file(WRITE "${scratch}/transform.cpp" "
double error(double a, double b) {
    const double sum = a + b;
    const double b_virtual = sum - a;
    return (a - (sum - b_virtual)) + (b - b_virtual);
}
int main(int count, char**) {
    const double a = count;
    return error(a, a * 0x1p-60) == 0x1p-60 ? 0 : 1;
}
")

foreach(program IN ITEMS g++ clang++-14)
  find_program(compiler "${program}" NO_CACHE)
  if(NOT compiler)
    message(STATUS "no ${program}: not tried")
    continue()
  endif()
  # By what macros it tells.
  set(refused -ffast-math -Ofast -ffinite-math-only)
  if(NOT program MATCHES "clang")
    set(refused ${hostile} -fsingle-precision-constant)
  endif()
  foreach(header IN LISTS headers)
    try("${header}" "-O2" code output)
    if(NOT code EQUAL 0)
      message(FATAL_ERROR "${program}: ${header} does not compile at all:\n${output}")
    endif()
    foreach(flags IN LISTS refused)
      try("${header}" "${flags}" code output)
      if(code EQUAL 0)
        message(FATAL_ERROR "${program}: ${header} compiles with ${flags}")
      elseif(NOT output MATCHES "${our_words}")
        message(FATAL_ERROR "${program}: ${header} with ${flags} fails, but not in our words:\n${output}")
      endif()
    endforeach()
  endforeach()
  foreach(flags IN LISTS hostile)
    separate_arguments(options UNIX_COMMAND "${flags}")
    execute_process(COMMAND "${compiler}" -O3 ${options} ${IEEE_OPTIONS} "${scratch}/transform.cpp" -o
                            "${scratch}/transform" ERROR_QUIET)
    execute_process(COMMAND "${scratch}/transform" RESULT_VARIABLE code)
    if(NOT code EQUAL 0)
      message(FATAL_ERROR "${program}: the library's options do not undo ${flags}")
    endif()
  endforeach()
  unset(compiler)
endforeach()

# They stand behind whatever the packager gave.
list(JOIN IEEE_OPTIONS " " expected)
file(READ "${BUILD}/compile_commands.json" commands)
foreach(source IN ITEMS exact/sign_of_sum.cpp exact/expansion.cpp predicates/ccw.cpp)
  if(NOT commands MATCHES "${expected}( -W[^ ]*| -std=[^ ]*| -include [^ ]*)* -o [^\n]* -c [^\n]*/${source}\"")
    message(FATAL_ERROR "${source} is not compiled with ${expected} behind all other flags")
  endif()
endforeach()

# No other program's copy takes the place of what these flags would break.
find_program(NM nm)
list(GET LIBRARIES 0 library)
if(NM AND library MATCHES "\\.a$")
  execute_process(COMMAND "${NM}" -C "${library}" OUTPUT_VARIABLE symbols ERROR_QUIET)
  if(symbols MATCHES " [WV] (signum::exact::terms::[^\n]*|signum::(quick_)?two_[^\n]*)")
    message(FATAL_ERROR "${CMAKE_MATCH_1} may be replaced by a copy compiled elsewhere")
  endif()
  if(NOT symbols MATCHES " T signum::exact::terms::sum")
    message(FATAL_ERROR "signum::exact::terms::sum is not in the library")
  endif()
endif()
