"""Units and dimensions: exact algebra over SI exponents, and the vocabulary of unit names."""

from lagdsl.units.definition import UnitDefinition
from lagdsl.units.dimension import Dimension, dimension

__all__ = ["Dimension", "UnitDefinition", "dimension"]
