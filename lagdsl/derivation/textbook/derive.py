"""Lagrange's equations by the letter: d/dt(dL/dqd_j) - dL/dq_j + dD/dqd_j = Q_j + sum_r lam_r dphi_r/dq_j.

Everything is differentiated as a textbook does it, by SymPy; nothing is simplified. The graph route forms the same
equations by other means and is compared with this one.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import chain

from sympy import Add, Expr, ImmutableDenseMatrix, Integer

from lagdsl.derivation.textbook.contributions import Contributions, contributions, generalized_force, held_rates
from lagdsl.derivation.textbook.convert import Converter
from lagdsl.derivation.textbook.differentiate import partial
from lagdsl.derivation.textbook.equations import Energies, EquationsOfMotion, MonitoredValue
from lagdsl.derivation.textbook.mechanical import MechanicalValues
from lagdsl.derivation.textbook.symbols import Symbols, replaced, symbols
from lagdsl.derivation.textbook.tidy import Tidy
from lagdsl.language.flat.events import Impact, Reset
from lagdsl.language.flat.expression import Binary, FlatExpression, SystemEnergy, Unary
from lagdsl.language.flat.model import FlatModel


def derive(flat: FlatModel) -> EquationsOfMotion:
    """The equations of motion of `flat`."""
    table = symbols(flat)
    return equations_of(flat, table, contributions(flat, Converter(model=flat, symbols=table)))


def equations_of(flat: FlatModel, table: Symbols, parts: Contributions) -> EquationsOfMotion:
    """Lagrange's equations for contributions already gathered."""
    converter = parts.converter
    lagrangian, dissipation = parts.lagrangian, parts.dissipation
    held = held_rates(flat, table, parts)
    momenta = [partial(lagrangian, qd) for qd in table.qd]
    mass = _symmetric([[partial(momentum, qd) for qd in table.qd[: i + 1]] for i, momentum in enumerate(momenta)])
    loads = [generalized_force(parts, q, qd) for q, qd in zip(table.q, table.qd, strict=True)]
    drag = [-held.partial(held.parts.dissipation, qd) for qd in table.qd]
    forcing = [
        load + resistance + held.partial(held.parts.lagrangian, q) - converter.rate(momentum, bias=True)
        for load, resistance, q, momentum in zip(loads, drag, table.q, momenta, strict=True)
    ]
    levels = [constraint.level for constraint in flat.constraints for _ in constraint.rows]
    velocities = [
        converter.rate(residual) if level == "position" else residual
        for residual, level in zip(parts.residuals, levels, strict=True)
    ]
    energies = system_energies(table, parts, momenta)
    converter.mechanical = MechanicalValues(flat, table, parts, energies, momenta)
    starts = [(c.start, c.rate_start) for c in flat.coordinates]
    return EquationsOfMotion(
        name=flat.name,
        symbols=table,
        parameters={s: p.value for s, p in zip(table.p, (p for p in flat.parameters if not p.structural), strict=True)},
        lagrangian=lagrangian,
        dissipation=dissipation,
        energies=energies,
        mass_matrix=_matrix(len(momenta), len(momenta), chain.from_iterable(mass)),
        forcing=_column(forcing),
        generalized_force=_column(loads),
        dissipative_force=_column(drag),
        momenta=_column(momenta),
        constraint=_column(
            residual if level == "position" else Integer(0)
            for residual, level in zip(parts.residuals, levels, strict=True)
        ),
        constraint_jacobian=_matrix(
            len(velocities), len(table.q), (partial(velocity, qd) for velocity in velocities for qd in table.qd)
        ),
        velocity_constraint=_column(velocities),
        gamma=_column(-converter.rate(velocity, bias=True) for velocity in velocities),
        state_derivatives={
            symbol: converter.scalar(state.derivative) for symbol, state in zip(table.z, flat.states, strict=True)
        },
        outputs={output.name: converter.scalar(output.value) for output in flat.outputs},
        invariants=tuple(
            MonitoredValue(name=i.name, value=converter.scalar(i.value), terms=_terms(converter, parts, i.value))
            for i in flat.invariants
        ),
        assertions=tuple(converter.scalar(assertion.value) for assertion in flat.assertions),
        initial_equations=tuple(converter.scalar(equation.residual) for equation in flat.initial_equations),
        start=dict(zip(table.q, (converter.scalar(start) for start, _ in starts), strict=True))
        | dict(zip(table.qd, (converter.scalar(rate) for _, rate in starts), strict=True))
        | dict(zip(table.z, (converter.scalar(state.start) for state in flat.states), strict=True))
        | dict(zip(table.u, (converter.scalar(item.default) for item in flat.inputs), strict=True)),
    )


