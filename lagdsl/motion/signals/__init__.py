"""Inputs and results of a motion as functions of time: inputs, trajectories, and their files."""
