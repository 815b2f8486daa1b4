"""Fits as pages."""
