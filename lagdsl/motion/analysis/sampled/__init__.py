"""Sampled loops: a model with clocks, linearized over the common period of their ticks."""
