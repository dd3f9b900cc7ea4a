"""Makes a cell from a robot as it comes: URDF or xacro, with meshes in ROS packages."""
