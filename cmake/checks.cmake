# What the compiler does not check, as tests.
add_test(NAME check_layers COMMAND ${PROJECT_SOURCE_DIR}/scripts/check_layers)
add_test(NAME check_format COMMAND ${PROJECT_SOURCE_DIR}/scripts/check_format)
add_test(NAME check_docs COMMAND ${PROJECT_SOURCE_DIR}/scripts/check_docs)

# For sanitized builds: what the simulated robot makes of requests, without its renderer.
if(ROVIO_SANITIZE)
  set(PARSERS http_request parameters tcp_socket)
  list(TRANSFORM PARSERS APPEND .cc OUTPUT_VARIABLE PARSER_SOURCES)
  list(TRANSFORM PARSER_SOURCES PREPEND ${PROJECT_SOURCE_DIR}/src/sim/)
  list(TRANSFORM PARSERS APPEND _test.cc OUTPUT_VARIABLE PARSER_TESTS)
  list(TRANSFORM PARSER_TESTS PREPEND ${PROJECT_SOURCE_DIR}/test/sim/)
  add_executable(sim_parser_test ${PARSER_SOURCES} ${PARSER_TESTS})
  rovio_compile_options(sim_parser_test)
  target_include_directories(sim_parser_test PRIVATE ${PROJECT_SOURCE_DIR}/test)
  target_link_libraries(sim_parser_test PRIVATE rovio_geometry GTest::gtest GTest::gtest_main)
  add_test(NAME sim_parser_test COMMAND sim_parser_test)
endif()

# One seeded benchmark per stage: test/benchmark/STAGE_benchmark.cc, all in one program (not a test).
file(GLOB BENCHMARKS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/benchmark/*_benchmark.cc)
if(BENCHMARKS)
  add_executable(benchmarks ${BENCHMARKS})
  rovio_compile_options(benchmarks)
  target_include_directories(benchmarks PRIVATE ${PROJECT_SOURCE_DIR}/test)
  target_compile_definitions(benchmarks PRIVATE ROVIO_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  target_link_libraries(benchmarks PRIVATE rovio_pipeline rovio_synthetic benchmark::benchmark_main)
endif()

# The nodes, each against its neighbours over a real master: test/ros/*.test. Wiring only.
if(ROVIO_WITH_ROS)
  find_package(rostest REQUIRED)
  file(GLOB ROSTESTS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/ros/*.test)
  foreach(ROSTEST ${ROSTESTS})
    add_rostest(${ROSTEST})
  endforeach()
  find_package(roslaunch REQUIRED)
  roslaunch_add_file_check(launch IGNORE_UNSET_ARGS)
endif()
