"""Events: located on the dense output, iterated to a fixed point, impacts solved (docs/adr/0030-events.md)."""
