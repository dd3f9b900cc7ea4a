"""What has been added to a cell's simulation, as plain data, its file, and the model made of it."""
