"""Motions by steps: one or many in the hands of a caller, saved and restored."""
