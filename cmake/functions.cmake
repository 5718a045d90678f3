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
  string(REPLACE "/" "_" NAME ${ROOM})
  file(GLOB TESTS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/${ROOM}/*_test.cc)
  if(NOT TESTS)
    return()
  endif()
  add_executable(${NAME}_test ${TESTS})
  rovio_compile_options(${NAME}_test)
  target_include_directories(${NAME}_test PRIVATE ${PROJECT_SOURCE_DIR}/test)
  target_compile_definitions(${NAME}_test PRIVATE ROVIO_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(${NAME}_test PRIVATE ${ARGN} GTest::gtest GTest::gtest_main)
  add_test(NAME ${NAME}_test COMMAND ${NAME}_test)
endfunction()

# rovio_program(NAME LINKS target...): the program NAME from src/nodes/NAME_main.cc, installed. Its
# target is NAME_program where a library has taken the name (rovio_sim).
function(rovio_program NAME)
  cmake_parse_arguments(ARG "" "" "LINKS" ${ARGN})
  set(PROGRAM ${NAME})
  if(TARGET ${NAME})
    set(PROGRAM ${NAME}_program)
  endif()
  add_executable(${PROGRAM} ${PROJECT_SOURCE_DIR}/src/nodes/${NAME}_main.cc)
  set_target_properties(${PROGRAM} PROPERTIES OUTPUT_NAME ${NAME})
  rovio_compile_options(${PROGRAM})
  target_link_libraries(${PROGRAM} PRIVATE ${ARG_LINKS})
  install(TARGETS ${PROGRAM} RUNTIME DESTINATION lib/${PROJECT_NAME})
endfunction()

function(rovio_compile_options TARGET)
  target_compile_options(${TARGET} PRIVATE -Wall -Wextra -Wshadow -Wconversion -Werror
                         $<$<CXX_COMPILER_ID:Clang>:-Wthread-safety>)
endfunction()
