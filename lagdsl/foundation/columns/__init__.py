"""Columns of numbers in CSV files, with units in the header."""
