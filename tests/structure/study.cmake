# A small study from one command: it is cut off, goes on, measures nothing twice, and what it finds has
# the thesis's shape. With gnuplot every figure is in the report; without it one line says what to install.
set(scratch "${BUILD}/Testing/study")
file(REMOVE_RECURSE "${scratch}")
set(options study --quick --metric power --metric supremum --sites 100:2000 -o "${scratch}")

function(study code)
  execute_process(COMMAND "${TOOL}" ${options} ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE out
                          ERROR_VARIABLE error)
  if(NOT result EQUAL code)
    message(FATAL_ERROR "signum ${options} ${ARGN} ends with ${result}:\n${out}${error}")
  endif()
  set(error "${error}" PARENT_SCOPE)
endfunction()

# Cut off after a second; then half a line is left, as by a power cut.
study(0 --seconds 1 --no-report)
file(APPEND "${scratch}/results.csv" "sites,power,ci")
file(READ "${scratch}/results.csv" before)
string(REGEX REPLACE "sites,power,ci$" "" before "${before}")
study(0)
file(READ "${scratch}/results.csv" after)
string(FIND "${after}" "${before}" place)
if(NOT place EQUAL 0)
  message(FATAL_ERROR "going on changed what was there")
endif()
study(0)
file(READ "${scratch}/results.csv" again)
if(NOT again STREQUAL after)
  message(FATAL_ERROR "a finished study was measured again")
endif()

# Results of another study are not mixed with these, and a file is no directory.
study(2 --metric euclidean)
if(NOT error MATCHES "--fresh")
  message(FATAL_ERROR "does not say what to do: ${error}")
endif()
study(2 -o "${scratch}/results.csv")

# The value of a quantity in the power metric at 200 sites.
function(value distribution contestant quantity result)
  string(REGEX MATCH "\nsites,power,${distribution},200,[^\n]*,${contestant},${quantity},([^,]*)," found
         "${after}")
  if(NOT found)
    message(FATAL_ERROR "no ${quantity} of ${contestant} on ${distribution}")
  endif()
  set(${result} "${CMAKE_MATCH_1}" PARENT_SCOPE)
endfunction()
foreach(what IN ITEMS "exact,ratio" "single,wrong_percent")
  string(REPLACE "," ";" what "${what}")
  list(GET what 0 contestant)
  list(GET what 1 quantity)
  value(random ${contestant} ${quantity} random)
  value(circle ${contestant} ${quantity} circle)
  if(NOT circle GREATER random)
    message(FATAL_ERROR "${contestant}, ${quantity}: circle ${circle}, random ${random}")
  endif()
endforeach()

file(READ "${scratch}/results.json" json)
string(JSON count LENGTH "${json}" rows)
if(count LESS 1000)
  message(FATAL_ERROR "results.json has ${count} rows")
endif()

find_program(GNUPLOT gnuplot)
if(NOT GNUPLOT)
  message(STATUS "no gnuplot: no report to look at")
  return()
endif()
file(READ "${scratch}/report.html" page)
foreach(figure IN ITEMS margin first_error wrong_by_sites wrong_by_perturbation ratio_by_sites
                        ratio_by_perturbation radii stages stage_cost kernels swaps swap_times sweep
                        deletion hard)
  if(NOT page MATCHES "<section id=\"${figure}\">" OR NOT EXISTS "${scratch}/figures/${figure}.svg")
    message(FATAL_ERROR "the report lacks ${figure}")
  endif()
endforeach()
if(page MATCHES "<script|<link|(src|href)=[\"'](http|[a-z]+/)")
  message(FATAL_ERROR "the report is not self-contained: ${CMAKE_MATCH_0}")
endif()

# Without gnuplot: numbers, and a line that says what to install.
set(ENV{PATH} "${scratch}")
file(REMOVE "${scratch}/report.html")
study(0)
if(NOT error MATCHES "gnuplot-nox" OR EXISTS "${scratch}/report.html")
  message(FATAL_ERROR "says nothing of gnuplot: ${error}")
endif()
