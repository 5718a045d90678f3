# One program per src/nodes/NAME_main.cc. Nodes and bag tools need ROS; the rest does not.
rovio_program(evaluate_trajectory LINKS rovio_tools_trajectory)
rovio_program(evaluate_places LINKS rovio_tools)
if(ROVIO_WITH_ROS)
  rovio_program(images_to_bag LINKS rovio_ros)
  rovio_program(frontend LINKS rovio_ros)
  rovio_program(mapping LINKS rovio_ros)
  rovio_program(place_recognition LINKS rovio_ros)
  rovio_program(replay LINKS rovio_ros)
  rovio_program(tf_inputs LINKS rovio_ros)
  rovio_program(rovio_driver LINKS rovio_ros)
  rovio_program(drive_tour LINKS rovio_ros)
  rovio_program(map_web LINKS rovio_ros)
endif()
rovio_program(rovio_sim LINKS rovio_sim)
rovio_program(calibrate_camera LINKS rovio_tools)
rovio_program(measure_noise LINKS rovio_tools)
rovio_program(map_images LINKS rovio_tools)
rovio_program(map_tool LINKS rovio_tools)
rovio_program(train_places LINKS rovio_tools)

# What scripts/demo needs, and no more.
if(ROVIO_WITH_ROS)
  add_custom_target(rovio_sfm_demo)
  add_dependencies(rovio_sfm_demo rovio_sfm_rovio_sim rovio_sfm_rovio_driver rovio_sfm_drive_tour
                   rovio_sfm_frontend rovio_sfm_mapping rovio_sfm_place_recognition
                   rovio_sfm_evaluate_trajectory rovio_sfm_generate_messages_py)
endif()
