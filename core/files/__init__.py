"""Files from outside: kept inside their folder, written whole or not at all, read in a process with limits."""
