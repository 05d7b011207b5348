# operands/operands.cpp as careless users compile it, with both compilers where they are there and
# with every liberty that is not refused: all its answers must be right.
set(scratch "${BUILD}/Testing/operands${ALONE}")
file(REMOVE_RECURSE "${scratch}")
file(MAKE_DIRECTORY "${scratch}")
set(folder "${SOURCES}/tests/structure/operands")
list(GET LIBRARIES 0 library)
get_filename_component(directory "${library}" DIRECTORY)

include("${CMAKE_CURRENT_LIST_DIR}/must.cmake")

must(${COMPILER} ${FLAGS} -std=c++20 -O1 -ffp-contract=off -DNDEBUG -c "${folder}/truth.cpp" -o
     "${scratch}/truth.o")

# All liberties at once, or each alone. What g++ betrays by a macro is refused, clang++ has none.
set(alone -fno-signed-zeros -fno-trapping-math -freciprocal-math -fno-math-errno -ffp-contract=fast)
set(all -O3 -march=native ${alone})
list(TRANSFORM alone PREPEND "-O2 ")
list(JOIN all " " all)
set(all_of_clang "${all} -fassociative-math")
foreach(program IN ITEMS g++ clang++-14)
  find_program(compiler "${program}" NO_CACHE)
  if(NOT compiler)
    message(STATUS "no ${program}: not tried")
    continue()
  endif()
  # With ALONE the others; they take minutes and are slow tests.
  set(liberties "-O2 -march=native")
  set(others -O1 "-O2 -frounding-math" ${alone})
  if(program MATCHES "clang")
    list(APPEND liberties "${all_of_clang}")
    list(APPEND others "-O2 -march=native -ffp-contract=fast" "-O2 -funsafe-math-optimizations"
         "-O3 -fassociative-math -fno-signed-zeros -fno-trapping-math")
  else()
    list(APPEND liberties "${all}")
  endif()
  if(ALONE)
    set(liberties ${others})
  endif()
  foreach(flags IN LISTS liberties)
    separate_arguments(options UNIX_COMMAND "${flags}")
    must("${compiler}" ${FLAGS} -std=c++20 ${options} -DNDEBUG "-I${directory}/include"
         "${folder}/operands.cpp" "${scratch}/truth.o"
         ${LIBRARIES} "${GMPXX_LIBRARY}" -pthread "-Wl,-rpath,${directory}" -o "${scratch}/operands")
    execute_process(COMMAND "${scratch}/operands" TIMEOUT 100 RESULT_VARIABLE code OUTPUT_VARIABLE output)
    if(NOT code EQUAL 0)
      message(FATAL_ERROR "${program} ${flags}\n${output}")
    endif()
    message(STATUS "${program} ${flags}: ${output}")
  endforeach()
  unset(compiler)
endforeach()
