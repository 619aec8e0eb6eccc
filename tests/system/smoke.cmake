# cmake -DPROGRAM=path -DNAME=flownav-config -DVERSION=0.1.0 -DUSAGE=1 -P smoke.cmake; USAGE: exit status for
# bad usage
# Requires of every program: --help (with its exit statuses), --version, and an error for unknown arguments.
execute_process(COMMAND ${PROGRAM} --help OUTPUT_VARIABLE help RESULT_VARIABLE status)
if(NOT status EQUAL 0 OR NOT help MATCHES "[Ee]xit status")
    message(FATAL_ERROR "--help ended with ${status}:\n${help}")
endif()
execute_process(COMMAND ${PROGRAM} --version OUTPUT_VARIABLE version RESULT_VARIABLE status)
if(NOT status EQUAL 0 OR NOT version MATCHES "${NAME}.* ${VERSION}")
    message(FATAL_ERROR "--version ended with ${status}:\n${version}")
endif()
execute_process(COMMAND ${PROGRAM} --no-such-option OUTPUT_QUIET ERROR_VARIABLE error RESULT_VARIABLE status)
if(NOT status EQUAL USAGE OR error STREQUAL "")
    message(FATAL_ERROR "an unknown option ended with ${status}:\n${error}")
endif()
