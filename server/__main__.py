"""`python -m server` is `heft`."""

from server.command_line import main

main()
