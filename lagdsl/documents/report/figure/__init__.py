"""The drawing of the system in a derivation: its parts, coordinates, loads and admissible motions where it starts."""
