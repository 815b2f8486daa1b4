"""Inverse dynamics M qdd - f with the accelerations as symbols: by bodies and velocities where the model allows.

The forces of the acceleration form, taken along the motion with its accelerations instead of at qdd = 0, are all there
is to the equations: r_i = -sum_j dv_j/dqd_i h_j, one reverse sweep through the velocities. For bodies in frames that is
the recursion of Newton and Euler (Luh, Walker, Paul 1980), of order N; derivatives of it stay as small.
"""

from __future__ import annotations

from copy import copy

from lagdsl.algebra.eliminate.form import NotApplicable
from lagdsl.algebra.graph.differentiate import adjoints
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.mechanics.lagrange import lagrange
from lagdsl.derivation.mechanics.lagrange.inertia import acceleration_form
from lagdsl.derivation.mechanics.lowering.lowering import Lowering
from lagdsl.derivation.mechanics.lowering.symbols import Directions
from lagdsl.foundation.diagnostics import CompilationFailed
from lagdsl.language.flat.model import FlatModel


def inverse_dynamics(
    lowering: Lowering, flat: FlatModel, found: lagrange.Dynamics, directions: Directions
) -> list[int]:
    """M qdd - f, of about the size of T and V; by Lagrange's equations where a body has no acceleration form."""
    moving = copy(lowering)
    moving.bias_rate = lowering.rate
    forces = _forces(moving, flat, found, directions)
    return lagrange.inverse_dynamics(lowering, found.terms) if forces is None else forces


def bias_forces(lowering: Lowering, flat: FlatModel, found: lagrange.Dynamics, directions: Directions) -> list[int]:
    """-f: the same at qdd = 0."""
    forces = _forces(lowering, flat, found, directions)
    if forces is not None:
        return forces
    return [lowering.graph.negate(force) for force in lagrange.forcing(lowering, found.terms)]


def _forces(lowering: Lowering, flat: FlatModel, found: lagrange.Dynamics, directions: Directions) -> list[int] | None:
    """The forces of the acceleration form by coordinate, with opposite sign; None where a body has no such form."""
    graph = lowering.graph
    try:
        form = acceleration_form(lowering, flat, found, directions)
    except (NotApplicable, CompilationFailed):  # an input has no derivative that only this form asks for
        return None
    opposite = {velocity: graph.negate(force) for velocity, force in form.forces.items()}
    pulled = adjoints(graph, opposite, (Group.QD,))
    return [pulled.get(rate, graph.zero) for rate in directions.rates]
