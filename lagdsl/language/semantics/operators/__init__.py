"""Operators and functions on values: arithmetic, arrays, geometry, tables."""
