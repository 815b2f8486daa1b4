"""The XML and C descriptions of an FMU."""
