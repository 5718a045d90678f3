# rovio_library(ROOM LINKS target...): the static library rovio_ROOM from src/ROOM/*.cc, and, from
# test/ROOM/*_test.cc, the GoogleTest program ROOM_test; a / in ROOM becomes _. The link list is the
# layer rule.
function(rovio_library ROOM)
  cmake_parse_arguments(ARG "" "" "LINKS;TEST_LINKS" ${ARGN})
  string(REPLACE "/" "_" NAME ${ROOM})
  file(GLOB SOURCES CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${ROOM}/*.cc)
  if(SOURCES)
    add_library(rovio_${NAME} STATIC ${SOURCES})
    rovio_compile_options(rovio_${NAME})
    target_include_directories(rovio_${NAME} PUBLIC ${PROJECT_SOURCE_DIR}/include)
    target_link_libraries(rovio_${NAME} PUBLIC ${ARG_LINKS})
  else()
    add_library(rovio_${NAME} INTERFACE)
    target_include_directories(rovio_${NAME} INTERFACE ${PROJECT_SOURCE_DIR}/include)
    target_link_libraries(rovio_${NAME} INTERFACE ${ARG_LINKS})
  endif()
  rovio_test(${ROOM} rovio_${NAME} ${ARG_TEST_LINKS})
endfunction()

# rovio_test(ROOM target...): the GoogleTest program ROOM_test from test/ROOM/*_test.cc.
function(rovio_test ROOM)
  if(NOT CATKIN_ENABLE_TESTING)
    return()
  endif()
  string(REPLACE "/" "_" NAME ${ROOM})
  file(GLOB TESTS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/${ROOM}/*_test.cc)
  if(NOT TESTS)
    return()
  endif()
  rovio_test_program(${NAME}_test SOURCES ${TESTS} LINKS ${ARGN} GTest::gtest GTest::gtest_main)
  add_test(NAME ${NAME}_test COMMAND ${PROJECT_NAME}_${NAME}_test)
endfunction()

# rovio_test_program(NAME SOURCES file... LINKS target...): a program for us alone, built by `tests`.
function(rovio_test_program NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  set(PROGRAM ${PROJECT_NAME}_${NAME})
  add_executable(${PROGRAM} EXCLUDE_FROM_ALL ${ARG_SOURCES})
  set_target_properties(${PROGRAM} PROPERTIES OUTPUT_NAME ${NAME})
  rovio_compile_options(${PROGRAM})
  target_include_directories(${PROGRAM} PRIVATE ${PROJECT_SOURCE_DIR}/test)
  target_compile_definitions(${PROGRAM} PRIVATE ROVIO_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(${PROGRAM} PRIVATE ${ARG_LINKS})
  add_dependencies(tests ${PROGRAM})
endfunction()

# rovio_program(NAME LINKS target...): the program NAME from src/nodes/NAME_main.cc, installed. Its
# target is rovio_sfm_NAME: a catkin workspace has one name space of targets.
function(rovio_program NAME)
  cmake_parse_arguments(ARG "" "" "LINKS" ${ARGN})
  set(PROGRAM ${PROJECT_NAME}_${NAME})
  add_executable(${PROGRAM} ${PROJECT_SOURCE_DIR}/src/nodes/${NAME}_main.cc)
  set_target_properties(${PROGRAM} PROPERTIES OUTPUT_NAME ${NAME})
  rovio_compile_options(${PROGRAM})
  target_link_libraries(${PROGRAM} PRIVATE ${ARG_LINKS})
  install(TARGETS ${PROGRAM} RUNTIME DESTINATION lib/${PROJECT_NAME})
endfunction()

# Developers see every warning; users' compilers, newer than ours, know warnings that we do not.
# Installed programs hold no path of the folder they were built in.
function(rovio_compile_options TARGET)
  if(ROVIO_SFM_DEVELOPER)
    target_compile_options(${TARGET} PRIVATE -Wall -Wextra -Wshadow -Wconversion -Werror
                           $<$<CXX_COMPILER_ID:Clang>:-Wthread-safety>)
  else()
    target_compile_options(${TARGET} PRIVATE -Wall)
  endif()
  if(NOT ROVIO_SFM_DEVELOPER OR NOT ROVIO_SFM_CCACHE)  # scripts/environment's ccache does likewise
    target_compile_options(${TARGET} PRIVATE -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=)
  endif()
endfunction()
