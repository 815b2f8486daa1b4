"""The force of dry friction: its expressions, its unit."""

from __future__ import annotations

from lagdsl.flat import expression as fx
from lagdsl.flat.events import Friction
from lagdsl.flat.model import FlatModel, RateForce
from lagdsl.units.dimension import ENERGY, POWER
from lagdsl.units.naming import unit_text


def forces_of(flat: FlatModel, friction: Friction) -> tuple[fx.FlatExpression, ...]:
    """The force along each slip: that of the rows while it sticks, which is zero else, and the load while it slides,
    which is zero else."""
    sliding = (each.value for each in flat.loads if isinstance(each, RateForce) and each.label == friction.name)
    rows = zip(friction.rows, sliding, strict=True)
    return tuple(fx.Binary("+", fx.Multiplier(row), load) for row, load in rows)


def force_unit(friction: Friction) -> str:
    """Coherent SI unit of the force; along an angular velocity it is a moment."""
    dimension = POWER / friction.dimension
    return "N.m" if dimension == ENERGY else unit_text(dimension)
