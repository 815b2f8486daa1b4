"""FMUs: models as other tools run them, by the standards FMI 2.0 and FMI 3.0."""
