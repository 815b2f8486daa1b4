"""The variables of an FMU."""
