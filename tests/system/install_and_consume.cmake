# cmake -DBUILD_DIR=... -DSOURCE_DIR=... -DWORK_DIR=... -DVERSION=... -P install_and_consume.cmake
# Installs flownav into an empty prefix, builds a foreign project against it, and runs what was built and installed.
set(prefix ${WORK_DIR}/prefix)
set(consumer_build ${WORK_DIR}/build)
file(REMOVE_RECURSE ${WORK_DIR})

function(run)
    execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
    if(NOT result EQUAL 0)
        message(FATAL_ERROR "failed (${result}): ${ARGN}\n${output}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${prefix})
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${consumer_build} -G Ninja
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${consumer_build})

# The examples are built as a foreign project does it.
run(${CMAKE_COMMAND} -S ${SOURCE_DIR}/share/examples -B ${WORK_DIR}/examples -G Ninja
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${WORK_DIR}/examples)
run(${WORK_DIR}/examples/sense ${SOURCE_DIR}/share/datasets/corridor.rawlog)
if(NOT output MATCHES "^[0-9.]+ [-0-9.]+ [-0-9.]+ [-0-9.]+\n")
    message(FATAL_ERROR "sense said:\n${output}")
endif()

run(${consumer_build}/use_pipeline)
if(NOT output MATCHES "0.16 s: [a-z_]+\nflownav ${VERSION}\n$")
    message(FATAL_ERROR "use_pipeline said:\n${output}")
endif()
run(${consumer_build}/use_config ${prefix}/share/flownav/ini/donkeycar.ini)
if(NOT output MATCHES "height_m = 0.17\n")
    message(FATAL_ERROR "use_config said:\n${output}")
endif()
file(GLOB programs ${prefix}/bin/flownav-*)
foreach(program IN LISTS programs)
    run(${program} --version)
endforeach()

file(GLOB plugin ${prefix}/lib*/libflownav-sensor.so ${prefix}/lib/*/libflownav-sensor.so)
if(NOT plugin)
    message(FATAL_ERROR "libflownav-sensor.so is not installed")
endif()

# Installed files must not refer to the source and build trees.
file(GLOB_RECURSE texts ${prefix}/*.cmake ${prefix}/*.h ${prefix}/*.ini)
foreach(text IN LISTS texts)
    file(READ ${text} content)
    foreach(tree ${SOURCE_DIR} ${BUILD_DIR})
        string(FIND "${content}" "${tree}" at)
        if(NOT at EQUAL -1)
            message(FATAL_ERROR "${text} names ${tree}")
        endif()
    endforeach()
endforeach()
file(REMOVE_RECURSE ${WORK_DIR})
