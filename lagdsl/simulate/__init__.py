"""Motion: consistent starts, steppers, projection, trajectories."""
