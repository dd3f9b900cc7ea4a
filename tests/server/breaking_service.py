"""`heft` whose robots break while they move: how, their run's seed says. Run with `python -m`."""

from __future__ import annotations

from server.command_line import main
from server.runner import process

if __name__ == "__main__":
    process.CONTROL = "tests.server.breaking_robot"
    main()
