# What is not a program: headers, configuration, launch files, rviz, scripts.
