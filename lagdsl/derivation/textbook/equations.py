"""The equations of motion in SymPy: product of the literal derivation.

M(q, qd, t) qdd - J' lam = f,  J qdd = gamma, with the sign of the language reference: a positive multiplier pushes
towards a larger residual. Everything is written in SI units and in the symbols of `symbols`; nothing is simplified.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Add, Expr, ImmutableDenseMatrix, Symbol, latex, simplify

from lagdsl.derivation.textbook.symbols import Symbols

_LONGEST = 4000  # characters of all rows
_MOST_OPERATIONS = 100  # of the terms of a row that are simplified


@dataclass(frozen=True, slots=True, kw_only=True)
class Energies:
    """All in J. `total` is T + V and, for each `lagrangian` term Lx, qd.dLx/dqd - Lx; `jacobi` is qd.dL/dqd - L."""

    total: Expr
    kinetic: Expr
    potential: Expr
    jacobi: Expr


@dataclass(frozen=True, slots=True, kw_only=True)
class MonitoredValue:
    """An invariant: its value, and the terms whose largest size is its scale."""

    name: str
    value: Expr
    terms: tuple[Expr, ...]


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class EquationsOfMotion:
    """nq coordinates, nc constraint rows, nz states, ny outputs. Matrices are SymPy's, columns are (n, 1).

    `forcing` f holds everything that is not M qdd or J' lam; `generalized_force` Q only the declared loads.
    `constraint` is zero for rows of velocity level; `velocity_constraint` is J qd + b of every row.
    Outputs, state derivatives, invariants, assertions and initial equations may hold qdd and lam.
    """

    name: str
    symbols: Symbols
    parameters: Mapping[Symbol, float]
    lagrangian: Expr
    dissipation: Expr
    energies: Energies
    mass_matrix: ImmutableDenseMatrix
    forcing: ImmutableDenseMatrix
    generalized_force: ImmutableDenseMatrix
    dissipative_force: ImmutableDenseMatrix
    momenta: ImmutableDenseMatrix
    constraint: ImmutableDenseMatrix
    constraint_jacobian: ImmutableDenseMatrix
    velocity_constraint: ImmutableDenseMatrix
    gamma: ImmutableDenseMatrix
    state_derivatives: Mapping[Symbol, Expr]
    outputs: Mapping[str, Expr]
    invariants: tuple[MonitoredValue, ...]
    assertions: tuple[Expr, ...]
    initial_equations: tuple[Expr, ...]
    start: Mapping[Symbol, Expr]

    @property
    def q(self) -> tuple[Symbol, ...]:
        """Generalized coordinates."""
        return self.symbols.q

    @property
    def qd(self) -> tuple[Symbol, ...]:
        """Their rates."""
        return self.symbols.qd

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.name}: {', '.join(q.name for q in self.q)}>"

    def _repr_latex_(self) -> str | None:
        """A row for each coordinate, then one for each constraint; None where they are too long to be read."""
        return _in_latex(self.symbols, self.mass_matrix, self.forcing, self.constraint_jacobian, self.gamma)

    @property
    def kinetic_energy(self) -> Expr:
        return self.energies.kinetic

    @property
    def potential_energy(self) -> Expr:
        return self.energies.potential


def _in_latex(
    symbols: Symbols,
    mass_matrix: ImmutableDenseMatrix,
    forcing: ImmutableDenseMatrix,
    jacobian: ImmutableDenseMatrix,
    gamma: ImmutableDenseMatrix,
) -> str | None:
    """M qdd - J' lam = f and J qdd = gamma, row by row; None where that is too long."""
    matrices = (mass_matrix, forcing, jacobian, gamma)
    if sum(int(entry.count_ops()) for matrix in matrices for entry in matrix) > _LONGEST:
        return None
    names = _names(symbols)
    rows = [(_row(mass_matrix, i, symbols.qdd), force) for i, force in enumerate(forcing)]
    if symbols.lam:
        transposed = jacobian.T
        rows = [(left - _row(transposed, i, symbols.lam), right) for i, (left, right) in enumerate(rows)]
        rows += [(_row(jacobian, i, symbols.qdd), right) for i, right in enumerate(gamma)]
    mark = " &= " if len(rows) > 1 else " = "
    lines = [mark.join(latex(_short(side), symbol_names=names) for side in row) for row in rows]
    text = " \\\\\n".join(lines)
    if len(rows) > 1:
        text = f"\\begin{{aligned}}\n{text}\n\\end{{aligned}}"
    return f"$\\displaystyle {text}$" if rows and len(text) <= _LONGEST else None


def _row(matrix: ImmutableDenseMatrix, number: int, column: tuple[Symbol, ...]) -> Expr:
    return Add(*(matrix[number, j] * entry for j, entry in enumerate(column)))


def _short(expression: Expr) -> Expr:
    return simplify(expression) if expression.count_ops() <= _MOST_OPERATIONS else expression


def _names(symbols: Symbols) -> dict[Symbol, str]:
    """Dots for rates and accelerations, lambda for multipliers."""
    found: dict[Symbol, str] = {}
    for q, qd, qdd in zip(symbols.q, symbols.qd, symbols.qdd, strict=True):
        name = latex(Symbol(q.name.replace(".", "_")))
        found |= {q: name, qd: rf"\dot{{{name}}}", qdd: rf"\ddot{{{name}}}"}
    for number, multiplier in enumerate(symbols.lam, 1):
        found[multiplier] = rf"\lambda_{{{number}}}" if len(symbols.lam) > 1 else r"\lambda"
    return found
