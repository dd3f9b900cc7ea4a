"""The robot as a checked model: kinematics, dynamics, bodies and their distances."""
