"""What drives a motion and what comes of it, as functions of time: inputs, trajectories, and their files."""
