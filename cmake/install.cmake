# What is not a program: configuration, launch files, rviz, scripts. The libraries are the package's
# own, and so are their headers: neither is installed.
set(SHARE share/${PROJECT_NAME})
foreach(FOLDER config launch rviz)
  if(EXISTS ${PROJECT_SOURCE_DIR}/${FOLDER})
    install(DIRECTORY ${FOLDER} DESTINATION ${SHARE})
  endif()
endforeach()
install(PROGRAMS scripts/plot_map.py scripts/plot_places.py scripts/record_inputs scripts/run_demo.py
                 scripts/teleop
        DESTINATION lib/${PROJECT_NAME})
install(FILES scripts/read_plainly.py scripts/demo_graph.py scripts/demo_pictures.py scripts/demo_services.py
              scripts/teleop_keys.py DESTINATION lib/${PROJECT_NAME})
if(NOT ROVIO_WITH_ROS)  # catkin_package() does it otherwise
  install(FILES package.xml DESTINATION ${SHARE})
endif()
