"""Small dense numerics: rank, connected blocks, least squares."""
