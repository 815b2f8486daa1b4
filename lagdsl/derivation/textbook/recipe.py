"""The lecture's recipe for a model, as data: what a derivation on paper shows, step by step.

Five steps to the left-hand side of Lagrange's equations (coordinates and their count; positions; velocities; energies;
derivatives term by term), four to the generalized forces (loads and their places; admissible variations; which do no
work; their sum), then the equations with constraints, states and outputs. After J. K. Vandiver, MIT 2.003SC Engineering
Dynamics, lectures on Lagrange's equations, and D. A. Wells, *Lagrangian Dynamics* (1967), chapters 3 and 4.

Everything is bounded: what would not fit a page is counted and named, not expanded.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import assert_never

from sympy import Add, Expr, Symbol, cos, sin

from lagdsl.derivation.textbook import functions, geometry
from lagdsl.derivation.textbook.contributions import (
    AppliedForce,
    AppliedGeneralizedForce,
    AppliedRateForce,
    AppliedTorque,
    Contributions,
    HeldRates,
    Inertial,
    held_rates,
)
from lagdsl.derivation.textbook.counting import Count, count
from lagdsl.derivation.textbook.derive import is_scleronomic, jumps, resets, rheonomic, system_energies
from lagdsl.derivation.textbook.differentiate import partial
from lagdsl.derivation.textbook.extent import Extent, extent
from lagdsl.derivation.textbook.familiar import Familiar, familiar
from lagdsl.derivation.textbook.mechanical import MechanicalValues
from lagdsl.derivation.textbook.provenance import Parents, Source, Term, shares, sources, terms
from lagdsl.derivation.textbook.reading import STANDARD_GRAVITY, STANDARD_GRAVITY_VALUE, Reading, needed, read
from lagdsl.derivation.textbook.steps.actions import ActionStep, action_steps
from lagdsl.derivation.textbook.steps.short_equations import ShortEquations, short_equations
from lagdsl.derivation.textbook.symbols import Symbols, occurring, replaced
from lagdsl.derivation.textbook.tidy import size, times
from lagdsl.language.flat.balanced import balanced
from lagdsl.language.flat.listing import computed_outputs
from lagdsl.language.flat.model import Constraint, Definition, FlatModel, Output

_LARGEST = 1000
"""Nodes of an expression that is looked through term by term."""


@dataclass(frozen=True, slots=True, kw_only=True)
class CoordinateStep:
    """d/dt(dL/dqd) - dL/dq of one coordinate, in its parts; `left` is their difference, collected by accelerations."""

    q: Symbol
    momentum: Expr
    momentum_rate: Expr
    gradient: Expr
    left: Expr


@dataclass(frozen=True, slots=True, kw_only=True)
class ConstraintRow:
    """`residual` = 0, on position or velocity level; `forces` are its multiplier's factors in the equations, per
    coordinate; `acceleration` is the row differentiated until accelerations appear. Of a contact the residual is the
    gap, and all that holds while it is closed; of dry friction it is the slip, and all that holds while it sticks."""

    name: str
    level: str
    multiplier: Symbol
    residual: Expr
    forces: tuple[Expr, ...]
    acceleration: Expr
    contact: bool = False
    friction: bool = False

    @property
    def is_lasting(self) -> bool:
        """False for a row that is there while a contact is closed, or while dry friction sticks."""
        return not (self.contact or self.friction)

    @property
    def restricts(self) -> bool:
        """False for a row that holds whatever the motion is, as those of a planar loop out of its plane."""
        return bool(self.residual != 0)


@dataclass(frozen=True, slots=True, kw_only=True)
class Derivation:
    """The written-out derivation of a model of modest extent. `abbreviations` are those of the model's `definitions`
    that loads, states or outputs are written with."""

    symbols: Symbols
    constants: frozenset[Symbol]
    sums: frozenset[Expr]
    count: Count
    inertials: tuple[Inertial, ...]
    own_kinetic: tuple[Expr, ...]
    kinetic: Expr
    potential: Expr
    extra: Expr
    lagrangian: Expr
    dissipation: Expr
    coordinates: tuple[CoordinateStep, ...]
    actions: tuple[ActionStep, ...]
    drags: tuple[Expr, ...]
    generalized_forces: tuple[Expr, ...]
    constraints: tuple[ConstraintRow, ...]
    dependent_parameters: tuple[tuple[Symbol, Expr], ...]
    definitions: tuple[tuple[Symbol, Expr], ...]
    abbreviations: tuple[tuple[Symbol, Expr], ...]
    states: tuple[tuple[Symbol, Expr], ...]
    outputs: tuple[tuple[str, Expr], ...]
    cyclic: tuple[Symbol, ...]
    jacobi_conserved: bool
    energy_conserved: bool
    occurring: frozenset[Symbol]
    rights: tuple[Expr, ...]
    sources: tuple[Source, ...]
    terms: tuple[Term, ...]

    @property
    def balanced(self) -> dict[Symbol, Symbol]:
        """Coordinates, with their accelerations, whose equations hold neither accelerations nor multipliers: they
        balance forces."""
        solved, found = {*self.symbols.qdd, *self.symbols.lam}, zip(self.coordinates, self.rights, strict=True)
        none = [solved.isdisjoint(occurring(step.left - right)) for step, right in found]
        both = zip(self.symbols.q, self.symbols.qdd, none, strict=True)
        return {q: acceleration for q, acceleration, held in both if held}


@dataclass(frozen=True, slots=True, kw_only=True)
class Recipe:
    """`familiar` is the model as people write it. `derivation` is None where its extent is beyond what is written out;
    `extent` says why, and `short` has the equations that are short nevertheless."""

    familiar: Familiar
    extent: Extent
    derivation: Derivation | None
    short: ShortEquations | None

    @property
    def flat(self) -> FlatModel:
        return self.familiar.flat


def recipe(flat: FlatModel) -> Recipe:
    """The derivation of `flat`, written out if the model is of modest extent. Balances of forces along directions
    without inertia are no constraints on paper: they stand among Lagrange's equations."""
    written = tuple(constraint for constraint in flat.constraints if not balanced(constraint))
    prepared = familiar(replace(flat, constraints=written))
    found = extent(prepared.flat)
    derivation = None if found.reasons else _derivation(prepared.flat, read(prepared.flat))
    short = short_equations(prepared.flat, found) if found.reasons else None
    return Recipe(familiar=prepared, extent=found, derivation=derivation, short=short)


