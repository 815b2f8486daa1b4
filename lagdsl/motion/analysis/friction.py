"""Forces of dry friction at a point, with their limits; forces that the motion does not determine are shared fairly.

Rows that depend on each other may share a load in many ways. Friction holds as long as some forces within the limits
exist, so each group of rows that share forces has the largest least reserve s of all: a linear program

    max s   subject to   J' d = 0,   |lam_t + d_t| + s size <= R_0(lam_n + d_n),   s size <= lam_n + d_n

with lam the smallest forces. Tangents meet the disc of friction in a plane; more are added where a solution is outside
of it. It is the program by which the runtime decides, lag/contacts/reserve.h.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lagdsl.foundation.numerics.connected_blocks import Flags, connected_blocks
from lagdsl.foundation.numerics.rank import RANK_TOLERANCE, Floats, null_space
from lagdsl.foundation.numerics.sparse_matrix import sparse
from lagdsl.language.flat.events import Friction
from lagdsl.language.flat.listing import force_unit
from lagdsl.motion.analysis.point import Flow, System

# A force outside of a disc by less than this part of the largest force is in it; so many tangents are added at most.
_OUTSIDE = 1e-12
_MORE = 24


@dataclass(frozen=True, slots=True, kw_only=True)
class FrictionForce:
    """Friction at a point: `force` has one component or two, along the slip; `limit` is what it bears in its mode. Both
    are in `unit`. `shared`: the motion does not determine them, they are those with the largest least reserve."""

    name: str
    mode: Literal["sticks", "slides"]
    force: tuple[float, ...]
    limit: float
    unit: str
    shared: bool

    @property
    def size(self) -> float:
        return float(np.linalg.norm(self.force))

    @property
    def margin(self) -> float:
        """1 - force/limit: one without a force, zero at the limit, negative beyond it."""
        return 1.0 - self.size / self.limit if self.limit > 0.0 else 0.0


@dataclass(frozen=True, slots=True)
class PlacedFriction:
    """A friction with the places of its `slips` among all slips and all `friction_rows`, and those of its entries in w.
    It acts if it stands under no contact that is open."""

    friction: Friction
    slips: slice
    sticks: int
    directions: tuple[int, ...]
    acts: bool


def placed_frictions(system: System, w: Floats) -> Iterator[PlacedFriction]:
    """All frictions in the order of the model, with the discretes w (nw,)."""
    places = {slot.name: place for place, slot in enumerate(system.engine.layout.discretes)}
    end = 0
    for friction in system.flat.events.frictions:
        start, end = end, end + len(friction.slips)
        yield PlacedFriction(
            friction=friction,
            slips=slice(start, end),
            sticks=places[friction.sticks],
            directions=tuple(places[name] for name in friction.directions),
            acts=friction.contact is None or w[places[f"closed({friction.contact})"]] != 0.0,
        )


@dataclass(frozen=True, slots=True)
class _Law:
    """Dry friction that acts: its rows of the constraints, its slips (1 or 2) and the direction of those that are zero,
    its limits, and the gain (nc,) of that at rest by multipliers. In the units of its rows: `factor` leads to those of
    the text."""

    name: str
    rows: tuple[int, ...]
    sticks: bool
    slip: Floats
    way: Floats
    limit: float
    sticking: float
    gain: Floats
    factor: float

    def bears(self, change: Floats) -> float:
        """The limit, with multipliers that differ by `change` (nc,)."""
        return self.sticking + float(self.gain @ change) if self.sticks else self.limit

    def force(self, lam: Floats) -> Floats:
        if self.sticks:
            return lam[list(self.rows)]
        way = self.way if len(self.rows) == 1 else self.slip + self.way
        length = float(np.linalg.norm(way))
        return np.asarray(-self.limit * (way / length if length > 0.0 else way))


def friction_forces(system: System, here: Flow) -> tuple[FrictionForce, ...]:
    """All frictions that act at the point of `here`, in the order of the model; those under open contacts do not."""
    laws = _laws(system, here)
    change, shared = _shared(system, here, [law for law in laws if law.sticks])
    units = {each.name: force_unit(each) for each in system.flat.events.frictions}
    return tuple(
        FrictionForce(
            name=law.name,
            mode="sticks" if law.sticks else "slides",
            force=tuple((law.factor * law.force(here.lam + change)).tolist()),
            limit=law.factor * law.bears(change),
            unit=units[law.name],
            shared=law.sticks and bool(np.any(shared[list(law.rows)]) or np.any(shared & (law.gain != 0.0))),
        )
        for law in laws
    )


def _laws(system: System, here: Flow) -> list[_Law]:
    """Of frictions that act."""
    if not system.flat.events.frictions:
        return []
    slip, _, limit, sticking, _, gain = system.engine.evaluate("friction", *here.point.arguments, here.qdd, here.lam)
    layout = system.engine.layout
    w, rows = here.point.w, layout.instants.friction_rows
    return [
        _Law(
            name=each.friction.name,
            rows=rows[each.slips],
            sticks=bool(w[each.sticks] != 0.0),
            slip=slip[each.slips],
            way=w[list(each.directions)],
            limit=float(limit[k]),
            sticking=float(sticking[k]),
            gain=gain[k],
            factor=layout.row_factor(rows[each.slips][0]),
        )
        for k, each in enumerate(placed_frictions(system, w))
        if each.acts
    ]


# ---- shared forces ---------------------------------------------------------------------------------------------------


def _shared(system: System, here: Flow, sticking: Sequence[_Law]) -> tuple[Floats, Flags]:
    """The change (nc,) from the smallest multipliers to those with the largest least reserve; rows that share forces
    with friction that sticks."""
    change, flags = np.zeros(len(here.lam)), np.zeros(len(here.lam), dtype=np.bool_)
    if not sticking:
        return change, flags
    columns = _columns(system, here)
    lengths = np.linalg.norm(columns, axis=0)
    active = np.flatnonzero(lengths > 0.0)
    unit = columns[:, active] / lengths[active]
    free = null_space(unit)
    projection = np.abs(free @ free.T)
    blocks = connected_blocks(sparse(projection > RANK_TOLERANCE))
    for parts in blocks.parts:
        for own in parts.rows:
            without_effect = null_space(unit[:, own]) / lengths[active[own], None]
            laws = [law for law in sticking if {*law.rows} & {*active[own].tolist()}]
            change += _Group(active[own], without_effect, lengths).change(system, here, laws)
            flags[active[own]] = bool(laws)
    return change, flags


def _columns(system: System, here: Flow) -> Floats:
    """Forces (nq, nc) of multipliers of size one on the coordinates, with the loads that these bring along."""
    jacobian = system.engine.evaluate("velocity_constraint", *here.point.arguments)[1]
    if not system.flat.events.feedbacks:
        return jacobian.T
    solved = (*here.point.arguments, here.qdd, here.lam)
    by_multiplier = system.engine.evaluate("load", *solved)[2]
    motion, _, _, of_loads = system.engine.evaluate("load_gain", *solved)
    loads = np.linalg.solve(np.eye(len(of_loads)) - of_loads, by_multiplier)
    return np.asarray(jacobian.T - motion @ loads)


@dataclass(frozen=True, slots=True)
class _Group:
    """Rows (k,) of the constraints that share forces: the multipliers (k, free) without an effect; the lengths (nc,) of
    all rows."""

    rows: NDArray[np.intp]
    shared: Floats
    lengths: Floats

    def change(self, system: System, here: Flow, laws: Sequence[_Law]) -> Floats:
        """(nc,) zero where nothing of the group sticks."""
        from scipy.optimize import linprog

        change, free = np.zeros(len(here.lam)), self.shared.shape[1]
        largest = float(np.max(np.abs(here.lam[self.rows]) * self.lengths[self.rows], initial=0.0))
        if not laws or not largest > 0.0:
            return change
        whole = np.zeros((len(here.lam), free))
        whole[self.rows] = self.shared * largest
        contacts = [row for row in system.engine.layout.instants.contact_rows if row in self.rows]
        # A row of the program: part of the forces, and of the reserve, and what they may be at most.
        table = [(-whole[row], largest / self.lengths[row], here.lam[row]) for row in contacts]
        for law in laws:
            for along in _first_tangents(law, here.lam):
                table.append(self._tangent(law, along, whole, here.lam, largest))
        for _ in range(_MORE):
            left = np.array([[*forces, reserve] for forces, reserve, _ in table])
            right = np.array([most for *_, most in table])
            scale = left[:, -1]  # a row may be of any unit
            found = linprog(
                np.append(np.zeros(free), -1.0),
                A_ub=left / scale[:, None],
                b_ub=right / scale,
                bounds=[*[(None, None)] * free, (None, 1.0)],
            )
            if found.x is None:
                return change
            change = whole @ found.x[:free]
            outside = list(self._outside(laws, here.lam, change, float(found.x[-1]), largest))
            if not outside:
                break
            table += [self._tangent(law, along, whole, here.lam, largest) for law, along in outside]
        return change

    def _tangent(
        self, law: _Law, along: Floats, whole: Floats, lam: Floats, largest: float
    ) -> tuple[Floats, float, float]:
        """along . (lam_t + d_t) + s size <= R_0 with the forces d."""
        rows = list(law.rows)
        forces = along @ whole[rows] - law.gain @ whole
        return forces, largest / self.lengths[rows[0]], law.sticking - float(along @ lam[rows])

    def _outside(
        self, laws: Sequence[_Law], lam: Floats, change: Floats, reserve: float, largest: float
    ) -> Iterator[tuple[_Law, Floats]]:
        """Frictions in a plane whose forces are beyond their discs, less the reserve, and the directions of these."""
        for law in laws:
            force, size = law.force(lam + change), largest / self.lengths[law.rows[0]]
            length = float(np.linalg.norm(force))
            if len(law.rows) > 1 and length + reserve * size > law.bears(change) + _OUTSIDE * size:
                yield law, force / length


def _first_tangents(law: _Law, lam: Floats) -> Floats:
    """(2, 1) of a friction along a line, (4, 2) of one in a plane: along its force, and across."""
    if len(law.rows) == 1:
        return np.array([[1.0], [-1.0]])
    force = law.force(lam)
    length = float(np.linalg.norm(force))
    x, y = force / length if length > 0.0 else (1.0, 0.0)
    return np.array([[x, y], [-x, -y], [-y, x], [y, -x]])
