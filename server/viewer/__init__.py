"""The cell in three dimensions, to look at only."""
