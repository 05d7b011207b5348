# A compiler that says that it takes liberties with IEEE arithmetic is refused, in our words.
set(our_words "signum needs IEEE arithmetic")
set(refused -ffast-math -Ofast -ffinite-math-only)
set(headers core/contract.hpp core/error_free.hpp predicates/ccw.hpp predicates/power.hpp
    predicates/euclidean.hpp predicates/supremum.hpp predicates/manhattan.hpp)

# Compiles a program that includes one header.
function(try header flag code output)
  set(source "${BUILD}/Testing/structure_fast_math.cpp")
  file(WRITE "${source}" "#include <signum/${header}>\n")
  execute_process(COMMAND ${COMPILER} ${FLAGS} ${flag} -std=c++20 "-I${BUILD}/include" -fsyntax-only
                          "${source}"
                  RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE error)
  set(${code} "${result}" PARENT_SCOPE)
  set(${output} "${out}${error}" PARENT_SCOPE)
endfunction()

foreach(header IN LISTS headers)
  try("${header}" "-O2" code output)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${header} does not compile at all:\n${output}")
  endif()
  foreach(flag IN LISTS refused)
    try("${header}" "${flag}" code output)
    if(code EQUAL 0)
      message(FATAL_ERROR "${header} compiles with ${flag}")
    elseif(NOT output MATCHES "${our_words}")
      message(FATAL_ERROR "${header} with ${flag} fails, but not in our words:\n${output}")
    endif()
  endforeach()
endforeach()
