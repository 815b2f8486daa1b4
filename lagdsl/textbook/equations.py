"""The equations of motion in SymPy: product of the literal derivation.

M(q, qd, t) qdd - J' lam = f,  J qdd = gamma, with the sign of the language reference: a positive multiplier pushes
towards a larger residual. Everything is written in SI units and in the symbols of `symbols`; nothing is simplified.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Expr, ImmutableDenseMatrix, Symbol

from lagdsl.textbook.symbols import Symbols


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


@dataclass(frozen=True, slots=True, kw_only=True)
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

    @property
    def kinetic_energy(self) -> Expr:
        return self.energies.kinetic

    @property
    def potential_energy(self) -> Expr:
        return self.energies.potential
