# Runs the example of a robot of one's own on its log and looks at what it is linked with:
# cmake -DPROGRAM=... -DLOG=... -P own_robot.cmake
execute_process(COMMAND "${PROGRAM}" "${LOG}"
  RESULT_VARIABLE failed OUTPUT_VARIABLE text ERROR_VARIABLE text)
if(failed)
  message(FATAL_ERROR "own_robot: ${failed}\n${text}")
endif()
string(REGEX MATCHALL "\n" lines "${text}")
list(LENGTH lines count)
if(NOT count EQUAL 25)
  message(FATAL_ERROR "${count} setpoints for the 25 scans of the log:\n${text}")
endif()
if(NOT text MATCHES "tracking pass .* at .* m/s" OR NOT text MATCHES "tracking rest at 8 0\n$")
  message(FATAL_ERROR "the robot does not pass on to the goal and rest there:\n${text}")
endif()

file(GET_RUNTIME_DEPENDENCIES EXECUTABLES "${PROGRAM}"
  RESOLVED_DEPENDENCIES_VAR found UNRESOLVED_DEPENDENCIES_VAR missing)
if(NOT found MATCHES "libompl")
  message(FATAL_ERROR "own_robot without OMPL? It is linked with: ${found}")
endif()
foreach(unwanted sqlite yaml crypto ssl CLI)
  if("${found};${missing}" MATCHES "lib[^;/]*${unwanted}")
    message(FATAL_ERROR "own_robot is linked with ${unwanted}: ${found};${missing}")
  endif()
endforeach()
message(STATUS "own_robot: ${count} setpoints, and nothing of benchmarks linked")
