"""Attributes of variables from what the flat model says of quantities."""

from __future__ import annotations

import math
from typing import TypedDict

from lagdsl.exchange.fmi.variables.scalar import Attributes, Role, Type
from lagdsl.foundation.units.dimension import TIME
from lagdsl.foundation.units.naming import rate_text
from lagdsl.foundation.units.parse import UnknownUnit, parse_unit
from lagdsl.language.flat.events import Discrete
from lagdsl.language.flat.model import Coordinate, Input, Output, Parameter, State
from lagdsl.language.flat.quantity import Base, Quantity

_NUMBER = "1"
_TYPES: dict[Base, Type] = {
    "Real": "REAL",
    "Integer": "INTEGER",
    "Boolean": "BOOLEAN",
    "String": "STRING",
    "Enumeration": "ENUMERATION",
}


class Bounds(TypedDict):
    """Smallest and largest value; None: without bound."""

    minimum: float | None
    maximum: float | None


def attributes_of(item: Quantity, role: Role) -> Attributes:
    """Attributes of every quantity. Only Reals have units; a type of its own is known by name."""
    real = item.base == "Real"
    return Attributes(
        role=role,
        type=_TYPES[item.base],
        unit=(item.unit or _NUMBER) if real else None,
        display_unit=item.display_unit if real and item.display_unit != item.unit else None,
        doc=item.doc,
        type_name=None if item.type_name == item.base else item.type_name,
        literals=item.literals,
        literal_docs=item.literal_docs,
        type_doc=item.type_doc,
    )


def bounds(item: Parameter | Coordinate | State | Discrete | Input | Output, start: float | None) -> Bounds:
    """The finite bounds that contain the start value: the standard permits no others."""
    low, high = item.minimum, item.maximum
    if low is not None and (not math.isfinite(low) or (start is not None and not low <= start)):
        low = None
    if high is not None and (not math.isfinite(high) or (start is not None and not start <= high)):
        high = None
    return {"minimum": low, "maximum": high}


def rate_units(item: Quantity, order: int) -> tuple[str, str | None]:
    """Unit and display unit of the `order`-th time derivative: `rad`, `deg` gives `rad/s2`, `deg/s2`."""
    unit, dimension = item.unit or _NUMBER, item.dimension
    for _ in range(order):
        unit, dimension = rate_text(dimension, unit), dimension / TIME
    shown = item.display_unit
    if shown is None or shown == item.unit:
        return unit, None
    display_unit = f"{shown}/s{'' if order == 1 else order}"
    try:
        definition = parse_unit(display_unit)
    except UnknownUnit:
        return unit, None
    return unit, display_unit if definition.dimension == dimension and not definition.shift else None