def _derivation(flat: FlatModel, reading: Reading) -> Derivation:
    tidy, table, parts = reading.tidy, reading.symbols, reading.parts
    own = tuple(tidy(item.kinetic_energy) for item in parts.inertials)
    kinetic = tidy(Add(*own, *(parts.converter.scalar(e.value) for e in flat.energies if e.kind == "kinetic")))
    potential, extra = tidy(parts.potential), tidy(parts.extra)
    lagrangian, dissipation = kinetic - potential + extra, tidy(parts.dissipation)
    held = held_rates(flat, table, parts)
    steps = tuple(_coordinate(reading, lagrangian, held, q, qd) for q, qd in zip(table.q, table.qd, strict=True))
    actions = action_steps(reading)
    lost = held.parts.dissipation if held.rates else dissipation
    drags = tuple(tidy(-held.partial(lost, qd)) for qd in table.qd)
    loads = tuple(tidy(Add(*(action.works[j] for action in actions))) for j in range(len(table.q)))
    rows = _constraints(flat, reading)
    reading.parts.converter.mechanical = reading.values.mechanical = MechanicalValues(
        flat,
        table,
        parts,
        system_energies(table, parts, [step.momentum for step in steps]),
        [s.momentum for s in steps],
    )
    constants = _definitions(reading, reading.constants)
    lasting = [row for row in rows if row.is_lasting]
    position = [row.residual for row in lasting if row.level == "position"]
    velocities = [_velocity(reading, row) for row in lasting]
    free = [
        step.q
        for step, load, drag in zip(steps, loads, drags, strict=True)
        if step.gradient == 0 and load == 0 and drag == 0
    ]
    states = tuple(
        (symbol, tidy(reading.values.scalar(state.derivative)))
        for symbol, state in zip(table.z, flat.states, strict=True)
    )
    outputs = tuple((output.name, _written(reading, output)) for output in computed_outputs(flat))
    definitions = _definitions(reading, reading.abbreviations)
    abbreviations = _used(definitions, actions, (*states, *outputs))
    printed = [
        lagrangian,
        dissipation,
        *_printed(parts, actions, rows),
        *(value for _, value in (*states, *outputs, *abbreviations)),
    ]
    rights = tuple(
        Add(load, drag, *(times(row.forces[j], row.multiplier) for row in rows))
        for j, (load, drag) in enumerate(zip(loads, drags, strict=True))
    )
    short = all(size(expression) < _LARGEST for expression in (lagrangian, *own, *(step.left for step in steps)))
    parents = Parents(table, tuple(shares(flat, table, parts, whole=short)), tidy.constants)
    used = needed(constants, printed)
    printed += [value for _, value in used]
    moved = {*table.u, *table.z, *table.w}
    autonomous = not (table.time in lagrangian.free_symbols or lagrangian.free_symbols & moved or jumps(flat))
    moved_by_time = rheonomic(table, tidy, [_velocity(reading, row) for row in rows])
    conserved = autonomous and not (any(loads) or any(drags) or moved_by_time)
    return Derivation(
        symbols=table,
        constants=tidy.constants,
        sums=tidy.known.constant,
        count=count(flat, table, parts, ((STANDARD_GRAVITY, STANDARD_GRAVITY_VALUE), *constants), position, velocities),
        inertials=parts.inertials,
        own_kinetic=own,
        kinetic=kinetic,
        potential=potential,
        extra=extra,
        lagrangian=lagrangian,
        dissipation=dissipation,
        coordinates=steps,
        actions=actions,
        drags=drags,
        generalized_forces=loads,
        constraints=rows,
        dependent_parameters=used,
        definitions=definitions,
        abbreviations=abbreviations,
        states=states,
        outputs=outputs,
        cyclic=tuple(q for q in free if not resets(flat) and not any(row.forces[table.q.index(q)] for row in rows)),
        jacobi_conserved=conserved,
        energy_conserved=conserved and is_scleronomic(flat, table, tidy, kinetic),
        rights=rights,
        sources=sources(flat),
        terms=tuple(terms([step.left for step in steps], rights, parents.of)),
        occurring=frozenset(symbol for value in printed for symbol in value.free_symbols),
    )


