"""Named functions over one graph, ready for a backend."""
