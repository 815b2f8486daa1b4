"""Kinematic assembly: ports get their frames, loops are closed."""
