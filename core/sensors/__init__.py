"""Force/torque sensors that are read on a line of their own, one driver per file, and how their clocks go."""
