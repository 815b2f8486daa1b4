"""Programs that run: generated modules, the C runtime."""
