"""Frames, points, outputs and forces of friction of a model in lists of their own."""

from __future__ import annotations

from lagdsl.foundation.units.dimension import ENERGY, POWER
from lagdsl.foundation.units.naming import unit_text
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.events import Friction
from lagdsl.language.flat.model import FlatModel, Frame, Output, Point, RateForce


def frame_names(flat: FlatModel) -> list[str]:
    """In the order of their definition, without the world."""
    return [item.name for item in flat.named if isinstance(item, Frame)]


def point_names(flat: FlatModel) -> list[str]:
    """In the order of their definition."""
    return [item.name for item in flat.named if isinstance(item, Point)]


def discrete_outputs(flat: FlatModel) -> tuple[str, ...]:
    """Names of the discrete variables that are declared `output`: they stand among both, under one name."""
    outputs = {item.name for item in flat.outputs}
    return tuple(item.name for item in flat.events.discretes if item.name in outputs)


def computed_outputs(flat: FlatModel) -> tuple[Output, ...]:
    """All other outputs."""
    discrete = frozenset(discrete_outputs(flat))
    return tuple(item for item in flat.outputs if item.name not in discrete)


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
