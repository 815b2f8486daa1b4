"""The scalable derivation: Lagrange's equations on the expression graph."""
