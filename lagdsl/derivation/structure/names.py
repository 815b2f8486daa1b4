"""Constraints in the words of the user: by their names, or as the loops of joints that they close."""

from __future__ import annotations

import numpy as np

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.foundation.source import Span
from lagdsl.foundation.units.dimension import BASE_UNITS
from lagdsl.language.flat.balanced import balanced
from lagdsl.language.flat.display import quantity_text
from lagdsl.language.flat.model import Closure, Constraint, FlatModel

_MOST_SHOWN = 6


@record()
class Located:
    """A declared constraint and the indices of its rows."""

    constraint: Constraint
    rows: tuple[int, ...]


def located(flat: FlatModel) -> list[Located]:
    """All constraints with the indices of their rows, in source order."""
    result, first = [], 0
    for constraint in flat.constraints:
        result.append(Located(constraint, tuple(range(first, first + len(constraint.rows)))))
        first += len(constraint.rows)
    return result


def contact_rows(flat: FlatModel) -> frozenset[int]:
    """The rows that come and go."""
    return frozenset(row for item in located(flat) if comes_and_goes(item.constraint) for row in item.rows)


def balance_rows(flat: FlatModel) -> frozenset[int]:
    """The rows that balance forces along directions without inertia."""
    return frozenset(row for item in located(flat) if balanced(item.constraint) for row in item.rows)


def balanced_coordinates(flat: FlatModel) -> list[int]:
    """The coordinates of these directions."""
    names = {name for constraint in flat.constraints for name in balanced(constraint)}
    return [index for index, coordinate in enumerate(flat.coordinates) if coordinate.name in names]


def comes_and_goes(constraint: Constraint) -> bool:
    return constraint.of_law or constraint.switched


def place(constraint: Constraint) -> Span | None:
    """Place to which diagnostics point: the `connect` of a closure, else the declaration."""
    if constraint.closure is not None:
        return constraint.closure.span
    return constraint.spans[0] if constraint.spans else None


def grammatical_subject(flat: FlatModel, constraint: Constraint) -> str:
    """``constraint `c` ``, or `the loop A - B - C - D`."""
    if constraint.closure is None:
        return f"constraint `{constraint.name}`"
    return f"the loop {loop_text(flat, constraint.closure)}"


def listed(names: list[str]) -> str:
    """`a`, `a and b`, `a, b and c`."""
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


def loop_text(flat: FlatModel, closure: Closure) -> str:
    """`A - B - C - D`: the joints around the loop; of long loops both ends."""
    joints = {joint.name for joint in flat.joints}
    names = tuple(name for name in closure.loop if name in joints) or closure.loop
    if len(names) > 2 * _MOST_SHOWN:
        names = (*names[:_MOST_SHOWN], "...", *names[-_MOST_SHOWN:])
    return " - ".join(names)


def joint_text(flat: FlatModel, closure: Closure) -> str:
    """``revolute `D` ``."""
    if closure.joint is None:
        return "this connection"
    kind = next((joint.kind for joint in flat.joints if joint.name == closure.joint), "joint")
    return f"{kind.rpartition('.')[2].lower()} `{closure.joint}`"


def configuration(flat: FlatModel, q: Floats, columns: list[int] | None = None) -> str:
    """`x = 0.1 m, theta = 30 deg` in display units, the first few coordinates; of `columns` only, if given. Searches
    may have turned angles around: whole turns are left out."""
    angles = np.array([c.type_name == "Angle" for c in flat.coordinates], dtype=np.bool_)
    turned = angles & (np.abs(q) > 2.0 * np.pi)
    q = np.where(turned, np.remainder(q + np.pi, 2.0 * np.pi) - np.pi, q)
    values = np.where(np.abs(q) > 1e-6, q, 0.0).tolist()  # what a search leaves of a zero
    chosen = range(len(values)) if columns is None else columns
    shown = [f"{flat.coordinates[i].name} = {quantity_text(values[i], flat.coordinates[i])}" for i in chosen]
    return ", ".join([*shown[:_MOST_SHOWN], *(["..."] if len(shown) > _MOST_SHOWN else [])])


def seat(constraint: Constraint) -> str:
    """Name of the place at which a constraint acts: the joint that closes the loop, else its own name."""
    return constraint.name if constraint.closure is None else constraint.closure.joint or constraint.name


def unit_suffix(constraint: Constraint) -> str:
    """The coherent unit of a constraint's rows, with a leading blank."""
    parts = [
        base if exponent == 1 else f"{base}{exponent}"
        for base, exponent in zip(BASE_UNITS, constraint.dimension.exponents, strict=True)
        if exponent
    ]
    return f" {'.'.join(parts)}" if parts else ""
