"""Exit statuses of `lag`."""

SUCCESS = 0
ERRORS = 1  # diagnostics with errors
USAGE = 2  # wrong usage, unreadable file, unwritable output
FAILED_RUN = 3  # run-time failure of a simulation
INTERNAL = 70  # a fault of ours
INTERRUPTED = 130  # Ctrl-C
