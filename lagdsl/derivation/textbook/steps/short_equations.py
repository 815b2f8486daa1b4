"""Equations of motion in symbols of a model with many coordinates, each by itself where it is short.

Lagrange's operator is linear: an equation is the sum of the shares of the items that its coordinate moves. Of a circuit
or a chain each has a few, however long the model is.
"""

from __future__ import annotations

from dataclasses import dataclass

from sympy import Add, Expr, Integer, Symbol

from lagdsl.derivation.textbook.contributions import Contributions, admissible_variation, held_rates, work
from lagdsl.derivation.textbook.differentiate import partial
from lagdsl.derivation.textbook.extent import Extent
from lagdsl.derivation.textbook.reading import Reading, needed, read
from lagdsl.derivation.textbook.symbols import Symbols, occurring, replaced
from lagdsl.derivation.textbook.tidy import size, times
from lagdsl.language.flat.model import Definition, FlatModel

LONGEST = 160
"""Nodes of a side that is printed."""
_LARGEST_ENERGY = 400


@dataclass(frozen=True, slots=True, kw_only=True)
class ShortEquation:
    """left = right of a coordinate."""

    q: Symbol
    left: Expr
    right: Expr


@dataclass(frozen=True, slots=True, kw_only=True)
class ShortEquations:
    """`equations` of coordinates and `rows` of constraints, each with its multiplier, that are short; the coordinates
    `long` have others. `definitions` and `dependent_parameters` of the model are written with their names in them."""

    symbols: Symbols
    constants: frozenset[Symbol]
    equations: tuple[ShortEquation, ...]
    long: tuple[Symbol, ...]
    rows: tuple[tuple[Symbol, Expr], ...]
    definitions: tuple[tuple[Symbol, Expr], ...]
    dependent_parameters: tuple[tuple[Symbol, Expr], ...]


def short_equations(flat: FlatModel, extent: Extent) -> ShortEquations | None:
    """None where the `extent` does not let one look for them, and where there are none."""
    if not extent.has_short_parts:
        return None
    reading = read(flat)
    table, parts = reading.symbols, reading.parts
    pairs = list(zip(table.q, table.qd, strict=True))
    inertias = [item.kinetic_energy for item in parts.inertials]
    scalars = [(term.kind, parts.converter.scalar(term.value)) for term in flat.energies]
    lagrangians = [*inertias, *_weights(flat, parts)]
    lagrangians += [-value if kind == "potential" else value for kind, value in scalars if kind != "dissipation"]
    dissipations = [value for kind, value in scalars if kind == "dissipation"]
    if held_rates(flat, table, parts).rates:
        return None
    found, long = [], []
    for q, qd in pairs:
        own = [energy for energy in (*lagrangians, *dissipations) if {q, qd} & occurring(energy)]
        equation = None
        if all(size(energy) <= _LARGEST_ENERGY for energy in own):
            equation = _equation(reading, q, qd, [each for each in lagrangians if each in own], dissipations)
        if equation is None:
            long.append(q)
        else:
            found.append(equation)
    if not found:
        return None
    rows = [
        (lam, reading.tidy(row)) for lam, row in zip(table.lam, parts.residuals, strict=True) if size(row) < LONGEST
    ]
    rows = [(lam, row) for lam, row in rows if row != 0]
    printed = [*(side for each in found for side in (each.left, each.right)), *(row for _, row in rows)]
    definitions = needed(_values(reading, reading.abbreviations), printed)
    printed += [value for _, value in definitions]
    return ShortEquations(
        symbols=table,
        constants=reading.tidy.constants,
        equations=tuple(found),
        long=tuple(long),
        rows=tuple(rows),
        definitions=definitions,
        dependent_parameters=needed(_values(reading, reading.constants), printed),
    )


def _weights(flat: FlatModel, parts: Contributions) -> list[Expr]:
    if flat.gravity is None:
        return []
    gravity = parts.converter.vector(flat.gravity)
    return [item.mass * Add(*(g * r for g, r in zip(gravity, item.position, strict=True))) for item in parts.inertials]


def _equation(
    reading: Reading, q: Symbol, qd: Symbol, lagrangians: list[Expr], dissipations: list[Expr]
) -> ShortEquation | None:
    """None where a side is long."""
    tidy, converter, table = reading.tidy, reading.parts.converter, reading.symbols
    lagrangian = Add(*lagrangians)
    rest = converter.rate(partial(lagrangian, qd)) - partial(lagrangian, q)
    if size(rest, 4 * LONGEST) >= 4 * LONGEST:
        return None
    still = tidy(replaced(rest, dict.fromkeys(table.qdd, Integer(0))))
    left = Add(*(times(tidy(partial(rest, x)), x) for x in table.qdd if x in occurring(rest)), still)
    loads = [
        work(action, admissible_variation(action, converter, q, qd))
        for actions in reading.parts.actions
        for action in actions
    ]
    drag = -Add(*(partial(each, qd) for each in dissipations))
    forces = (
        times(tidy(partial(row, q if level == "position" else qd)), lam)
        for lam, row, level in zip(table.lam, reading.parts.residuals, _levels(reading.flat), strict=True)
    )
    right = Add(tidy(Add(*loads)), tidy(drag), *forces)
    return ShortEquation(q=q, left=left, right=right) if max(size(left), size(right)) <= LONGEST else None


def _levels(flat: FlatModel) -> list[str]:
    return [constraint.level for constraint in flat.constraints for _ in constraint.rows]


def _values(reading: Reading, names: dict[str, Symbol]) -> tuple[tuple[Symbol, Expr], ...]:
    values = {item.name: item for item in reading.flat.named if isinstance(item, Definition)}
    return tuple((symbol, reading.values.scalar(values[name].value)) for name, symbol in names.items())
