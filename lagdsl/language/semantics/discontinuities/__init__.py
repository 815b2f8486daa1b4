"""Jumps and bends along the motion, and what the runtime does there."""
