# What every target of flownav shares.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

# Programs load only the libraries they use, and find the modules that they load later.
add_link_options(-Wl,--as-needed)
set(FLOWNAV_MODULE_DIR ${PROJECT_BINARY_DIR}/lib)
set(CMAKE_BUILD_RPATH ${FLOWNAV_MODULE_DIR})
set(CMAKE_INSTALL_RPATH $ORIGIN/../${CMAKE_INSTALL_LIBDIR})

find_program(FLOWNAV_CCACHE ccache)
if(FLOWNAV_CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${FLOWNAV_CCACHE})
endif()

# -ffp-contract=off: the same numbers on every machine, with or without fused multiply-add.
add_library(flownav_options INTERFACE)
target_compile_options(flownav_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                                                 -Wconversion -Wno-sign-conversion -Werror -ffp-contract=off)
if(FLOWNAV_SANITIZE)
    set(FLOWNAV_SANITIZERS address,undefined)
    if(FLOWNAV_SANITIZE STREQUAL "thread")
        set(FLOWNAV_SANITIZERS thread)
    endif()
    add_compile_options(-fsanitize=${FLOWNAV_SANITIZERS} -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${FLOWNAV_SANITIZERS})
    # Their dlopen() stands between a program and its modules, and knows no RUNPATH but its own.
    add_link_options(-Wl,--disable-new-dtags)
endif()
if(FLOWNAV_TIDY)
    find_program(FLOWNAV_CLANG_TIDY clang-tidy REQUIRED)
    set(CMAKE_CXX_CLANG_TIDY ${FLOWNAV_CLANG_TIDY} --quiet --extra-arg=-Wno-unknown-warning-option)
endif()

# flownav_library(NAME core [SOURCES a.cpp ...] LINKS target ... [PRIVATE_LINKS target ...]) makes flownav::core. Without
# sources it is a library of headers.
function(flownav_library)
    cmake_parse_arguments(LIB "" "NAME" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
    set(scope PUBLIC)
    if(LIB_SOURCES)
        add_library(flownav_${LIB_NAME} STATIC ${LIB_SOURCES})
        target_link_libraries(flownav_${LIB_NAME} PRIVATE ${LIB_PRIVATE_LINKS} $<BUILD_INTERFACE:flownav_options>)
    else()
        add_library(flownav_${LIB_NAME} INTERFACE)
        set(scope INTERFACE)
    endif()
    add_library(flownav::${LIB_NAME} ALIAS flownav_${LIB_NAME})
    target_include_directories(flownav_${LIB_NAME} ${scope} $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>
                                                            $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_libraries(flownav_${LIB_NAME} ${scope} ${LIB_LINKS})
    target_compile_features(flownav_${LIB_NAME} ${scope} cxx_std_17)
    set_target_properties(flownav_${LIB_NAME} PROPERTIES EXPORT_NAME ${LIB_NAME} OUTPUT_NAME flownav-${LIB_NAME})
    install(TARGETS flownav_${LIB_NAME} EXPORT flownavTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
                                                              LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/include)
        install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    endif()
    set_property(GLOBAL APPEND PROPERTY FLOWNAV_COMPONENTS ${LIB_NAME})
endfunction()

# flownav_app(NAME replay SOURCES main.cpp ... LINKS target ...) makes the program flownav-replay.
function(flownav_app)
    cmake_parse_arguments(APP "" "NAME" "SOURCES;LINKS" ${ARGN})
    add_executable(flownav-${APP_NAME} ${APP_SOURCES})
    target_link_libraries(flownav-${APP_NAME} PRIVATE ${APP_LINKS} flownav::cli flownav_options)
    install(TARGETS flownav-${APP_NAME} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
    set_property(GLOBAL APPEND PROPERTY FLOWNAV_APPS ${APP_NAME})
endfunction()

# flownav_test(NAME flow LABEL unit [THREADS] SOURCES a_unittest.cpp ... LINKS target ...) makes one GoogleTest program.
# Its files below ::testing::TempDir() lie in the build folder, where no other run meets them. THREADS: what it tests
# starts threads; the target thread_tests builds all of these, their label is "threads". With a sanitizer a program is
# one test, because the start of a process and what its tests share cost more than the tests; else every TEST is one.
add_custom_target(thread_tests)
function(flownav_test)
    cmake_parse_arguments(TEST "THREADS" "NAME;LABEL" "SOURCES;LINKS" ${ARGN})
    set(labels ${TEST_LABEL})
    if(TEST_THREADS)
        set(labels threads)
        add_dependencies(thread_tests ${TEST_LABEL}_${TEST_NAME})
    endif()
    add_executable(${TEST_LABEL}_${TEST_NAME} ${TEST_SOURCES})
    target_link_libraries(${TEST_LABEL}_${TEST_NAME} PRIVATE ${TEST_LINKS} GTest::gtest_main flownav_options)
    set(properties LABELS ${labels} ENVIRONMENT TEST_TMPDIR=${PROJECT_BINARY_DIR}/tmp)
    if(FLOWNAV_SANITIZE)
        add_test(NAME ${TEST_LABEL}_${TEST_NAME} COMMAND ${TEST_LABEL}_${TEST_NAME})
        set_tests_properties(${TEST_LABEL}_${TEST_NAME} PROPERTIES ${properties} TIMEOUT 1800)
    else()
        gtest_discover_tests(${TEST_LABEL}_${TEST_NAME} DISCOVERY_TIMEOUT 60 PROPERTIES ${properties} TIMEOUT 600)
    endif()
    file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/tmp)
endfunction()
