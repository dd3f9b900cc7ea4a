"""Servers that speak the protocols of real controllers, moved by the virtual robot: for tests, and to try a driver without a robot."""
