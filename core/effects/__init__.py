"""What the nominal model leaves out, one effect per file. The folder is the registry."""
