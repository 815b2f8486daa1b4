"""Expressions as a graph, and linear systems in them."""
