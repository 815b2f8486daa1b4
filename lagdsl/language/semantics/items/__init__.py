"""Statements of physics: bodies, loads, constraints, contacts, drawings."""
