"""The `heft` command: one file per family of subcommands, and what it prints."""
