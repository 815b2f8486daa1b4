"""Dependencies between the numbers of a program, without those that cancel."""
