# What the compiler does not check, as tests.
add_test(NAME check_layers COMMAND ${PROJECT_SOURCE_DIR}/scripts/check_layers)
add_test(NAME check_layers_test COMMAND ${PROJECT_SOURCE_DIR}/test/scripts/check_layers_test.py)
add_test(NAME shell_test COMMAND ${PROJECT_SOURCE_DIR}/test/scripts/shell_test.py)
add_test(NAME read_plainly_test COMMAND ${PROJECT_SOURCE_DIR}/test/scripts/read_plainly_test.py)
add_test(NAME check_format COMMAND ${PROJECT_SOURCE_DIR}/scripts/check_format)
add_test(NAME check_docs COMMAND ${PROJECT_SOURCE_DIR}/scripts/check_docs)

foreach(SCRIPT demo expected_error stamp_delay teleop_keys workspace)
  add_test(NAME ${SCRIPT}_test COMMAND ${PROJECT_SOURCE_DIR}/test/scripts/${SCRIPT}_test.py)
endforeach()

# In sanitized builds: what reads untrusted bytes (the robot's replies, requests to the simulated one,
# files), with its tests and no more than it needs, so that the build takes a minute.
if(ROVIO_SANITIZE STREQUAL "address")
  set(PARSERS rovio/mjpeg_parser util/jpeg_check rovio/rovio_protocol rovio/header_value
              sim/http/http_request sim/http/parameters sim/http/tcp_socket io/text_file io/odometry_file
              io/trajectory_file io/dataset_folder io/calibration util/load_document geometry/check_calibration)
  set(PARSER_SOURCES util/check util/check_options util/log util/option_text util/rng geometry/camera ${PARSERS})
  list(TRANSFORM PARSER_SOURCES REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/src/\\1.cc")
  list(TRANSFORM PARSERS REPLACE "(.+)" "${PROJECT_SOURCE_DIR}/test/\\1_test.cc")
  rovio_test_program(parser_test SOURCES ${PARSER_SOURCES} ${PARSERS}
                     LINKS Eigen3::Eigen ${OPENCV} PkgConfig::YAMLCPP JPEG::JPEG GTest::gtest GTest::gtest_main)
  target_compile_options(rovio_sfm_parser_test PRIVATE -O0)
  target_include_directories(rovio_sfm_parser_test PRIVATE ${PROJECT_SOURCE_DIR}/include
                                                           ${PROJECT_SOURCE_DIR}/test)
  target_compile_definitions(rovio_sfm_parser_test PRIVATE ROVIO_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  add_test(NAME parser_test COMMAND rovio_sfm_parser_test)
endif()

# One seeded benchmark per stage: test/benchmark/STAGE_benchmark.cc, all in one program (not a test).
file(GLOB BENCHMARKS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/benchmark/*_benchmark.cc)
rovio_test_program(benchmarks SOURCES ${BENCHMARKS}
                   LINKS rovio_app rovio_synthetic benchmark::benchmark_main)
# What a benchmark of one function cannot show: costs as a drive, or the number of drives, grows.
foreach(PROGRAM picture_cost many_merges long_drive)
  rovio_test_program(${PROGRAM} SOURCES ${PROJECT_SOURCE_DIR}/test/benchmark/${PROGRAM}.cc
                     LINKS rovio_app rovio_synthetic)
endforeach()

# Every program, started wrongly.
if(ROVIO_WITH_ROS)
  add_test(NAME program_refusals_test
           COMMAND ${CATKIN_DEVEL_PREFIX}/env.sh
                   ${PROJECT_SOURCE_DIR}/test/scripts/program_refusals_test.py
                   ${CATKIN_DEVEL_PREFIX}/lib/${PROJECT_NAME})
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
