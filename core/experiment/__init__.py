"""The next motion: planned like any other, kept in a file, carried out, and appended to the recording that asked for it."""
