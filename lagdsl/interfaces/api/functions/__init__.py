"""Motions as functions with derivatives."""
