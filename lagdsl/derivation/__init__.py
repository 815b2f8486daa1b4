"""From a flat model to a program: mechanics, structure, the textbook's way, the scene."""
