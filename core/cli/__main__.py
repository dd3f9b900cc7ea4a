"""`python -m core.cli` is `heft`."""

from core.cli.main import main

main()
