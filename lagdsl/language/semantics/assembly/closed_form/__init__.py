"""Closed forms of placements: the algebra of poses, and their inverses."""
