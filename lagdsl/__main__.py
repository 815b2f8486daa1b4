"""`python -m lagdsl` is the command `lag`."""

from lagdsl.cli.main import main

main()
