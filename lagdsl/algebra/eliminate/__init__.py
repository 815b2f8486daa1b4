"""Lagrange's equations solved while they are still expressions: elimination on the graph, the deepest first."""
