# What the compiler does not check, as tests.
add_test(NAME check_layers COMMAND ${PROJECT_SOURCE_DIR}/scripts/check_layers)
add_test(NAME check_format COMMAND ${PROJECT_SOURCE_DIR}/scripts/check_format)

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
