# One program per src/nodes/NAME_main.cc. Nodes and bag tools need ROS; the rest does not.
rovio_program(evaluate_trajectory LINKS rovio_tools)
if(ROVIO_WITH_ROS)
  rovio_program(images_to_bag LINKS rovio_ros)
endif()
rovio_program(rovio_sim LINKS rovio_sim)
rovio_program(calibrate_camera LINKS rovio_tools)
rovio_program(measure_noise LINKS rovio_tools)
