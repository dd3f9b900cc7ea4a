"""Rigid bodies at the wrist: inertial parameters (Eq. 1 to 4), the wrench they cause, shapes, uncertainty, comparison."""
