"""Vectors, frames, poses, velocities and accelerations."""
