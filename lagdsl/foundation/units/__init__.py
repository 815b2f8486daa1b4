"""Units and dimensions: exact algebra over SI exponents, and the vocabulary of unit names."""

from lagdsl.foundation.units.definition import UnitDefinition
from lagdsl.foundation.units.dimension import Dimension, dimension

__all__ = ["Dimension", "UnitDefinition", "dimension"]
