# cmake -D PROGRAM=... -D EXPECTED=... -P compare_output.cmake: runs a program, compares its output with a file.
execute_process(COMMAND ${PROGRAM} OUTPUT_VARIABLE found ERROR_VARIABLE complaint RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} ended with ${status}: ${complaint}")
endif()
file(READ ${EXPECTED} wanted)
if(NOT found STREQUAL wanted)
  message(FATAL_ERROR "the output differs from ${EXPECTED}. Found:\n${found}\nWanted:\n${wanted}")
endif()
