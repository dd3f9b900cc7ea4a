"""The payload from the torques of the joints, for robots without a wrist sensor."""
