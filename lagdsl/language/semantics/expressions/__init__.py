"""Expressions: references, calls, functions of mechanics."""
