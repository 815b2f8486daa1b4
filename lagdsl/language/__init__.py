"""From a text to a flat model."""
