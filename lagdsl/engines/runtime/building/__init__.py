"""Compilers, and what is built with them."""
