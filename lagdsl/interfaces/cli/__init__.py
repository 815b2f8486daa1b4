"""The command `lag`: one command, one file."""
