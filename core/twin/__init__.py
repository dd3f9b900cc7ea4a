"""What has been added to a cell's simulation: data, its file, and the model made of it."""
