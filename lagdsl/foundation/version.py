"""The version of the package, below all floors: what is written says by which version."""

__version__ = "0.1.0"
