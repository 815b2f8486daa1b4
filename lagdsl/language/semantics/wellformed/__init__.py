"""Physics that can be checked on the flat model alone."""
