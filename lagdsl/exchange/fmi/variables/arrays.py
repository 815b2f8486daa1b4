"""Numbers of one array become one variable, where a version of FMI has arrays."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from itertools import groupby

from lagdsl.exchange.fmi.variables.scalar import Initial, Scalar, Variable


def grouped(scalars: Sequence[Scalar], *, arrays: bool) -> tuple[Variable, ...]:
    """Variables in the order of the numbers. An array is made of numbers that stand one after the other, also where
    they are kept, have the same attributes and fill it, and only if no other number has its name."""
    runs = _runs(scalars) if arrays else [[scalar] for scalar in scalars]
    times = Counter((run[0].name.path, run[0].name.order) for run in runs)
    parts = []
    for run in runs:
        shape = _shape(run) if arrays and times[run[0].name.path, run[0].name.order] == 1 else None
        parts += [_array(run, shape)] if shape else [_single(scalar) for scalar in run]
    return _linked(parts)


def _runs(scalars: Sequence[Scalar]) -> list[list[Scalar]]:
    """Neighbors that may be one array."""

    def kind(scalar: Scalar) -> object:
        name = scalar.name
        return (name.path, name.order, len(name.indices), scalar.attributes.role, scalar.key, _others_of_array(scalar))

    return [list(run) for _, run in groupby(scalars, key=kind)]


def _others_of_array(scalar: Scalar) -> tuple[str, ...]:
    """The other names of an array of which the number is an entry: of the same entry there, else of the number."""
    own = scalar.name.indices
    return tuple(other.name.array if other.name.indices == own else other.name.text for other in scalar.others)


def _shape(run: Sequence[Scalar]) -> tuple[int, ...] | None:
    """Row-major from 1 to the shape, without gaps; None if it is not that."""
    shape = run[-1].name.indices
    wanted: list[tuple[int, ...]] = [()]
    for extent in shape:
        if len(wanted) * extent > len(run):
            return None
        wanted = [(*head, index + 1) for head in wanted for index in range(extent)]
    in_order = all(scalar.first == run[0].first + place for place, scalar in enumerate(run))
    return shape if shape and in_order and [scalar.name.indices for scalar in run] == wanted else None


def _array(run: Sequence[Scalar], shape: tuple[int, ...]) -> Variable:
    first = run[0]
    tunable = (scalar.attributes for scalar in run if scalar.attributes.variability == "tunable")
    initials = list(dict.fromkeys(scalar.initial for scalar in run))
    initial: Initial | None = initials[0] if len(initials) == 1 else "approx"
    return Variable(
        name=first.name.array,
        first=first.first,
        shape=shape,
        attributes=next(tunable, first.attributes),
        initial=initial,
        starts=tuple(scalar.start for scalar in run if scalar.start is not None),
        reinit=any(scalar.reinit for scalar in run),
        derivative_of=first.derivative_of,
        others=tuple((other.name.array, other.doc) for other in first.others),
    )


def _single(scalar: Scalar) -> Variable:
    return Variable(
        name=scalar.name.text,
        first=scalar.first,
        shape=(),
        attributes=scalar.attributes,
        initial=scalar.initial,
        starts=() if scalar.start is None else (scalar.start,),
        reinit=scalar.reinit,
        derivative_of=scalar.derivative_of,
        others=tuple((other.name.text, other.doc) for other in scalar.others),
    )


def _linked(variables: Sequence[Variable]) -> tuple[Variable, ...]:
    """With `derivative_of` as the index of a variable instead of a state."""
    places = {variable.first: index for index, variable in enumerate(variables) if variable.attributes.role == "STATE"}
    return tuple(
        variable if variable.derivative_of is None else replace(variable, derivative_of=places[variable.derivative_of])
        for variable in variables
    )
