"""Engines: programs made callable as a lag_model."""
