# Runs a command that must end well; its output in the variable `output`.
function(must)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE error)
  if(NOT code EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\n${out}${error}")
  endif()
  set(output "${out}" PARENT_SCOPE)
endfunction()
