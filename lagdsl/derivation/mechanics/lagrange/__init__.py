"""Lagrange's equations on the graph: energies, inertia, loads."""