def system_energies(table: Symbols, parts: Contributions, momenta: Sequence[Expr]) -> Energies:
    beyond = Add(*(qd * partial(parts.extra, qd) for qd in table.qd), -parts.extra)
    return Energies(
        total=parts.kinetic + parts.potential + beyond,
        kinetic=parts.kinetic,
        potential=parts.potential,
        jacobi=Add(*(qd * momentum for qd, momentum in zip(table.qd, momenta, strict=True)), -parts.lagrangian),
    )


def resets(flat: FlatModel) -> bool:
    """True if a clause makes rates jump."""
    actions = (action for when in flat.events.whens for branch in when.branches for action in branch.actions)
    return any(isinstance(action, Reset | Impact) for action in actions)


def jumps(flat: FlatModel) -> bool:
    """True if energy may change at an instant."""
    return bool(flat.events.contacts) or resets(flat) or any(each.switched for each in flat.constraints)


def rheonomic(table: Symbols, tidy: Tidy, velocities: Sequence[Expr]) -> bool:
    """Constraints do work if they move by themselves: one of their `velocities` has a part without rates."""
    at_rest = dict.fromkeys(table.qd, Integer(0))
    return any(tidy(each.xreplace(at_rest)) != 0 for each in velocities)


def is_scleronomic(flat: FlatModel, table: Symbols, tidy: Tidy, kinetic: Expr) -> bool:
    """T + V is the Jacobi integral if T is quadratic in the rates. That of masses and bodies has the second degree: it
    is quadratic if it vanishes at rest with its first derivatives, which long expressions show, too."""
    if not any(each.kind == "kinetic" for each in flat.energies):
        rest = dict.fromkeys(table.qd, Integer(0))
        lower = (kinetic, *(partial(kinetic, qd) for qd in table.qd))
        return all(tidy.is_zero(replaced(each, rest)) for each in lower)
    twice = Add(*(qd * partial(kinetic, qd) for qd in table.qd))
    return tidy.is_zero(twice - 2 * kinetic)


def _terms(converter: Converter, parts: Contributions, value: FlatExpression) -> tuple[Expr, ...]:
    """The summands whose largest size is the scale of an invariant; an energy counts by its kinds."""
    if isinstance(value, Binary) and value.operator in ("+", "-"):
        return (*_terms(converter, parts, value.left), *_terms(converter, parts, value.right))
    if isinstance(value, Unary) and value.operator == "-":
        return _terms(converter, parts, value.operand)
    if isinstance(value, SystemEnergy) and value.kind in ("total", "jacobi"):
        return (parts.kinetic, parts.potential, converter.scalar(value))
    return (converter.scalar(value),)


def _symmetric(lower: Sequence[Sequence[Expr]]) -> list[list[Expr]]:
    """A full matrix from its lower triangle."""
    n = len(lower)
    return [[lower[max(i, j)][min(i, j)] for j in range(n)] for i in range(n)]


def _matrix(rows: int, columns: int, elements: Iterable[Expr]) -> ImmutableDenseMatrix:
    return ImmutableDenseMatrix(rows, columns, list(elements))


def _column(elements: Iterable[Expr]) -> ImmutableDenseMatrix:
    entries = list(elements)
    return ImmutableDenseMatrix(len(entries), 1, entries)
