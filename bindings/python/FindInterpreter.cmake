# signum_find_python(<interpreter> <complaints>): the first interpreter of PATH's and the system's that has
# headers and NumPy; empty where there is none, and then what each one lacks, a line each. Where
# SIGNUM_PYTHON is set it is that one or none, and NumPy is not asked for: pip hides it from a build.
function(signum_find_python interpreter complaints)
  set(candidates "${SIGNUM_PYTHON}")
  if(NOT SIGNUM_PYTHON)
    find_program(SIGNUM_PYTHON_IN_PATH python3)
    mark_as_advanced(SIGNUM_PYTHON_IN_PATH)
    set(candidates ${SIGNUM_PYTHON_IN_PATH} /usr/bin/python3 /usr/local/bin/python3)
    list(REMOVE_DUPLICATES candidates)
  endif()
  set(all_complaints "")
  foreach(candidate IN LISTS candidates)
    if(NOT EXISTS "${candidate}")
      string(APPEND all_complaints "  ${candidate}: there is no such program\n")
      continue()
    endif()
    execute_process(
      COMMAND "${candidate}" -c "
import os, sys, sysconfig
header = os.path.join(sysconfig.get_paths()['include'], 'Python.h')
if not os.path.exists(header): sys.exit('no headers: ' + header + ' is missing')
if not '${SIGNUM_PYTHON}':
    try: import numpy
    except ImportError: sys.exit('no NumPy')
print(sys.executable)"
      RESULT_VARIABLE code OUTPUT_VARIABLE found ERROR_VARIABLE complaint
      OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_STRIP_TRAILING_WHITESPACE)
    if(code EQUAL 0)
      set(${interpreter} "${found}" PARENT_SCOPE)
      set(${complaints} "" PARENT_SCOPE)
      return()
    endif()
    string(APPEND all_complaints "  ${candidate}: ${complaint}\n")
  endforeach()
  set(${interpreter} "" PARENT_SCOPE)
  set(${complaints} "${all_complaints}" PARENT_SCOPE)
endfunction()
