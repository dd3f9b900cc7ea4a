"""What the robot is going to do: start configurations, paths, timing, torques, and the plan as a list of stops."""
