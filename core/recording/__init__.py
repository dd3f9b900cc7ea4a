"""A recording: samples with their phases and what is known of robot and sensor, as a folder of files."""
