"""Doors: Python, the command line, editors, notebooks."""
