"""Motion: options, scales and words around a run of the C runtime."""
