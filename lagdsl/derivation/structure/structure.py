"""Structure of a model: degrees of freedom, redundant and contradictory constraints, coordinates without inertia.

Ranks are found numerically at three general points of the constraint set, the same ones in every run.
"""

from __future__ import annotations

from dataclasses import field, replace

import numpy as np

from lagdsl.derivation.program.program import Program
from lagdsl.derivation.structure.balances import balances
from lagdsl.derivation.structure.constraints import report_impossible, report_inconsistent_rates
from lagdsl.derivation.structure.count import Count, balance_text, count, count_text, counted
from lagdsl.derivation.structure.degenerate import report_degenerate
from lagdsl.derivation.structure.dependence import Dependence, dependence, report_dependence
from lagdsl.derivation.structure.functions import ProgramFunctions
from lagdsl.derivation.structure.inertia import massless
from lagdsl.derivation.structure.moments import other_moments
from lagdsl.derivation.structure.names import contact_rows
from lagdsl.derivation.structure.points import Geometry, Probe, geometry, probes
from lagdsl.derivation.structure.rates import report_integrable, report_nonlinear
from lagdsl.derivation.structure.rigid import report_rigid
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import record
from lagdsl.language.flat.balanced import balanced
from lagdsl.language.flat.model import Constraint, FlatModel


@record(kw_only=True)
class Structure:
    """Degrees of freedom that the constraints leave.

    `position_rank` is that of dphi/dq, `rank` that of J with the velocity rows; `redundant` and `empty` flag rows,
    the latter those that hold identically; `contacts` are the rows that come and go. `balances` are the constraints
    that balance forces along directions without inertia, also those that the model lacks. `points` lie on the
    constraints of `space`.
    """

    coordinates: int
    position_rank: int
    rank: int
    redundant: tuple[bool, ...]
    empty: tuple[bool, ...]
    contacts: frozenset[int]
    count: Count | None
    balances: tuple[Constraint, ...]
    space: Geometry = field(compare=False, repr=False)
    points: tuple[Probe, ...] = field(compare=False, repr=False)

    @property
    def configuration_freedom(self) -> int:
        return self.coordinates - self.position_rank

    @property
    def freedom(self) -> int:
        """Degrees of freedom of the velocities."""
        return self.coordinates - self.rank


def constraint_space(flat: FlatModel, program: Program) -> Geometry:
    """The constraints of `program` as functions of q, with the sizes and factors of their rows."""
    with np.errstate(all="ignore"):
        return geometry(flat, ProgramFunctions(program))


def analyze(flat: FlatModel, space: Geometry, sink: Sink) -> Structure:
    """Ranks, redundancy and inertia of the program behind `space`; what is wrong goes to `sink`."""
    with np.errstate(all="ignore"):  # rows may be of any size, and are told where they are none
        found = _examined(flat, space, sink)
    contacts = contact_rows(flat)
    redundant = tuple(flag and row not in contacts for row, flag in enumerate(found.dependence.redundant))
    return Structure(
        coordinates=len(flat.coordinates),
        position_rank=found.position_rank,
        rank=found.rank,
        redundant=redundant,
        empty=found.dependence.empty,
        contacts=contacts,
        count=count(flat, len(flat.coordinates) - found.position_rank),
        balances=(*(each for each in flat.constraints if balanced(each)), *found.balances),
        space=space,
        points=tuple(found.points),
    )


def flag_redundant(program: Program, structure: Structure) -> Program:
    """`program` with `Layout.redundant` filled."""
    return replace(program, layout=replace(program.layout, redundant=structure.redundant))


@record()
class _Examination:
    """The numeric findings."""

    dependence: Dependence
    position_rank: int
    rank: int
    points: list[Probe]
    balances: tuple[Constraint, ...]


def _examined(flat: FlatModel, space: Geometry, sink: Sink) -> _Examination:
    impossible = bool(flat.constraints) and report_impossible(flat, space, sink)
    rows = space.position_rows
    points = [] if impossible else probes(flat, space, rows)
    contacts = contact_rows(flat)
    found = dependence(space, points, contacts)
    if any(flag and row not in contacts for row, flag in enumerate(found.redundant)):
        later = [replace(space, t=each.t, z=each.z, u=each.u) for each in other_moments(flat, space.moment)]
        others = [probe for moment in later for probe in probes(flat, moment, rows, wanted=1)]
        found = dependence(space, [*points, *others], contacts)
    wrong = not impossible and report_degenerate(flat, space, points, sink)
    if flat.constraints and points and not wrong:
        wrong = report_nonlinear(flat, space, points, sink) or report_inconsistent_rates(flat, space, points, sink)
        if not wrong:
            report_dependence(flat, space, points, found, sink)
            report_integrable(flat, space, points, found.redundant, sink)
            report_rigid(flat, found, sink)
    idle = massless(flat, space, points)
    wanting = () if idle is None else balances(flat, space, points, idle, sink)
    holonomic = set(rows)
    kept = [row for row, redundant in enumerate(found.redundant) if not redundant]
    return _Examination(found, sum(row in holonomic for row in kept), len(kept), points, wanting)


def structure_text(structure: Structure) -> str:
    """`2 coordinates - 1 independent constraint = 1 degree of freedom (d = 3N - k = 3*1 - 2 = 1)`; where conditions
    such as rolling hold rates only, how many coordinates are left to choose at the start."""
    forces = len(structure.balances)
    constrained = len(structure.redundant) > len(structure.contacts) + forces
    parts = [balance_text(structure.coordinates, structure.rank - forces if constrained else None, forces)]
    if structure.configuration_freedom == structure.freedom:
        parts += [f"({count_text(structure.count)})"] if structure.count is not None else []
        return " ".join(parts)
    rates, free = structure.configuration_freedom - structure.freedom, structure.configuration_freedom
    verb = "holds rates only and leaves" if rates == 1 else "hold rates only and leave"
    count = f": {count_text(structure.count)}" if structure.count is not None else ""
    conditions = "conditions" if forces else "constraints"
    told = f"{rates} of the {conditions} {verb} {counted(free, 'coordinate')} to choose at the start{count}"
    return f"{' '.join(parts)} ({told})"
