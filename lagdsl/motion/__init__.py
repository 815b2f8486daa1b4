"""From a text to a motion: the pipeline, simulation, small motions, sweeps."""
