"""Types, dimensions, prefixes: what a declaration says of a quantity."""
