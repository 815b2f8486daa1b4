"""When clauses, resets and functions of events."""
