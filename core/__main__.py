"""`python -m core` is `heft`."""

from core.command_line import main

main()
