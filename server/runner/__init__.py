"""A run in processes of its own: one that controls the robot, one that plans, and the server's end of the pipe."""
