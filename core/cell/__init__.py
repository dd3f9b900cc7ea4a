"""A robot cell: what cell.toml and its URDF say of the robot, the sensor, tools, payloads, obstacles and protected zones."""
