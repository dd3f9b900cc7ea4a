"""Robot sessions, one driver per file."""
