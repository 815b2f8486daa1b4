"""The flat model: what the semantics makes of a text, and all that is derived from reads."""
