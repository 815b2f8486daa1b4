"""Inputs as callers give them: of one motion, of each run, as axes of a sweep."""
