"""How the robot is moved: test motions, Saturation in the Null Space, the guard, and the one control loop."""
