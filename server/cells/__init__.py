"""The cells on this machine: their folder, uploads and what is checked of them, protected zones as they stand now, twins; their routes."""
