"""The report of one identification as a single HTML file."""
