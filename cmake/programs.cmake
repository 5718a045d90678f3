# One program per src/nodes/NAME_main.cc. Nodes and bag tools need ROS; the rest does not.
rovio_program(evaluate_trajectory LINKS rovio_tools)
