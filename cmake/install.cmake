# What is not a program: headers, configuration, launch files, rviz, scripts.
set(SHARE share/${PROJECT_NAME})
install(DIRECTORY include/${PROJECT_NAME} DESTINATION include FILES_MATCHING PATTERN "*.h")
foreach(FOLDER config launch rviz)
  if(EXISTS ${PROJECT_SOURCE_DIR}/${FOLDER})
    install(DIRECTORY ${FOLDER} DESTINATION ${SHARE})
  endif()
endforeach()
install(PROGRAMS scripts/record_inputs scripts/plot_map.py scripts/plot_places.py DESTINATION lib/${PROJECT_NAME})
if(NOT ROVIO_WITH_ROS)  # catkin_package() does it otherwise
  install(FILES package.xml DESTINATION ${SHARE})
endif()
