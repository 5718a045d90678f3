# Every library of the system that any target uses; scripts/install_dependencies installs them.
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(OpenCV REQUIRED COMPONENTS core imgproc imgcodecs features2d flann calib3d video)
find_package(Ceres REQUIRED)
find_package(CURL REQUIRED)
find_package(ZLIB REQUIRED)
find_package(JPEG REQUIRED)
find_package(embree 3 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(GTest REQUIRED)
find_package(benchmark REQUIRED)
find_package(nlohmann_json 3 REQUIRED)
pkg_check_modules(YAMLCPP REQUIRED IMPORTED_TARGET yaml-cpp)
pkg_check_modules(SQLITE3 REQUIRED IMPORTED_TARGET sqlite3)
pkg_check_modules(DLIB REQUIRED IMPORTED_TARGET dlib-1)
pkg_check_modules(OPENBLAS REQUIRED IMPORTED_TARGET openblas)
if(ROVIO_WITH_ROS)
  # catkin remembers, for node tests, the folders that exist now: that of our Python messages too.
  if(NOT CATKIN_DEVEL_PREFIX)
    set(CATKIN_DEVEL_PREFIX ${PROJECT_BINARY_DIR}/devel)
  endif()
  file(MAKE_DIRECTORY ${CATKIN_DEVEL_PREFIX}/lib/python3/dist-packages)
  find_package(catkin REQUIRED COMPONENTS
    actionlib camera_info_manager cv_bridge diagnostic_updater dynamic_reconfigure geometry_msgs
    image_transport message_generation nav_msgs rosbag roscpp sensor_msgs std_msgs tf2_eigen
    tf2_geometry_msgs tf2_ros visualization_msgs)
endif()
