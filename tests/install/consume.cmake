# Installs this build into a folder of its own, and builds and runs the installed examples against it:
# cmake -DBUILD_DIR=... -DCXX=... -P consume.cmake
set(prefix "${BUILD_DIR}/install-test/prefix")
set(examples "${BUILD_DIR}/install-test/examples")
set(components "${BUILD_DIR}/install-test/components")
file(REMOVE_RECURSE "${prefix}" "${examples}" "${components}")

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(failed)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\n${text}")
  endif()
  set(output "${text}" PARENT_SCOPE)
endfunction()

run("${CMAKE_COMMAND}" --install "${BUILD_DIR}" --prefix "${prefix}")
run("${prefix}/bin/voronaut" list suites)
if(NOT output MATCHES "quadrotor-paper")
  message(FATAL_ERROR "the installed program does not find the suites that ship:\n${output}")
endif()

run("${CMAKE_COMMAND}" -S "${prefix}/share/voronaut/examples" -B "${examples}" -G Ninja
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_PREFIX_PATH=${prefix})
run("${CMAKE_COMMAND}" --build "${examples}")
run("${examples}/ompl_benchmark")
message(STATUS "${output}")
run("${examples}/own_robot" "${prefix}/share/voronaut/examples/own_robot.log")
if(NOT output MATCHES "tracking rest at 8 0")
  message(FATAL_ERROR "the robot built against the installed package does not get there:\n${output}")
endif()
run("${examples}/own_program" list planners)
if(NOT output MATCHES "StraightLine")
  message(FATAL_ERROR "the program of three lines does not list its planner:\n${output}")
endif()
run("${prefix}/bin/voronaut" list planners --plugin "${examples}/libstraight_line.so")
if(NOT output MATCHES "StraightLine")
  message(FATAL_ERROR "the installed program does not take the plugin:\n${output}")
endif()

run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}/components" -B "${components}" -G Ninja
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_PREFIX_PATH=${prefix})
run("${CMAKE_COMMAND}" --build "${components}")
run("${components}/map_of_one_scan")
