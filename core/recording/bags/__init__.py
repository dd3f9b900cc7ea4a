"""Bags of ROS 2 and ROS 1 and MCAP files as tables, without ROS."""
