# The rooms, bottom to top: each is a library that may include what it links, and nothing else.
set(OPENCV ${OpenCV_LIBS})

rovio_library(util LINKS Threads::Threads Eigen3::Eigen PkgConfig::OPENBLAS PkgConfig::YAMLCPP JPEG::JPEG
                   ZLIB::ZLIB CLI11::CLI11)
# Its loops over bytes are vectorised from O3 on.
set_source_files_properties(${PROJECT_SOURCE_DIR}/src/util/byte_products.cc PROPERTIES
                            COMPILE_OPTIONS $<$<CONFIG:Release>:-O3>)
rovio_library(geometry LINKS rovio_util Eigen3::Eigen ceres ${OPENCV} TEST_LINKS rovio_synthetic)
rovio_library(scene LINKS rovio_geometry TEST_LINKS rovio_synthetic)

# A synthetic world for the tests of every layer above scene.
file(GLOB SYNTHETIC CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/test/synthetic/*.cc)
list(FILTER SYNTHETIC EXCLUDE REGEX "_test\\.cc$")
if(SYNTHETIC AND CATKIN_ENABLE_TESTING)
  add_library(rovio_synthetic STATIC ${SYNTHETIC})
  rovio_compile_options(rovio_synthetic)
  target_include_directories(rovio_synthetic PUBLIC ${PROJECT_SOURCE_DIR}/test)
  target_link_libraries(rovio_synthetic PUBLIC rovio_scene)
else()
  add_library(rovio_synthetic INTERFACE)
  target_link_libraries(rovio_synthetic INTERFACE rovio_scene)
endif()
rovio_test(synthetic rovio_synthetic)

rovio_library(rovio    LINKS rovio_scene CURL::libcurl)
rovio_library(features LINKS rovio_scene ${OPENCV} PkgConfig::DLIB TEST_LINKS rovio_synthetic)
rovio_library(matching LINKS rovio_scene ${OPENCV} TEST_LINKS rovio_synthetic rovio_features)
rovio_library(tracks   LINKS rovio_scene TEST_LINKS rovio_synthetic)
rovio_library(sfm      LINKS rovio_scene ceres ${OPENCV} TEST_LINKS rovio_synthetic)
rovio_library(places   LINKS rovio_scene TEST_LINKS rovio_synthetic)
rovio_library(sessions LINKS rovio_scene ceres TEST_LINKS rovio_synthetic)
rovio_library(dense    LINKS rovio_scene ${OPENCV} TEST_LINKS rovio_synthetic)
rovio_library(surface  LINKS rovio_scene PkgConfig::PCL TEST_LINKS rovio_synthetic)
rovio_library(io       LINKS rovio_scene ${OPENCV} PkgConfig::YAMLCPP PkgConfig::SQLITE3 TEST_LINKS rovio_synthetic)

# From one drive's images to maps: each room knows the steps, and the rooms above it.
set(STEPS rovio_features rovio_matching rovio_tracks rovio_sfm rovio_places rovio_sessions rovio_io)
rovio_library(frontend    LINKS ${STEPS} TEST_LINKS rovio_synthetic)
rovio_library(recognition LINKS ${STEPS} TEST_LINKS rovio_synthetic)
rovio_library(mapping     LINKS ${STEPS} TEST_LINKS rovio_synthetic)
rovio_library(merging     LINKS rovio_mapping TEST_LINKS rovio_synthetic)
rovio_library(report      LINKS ${STEPS} nlohmann_json::nlohmann_json TEST_LINKS rovio_synthetic)
rovio_library(finish      LINKS ${STEPS} rovio_dense rovio_surface TEST_LINKS rovio_synthetic)
rovio_library(app         LINKS rovio_frontend rovio_recognition rovio_merging rovio_finish
                                rovio_report rovio_rovio TEST_LINKS rovio_synthetic)
rovio_library(tools/trajectory LINKS rovio_app nlohmann_json::nlohmann_json TEST_LINKS rovio_synthetic)
rovio_library(tools       LINKS rovio_tools_trajectory nlohmann_json::nlohmann_json TEST_LINKS rovio_synthetic)
if(ROVIO_WITH_ROS)
  rovio_library(ros       LINKS rovio_app ${catkin_LIBRARIES} PkgConfig::HTTPLIB TEST_LINKS rovio_synthetic)
  add_dependencies(rovio_ros ${PROJECT_NAME}_generate_messages_cpp)  # no other language
endif()

# The simulated robot stands apart and shares nothing with rovio/, but that a tour's odometry is what
# the driver makes of the ticks.
rovio_library(sim/world LINKS rovio_geometry embree PkgConfig::YAMLCPP ${OPENCV}
                        TEST_LINKS rovio_sim_robot)
rovio_library(sim/robot LINKS rovio_sim_world)
rovio_library(sim/tour  LINKS rovio_sim_robot rovio_rovio)
rovio_library(sim/http  LINKS rovio_sim_robot)
rovio_library(sim       LINKS rovio_sim_tour rovio_sim_http)
