"""The virtual robot: a MuJoCo arm, its joint controller, wrist sensor and encoders, and the imperfections that can be
planted in them.

It shares no code with estimation or with what diagnoses the gap.
"""
