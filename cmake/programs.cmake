# One program per src/nodes/NAME_main.cc. Nodes and bag tools need ROS; the rest does not.