def _written(reading: Reading, output: Output) -> Expr:
    """The value of an output; that of a definition of the same name is written out, it would say x = x.

    An angle that is known up to whole turns loses its arc tangent where that is the angle of a sine and a cosine.
    """
    value = reading.values.scalar(output.value)
    if value == Symbol(output.name):
        value = dict(_definitions(reading, {output.name: value})).get(value, value)
    value = reading.tidy(value)
    if output.turn is not None and isinstance(value, functions.ArcTangent2):
        (y, sine), (x, cosine) = (each.as_coeff_Mul() for each in value.args)
        if isinstance(sine, sin) and isinstance(cosine, cos) and sine.args == cosine.args and abs(y) == x:
            return y / x * sine.args[0]
    return value


def _coordinate(reading: Reading, lagrangian: Expr, held: HeldRates, q: Symbol, qd: Symbol) -> CoordinateStep:
    tidy = reading.tidy
    momentum = tidy(partial(lagrangian, qd))
    rate = reading.parts.converter.rate(momentum)
    gradient = tidy(held.partial(held.parts.lagrangian if held.rates else lagrangian, q))
    left = _by_accelerations(reading, rate - gradient)
    return CoordinateStep(
        q=q, momentum=momentum, momentum_rate=_by_accelerations(reading, rate), gradient=gradient, left=left
    )


def _by_accelerations(reading: Reading, expression: Expr) -> Expr:
    """Linear in the accelerations: their factors and the rest, each tidied by itself."""
    tidy, qdd = reading.tidy, reading.symbols.qdd
    present = occurring(expression)
    rest = replaced(expression, dict.fromkeys(qdd, geometry.ZERO[0]))
    return Add(*(times(tidy(partial(expression, x)), x) for x in qdd if x in present), tidy(rest))


def _constraints(flat: FlatModel, reading: Reading) -> tuple[ConstraintRow, ...]:
    tidy, table, converter = reading.tidy, reading.symbols, reading.parts.converter
    named = [(row, constraint) for constraint in flat.constraints for row in constraint.rows]
    rows = []
    for (name, constraint), multiplier, raw in zip(named, table.lam, reading.parts.residuals, strict=True):
        level = constraint.level
        present = _presence(constraint)
        residual = tidy(raw if present is None else partial(raw, present))
        by = table.q if level == "position" else table.qd
        velocity = converter.rate(residual) if level == "position" else residual
        rows.append(
            ConstraintRow(
                name=name,
                level=level,
                multiplier=multiplier,
                residual=residual,
                forces=tuple(tidy(partial(residual, symbol)) for symbol in by),
                acceleration=_by_accelerations(reading, converter.rate(velocity)),
                contact=constraint.contact,
                friction=constraint.friction,
            )
        )
    return tuple(rows)


def _presence(constraint: Constraint) -> Symbol | None:
    """The symbol that is 1 while the rows are there, 0 else; None where they always are."""
    if constraint.contact:
        return Symbol(f"closed({constraint.name})")
    return Symbol(f"sticks({constraint.name})") if constraint.friction else None


def _velocity(reading: Reading, row: ConstraintRow) -> Expr:
    return reading.parts.converter.rate(row.residual) if row.level == "position" else row.residual


def _definitions(reading: Reading, names: dict[str, Symbol]) -> tuple[tuple[Symbol, Expr], ...]:
    """Definitions as the model has them, in its own order, other definitions inside kept as symbols."""
    values = {item.name: item for item in reading.flat.named if isinstance(item, Definition)}
    return tuple((symbol, reading.values.scalar(values[name].value)) for name, symbol in names.items())


def _used(
    definitions: tuple[tuple[Symbol, Expr], ...],
    actions: Sequence[ActionStep],
    values: Sequence[tuple[Symbol | str, Expr]],
) -> tuple[tuple[Symbol, Expr], ...]:
    """Definitions that loads, states or outputs use, directly or through others."""
    return needed(definitions, [*(value for _, value in values), *(w for action in actions for w in action.works)])


def _printed(parts: Contributions, actions: Sequence[ActionStep], rows: Sequence[ConstraintRow]) -> Iterator[Expr]:
    """The entries of vectors and rows of a report."""
    for item in parts.inertials:
        yield from (item.mass, *item.position, *item.spin, *(e for row in item.tensor or () for e in row))
    for step in actions:
        action = step.action
        match action:
            case AppliedForce():
                yield from (*action.force, *action.position)
            case AppliedTorque():
                yield from action.torque
            case AppliedGeneralizedForce():
                yield from (action.value, action.target)
            case AppliedRateForce():
                yield from (action.value, action.rate)
            case _:
                assert_never(action)
    yield from (row.residual for row in rows)
