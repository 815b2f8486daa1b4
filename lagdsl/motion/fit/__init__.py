"""Parameters and start values from measured motions."""
