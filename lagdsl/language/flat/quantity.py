"""Fields of every named or declared item of the flat model, measurements of such items, and annotations."""

from __future__ import annotations

from dataclasses import field, fields
from enum import StrEnum
from typing import Literal, TypeAlias, TypedDict, cast

from lagdsl.foundation.record import record
from lagdsl.foundation.source import Span
from lagdsl.foundation.units import Dimension

Spans: TypeAlias = tuple[Span, ...]
Base: TypeAlias = Literal["Real", "Integer", "Boolean", "String", "Enumeration"]


class Variability(StrEnum):
    CONSTANT = "constant"
    STRUCTURAL = "structural"
    PARAMETER = "parameter"
    DISCRETE = "discrete"
    CONTINUOUS = "continuous"


@record(kw_only=True)
class Item:
    spans: Spans = field(compare=False, repr=False)


@record(kw_only=True)
class Quantity(Item):
    """Fields of every named scalar. `unit` is the coherent SI unit as text, `display_unit` what the user wants to see,
    `symbol` how reports typeset the name (LaTeX). `base` is what its values are, `literals` the names of those of an
    enumeration, from 1, `literal_docs` their texts, `type_doc` that of the type. `protected`: its class does not show
    it."""

    name: str
    dimension: Dimension
    unit: str = "1"
    display_unit: str | None = None
    doc: str | None = None
    type_name: str = "Real"
    symbol: str | None = None
    base: Base = "Real"
    literals: tuple[str, ...] = ()
    literal_docs: tuple[str | None, ...] = ()
    type_doc: str | None = None
    protected: bool = False


MORE_THAN_A_TURN = 6.29
"""Radians; a turn as people round it is less."""


def is_angle(item: Quantity) -> bool:
    return item.type_name == "Angle" or item.unit == "rad"


class QuantityFields(TypedDict):
    """The fields of a Quantity, as arguments of one."""

    spans: Spans
    name: str
    dimension: Dimension
    unit: str
    display_unit: str | None
    doc: str | None
    type_name: str
    symbol: str | None
    base: Base
    literals: tuple[str, ...]
    literal_docs: tuple[str | None, ...]
    type_doc: str | None
    protected: bool


def fields_of(item: Quantity) -> QuantityFields:
    """The fields that a quantity shares with every other one, as arguments of a quantity of another kind."""
    return cast(QuantityFields, {each.name: getattr(item, each.name) for each in fields(Quantity)})


@record(kw_only=True)
class Measurement(Item):
    """Data have a column `name` with values of the result column `of`, or, of an `event`, with the instants at which
    something happens to the contact or friction of that name. `sigma` is their standard deviation, in SI units; None:
    it is not known. `stated`: the text gives the column a name of its own."""

    name: str
    of: str
    event: bool
    dimension: Dimension
    sigma: float | None
    stated: bool


@record(kw_only=True)
class Experiment:
    start_time: float = 0.0
    stop_time: float = 10.0
    tolerance: float = 1e-8
    interval: float | None = None
    stop_time_explicit: bool = False


@record(kw_only=True)
class Page:
    """Names of parameters, inputs, coordinates, rates for `sliders`, of columns of results for `curves`; none chooses
    the page itself."""

    sliders: tuple[str, ...] = ()
    curves: tuple[str, ...] = ()
