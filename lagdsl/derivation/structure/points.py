"""Points of the constraint set at which ranks and inertia are probed: deterministic, near the start, within bounds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Protocol

import numpy as np

from lagdsl.derivation.program.program import Layout, Program
from lagdsl.derivation.structure.functions import ProgramFunctions
from lagdsl.derivation.structure.moments import Moment, other_moments
from lagdsl.derivation.structure.names import balance_rows, located
from lagdsl.derivation.structure.regular_mass import shows_regular_mass
from lagdsl.derivation.structure.row_sizes import Look, row_sizes
from lagdsl.foundation.numerics.connected_blocks import Indices, Partition, connected_blocks, entries
from lagdsl.foundation.numerics.levenberg_marquardt import Minimizer, descend
from lagdsl.foundation.numerics.part_by_part import is_positive_definite
from lagdsl.foundation.numerics.rank import Floats, null_space
from lagdsl.foundation.numerics.sparse_matrix import SparseMatrix, sparse, sparse_at
from lagdsl.foundation.record import record
from lagdsl.foundation.units.dimension import Dimension
from lagdsl.language.flat.model import Coordinate, FlatModel

SEED = 20011
# Residuals, as a part of the row's natural size, below which a constraint counts as met; generous, because a
# constraint that only touches (two circles that meet in one point) is approached linearly.
HOLDS = 1e-7
_EXACT = 1e-10
# So many points that the median of a row's lengths hardly depends on which they are.
_SIZED_AT = 8


class Functions(Protocol):
    """The functions of a program at one state; every engine is one."""

    @property
    def layout(self) -> Layout: ...

    @property
    def program(self) -> Program: ...

    def evaluate(self, function: str, *arguments: Floats | float) -> tuple[Floats, ...]: ...


def natural_sizes(coordinates: tuple[Coordinate, ...], components: Sequence[int], start: Floats) -> Floats:
    """Size of a change of order one: `nominal`, else 1 for angles and numbers, else the largest start of the
    same unit in the same component (`Layout.components`). `start` and the result (..., nq)."""
    sizes = np.ones(start.shape)
    lengths = np.where(np.isfinite(start), np.abs(start), 0.0)
    for alike in groups(coordinates, components):
        first = coordinates[alike[0]]
        largest = np.max(lengths[..., alike], axis=-1, keepdims=True)
        if not first.dimension.is_dimensionless:
            sizes[..., alike] = np.where(largest > 0.0, largest, 1.0)
    for index, coordinate in enumerate(coordinates):
        if coordinate.nominal is not None and coordinate.nominal != 0.0:
            sizes[..., index] = abs(coordinate.nominal)
    return sizes


def groups(coordinates: tuple[Coordinate, ...], components: Sequence[int]) -> list[list[int]]:
    """The coordinates of one component and unit, group by group."""
    found: dict[tuple[int, Dimension], list[int]] = {}
    for index, coordinate in enumerate(coordinates):
        component = components[index] if len(components) else 0
        found.setdefault((component, coordinate.dimension), []).append(index)
    return list(found.values())


@record()
class Geometry:
    """The constraints of a model as functions of q alone; everything else is held at its start.

    `row_sizes`, `row_factors` (nc,) and `pattern` (nc, nq): see RowSizes. The entries of J stand where the program has
    them.
    """

    functions: Functions
    t: float
    q: Floats
    qd: Floats
    z: Floats
    u: Floats
    w: Floats
    p: Floats
    sizes: Floats
    row_sizes: Floats
    row_factors: Floats
    pattern: SparseMatrix

    def multiplied(self, functions: Functions) -> Geometry:
        """The same with `functions` whose rows are multiplied by `row_factors`."""
        sizes = self.row_sizes * self.row_factors
        return replace(self, functions=functions, row_sizes=sizes, row_factors=np.ones(len(sizes)))

    @property
    def components(self) -> Indices:
        """Numbers of the components of the coordinates (nq,); all are one where nobody tells."""
        return np.array(self.functions.layout.components[: len(self.q)] or [0] * len(self.q), dtype=np.intp)

    @property
    def moment(self) -> Moment:
        return Moment(self.t, self.z, self.u)

    @property
    def position_rows(self) -> list[int]:
        """Indices of the rows that restrict q itself."""
        return [row for row, level in enumerate(self.functions.layout.position_level) if level]

    def position(self, q: Floats) -> tuple[Floats, SparseMatrix]:
        """phi (nc,) and J (nc, nq), in the branches that relations have there."""
        return self._rows("position_constraint", *self._state(q, self.qd, self._branches(q)))

    def residuals(self, q: Floats) -> Floats:
        """phi (nc,) alone."""
        if isinstance(self.functions, ProgramFunctions):
            return self.functions.result("position_constraint", 0, *self._state(q, self.qd, self._branches(q)))
        return self.position(q)[0]

    def _state(self, q: Floats, qd: Floats, w: Floats) -> tuple[Floats | float, ...]:
        return self.t, q, qd, self.z, self.u, w, self.p

    def _branches(self, q: Floats) -> Floats:
        """The discretes, relations as they stand at q. One that depends on others stands after them."""
        layout = self.functions.layout
        if not layout.instants.switched_rows:  # no row reads them
            return self.w
        relations = np.array([kind == "relation" for kind in layout.kinds], dtype=np.bool_)
        still, free = np.zeros(len(q)), np.zeros(len(layout.constraints))
        w = self.w
        for _ in range(int(np.count_nonzero(relations))):
            (standing,) = self.functions.evaluate("standing", *self._state(q, self.qd, w), still, free)
            before, w = w, np.where(relations, standing, w)
            if np.array_equal(before, w):
                break
        return w

    def velocity(self, q: Floats, qd: Floats) -> tuple[Floats, SparseMatrix]:
        """J qd + b (nc,) and J (nc, nq)."""
        return self._rows("velocity_constraint", *self._state(q, qd, self.w))

    def _rows(self, function: str, *state: Floats | float) -> tuple[Floats, SparseMatrix]:
        own = self.functions
        if isinstance(own, ProgramFunctions):
            return own.rows(function, *state)
        residual, dense = own.evaluate(function, *state)
        places = np.array(own.program.function(function).results[1].places, dtype=np.intp)
        return residual, sparse_at(places, dense.shape, dense.ravel()[places])

    def scaled(self, jacobian: SparseMatrix) -> SparseMatrix:
        """J (nc, nq) of coordinates in their sizes, by the sizes of its rows."""
        values = jacobian.values * self.sizes[jacobian.columns] / self.row_sizes[jacobian.rows]
        return jacobian.with_values(values)

    def mass(self, q: Floats, qd: Floats) -> SparseMatrix:
        own, state = self.functions, self._state(q, qd, self.w)
        return own.mass(*state) if isinstance(own, ProgramFunctions) else sparse(own.evaluate("mass_matrix", *state)[0])

    def mass_in_doubt(self, q: Floats, qd: Floats, rows: SparseMatrix, *, regular: bool = False) -> SparseMatrix | None:
        """M, or None where it is not written out and need not be formed: it is `regular` at another general point, or
        elimination shows that it is, with `rows`, scaled ones of J."""
        own, state = self.functions, self._state(q, qd, self.w)
        if not isinstance(own, ProgramFunctions) or not own.by_columns:
            return self.mass(q, qd)
        if regular and own.momentum_is_finite(*state):
            return None
        unscaled = rows.with_values(rows.values / self.sizes[rows.columns])
        return None if shows_regular_mass(own, state, unscaled) else own.mass(*state)

    def project(self, q: Floats, rows: list[int]) -> Minimizer:
        """The nearest point, in natural sizes, at which the given rows hold; residuals relative to the rows'
        sizes."""
        if not rows:
            return Minimizer(point=q, residual=np.zeros(0), size=0.0)

        def equations(x: Floats) -> tuple[Floats, SparseMatrix]:
            phi, jacobian = self.position(x * self.sizes)
            return phi[rows] / self.row_sizes[rows], self.scaled(jacobian).taken(rows)

        found = descend(equations, q / self.sizes, connected_blocks=self.parts(rows))
        return replace(found, point=found.point * self.sizes, residual=found.residual * self.row_sizes[rows])

    def only(self, rows: list[int]) -> Geometry:
        """The same where nothing but these position rows is asked for: cheap if they are few."""
        own = self.functions
        return replace(self, functions=own.restricted(rows)) if isinstance(own, ProgramFunctions) else self

    def parts(self, rows: list[int]) -> Partition:
        """The independent parts of these rows."""
        return connected_blocks(self.pattern.taken(rows))


def geometry(flat: FlatModel, functions: Functions, p: Floats | None = None, seed: int = SEED) -> Geometry:
    """The constraints of `flat` at its start time and start values; rows are as large as their derivatives usually
    come out, at the start and at points about it."""
    layout = functions.layout
    parameters = np.array(layout.defaults, dtype=np.float64) if p is None else p
    t = flat.experiment.start_time
    q, qd, z, u = functions.evaluate("start", t, parameters)
    sizes = natural_sizes(flat.coordinates, layout.components, q)
    nothing = sparse(np.zeros((0, len(q))))
    open_, closed = _discretes(functions, t, q, qd, z, u, parameters)
    plain = Geometry(functions, t, q, qd, z, u, closed, parameters, sizes, np.zeros(0), np.zeros(0), nothing)
    if not layout.constraints:
        return replace(plain, w=open_)
    points = [q, *random_points(flat.coordinates, q, sizes, _SIZED_AT, seed)]
    # an entry may be zero at the start only, and a row of which a discrete is the switch
    moments = [replace(plain, t=each.t, z=each.z, u=each.u) for each in other_moments(flat, plain.moment)]
    found = row_sizes(
        [_look(plain, point) for point in points],
        [_look(each, q) for each in [*moments, *_branches(flat, plain)]],
        sizes,
        plain.components,
        np.isin(np.arange(len(layout.constraints)), list(balance_rows(flat))),
    )
    pattern, factors = found.pattern, found.factors
    switched = list[int]()  # which coordinates they tie is not seen while they are off
    for item in located(flat):
        if item.constraint.friction:  # lengths of slips are compared with one force
            factors[list(item.rows)] = np.min(factors[list(item.rows)])
        if item.constraint.switched:
            switched += item.rows
    if switched:
        pattern = _filled(pattern, switched)
    return replace(plain, w=open_, row_sizes=found.natural, row_factors=factors, pattern=pattern)


def _filled(pattern: SparseMatrix, rows: list[int]) -> SparseMatrix:
    """With an entry at every column of these rows."""
    whole = pattern.dense()
    whole[rows] = 1.0
    return sparse(whole)


def _look(space: Geometry, q: Floats) -> Look:
    """J at q."""

    def look(error: float) -> SparseMatrix:
        signs = np.random.default_rng(SEED).choice([-1.0, 1.0], len(q) + len(space.p))
        off = 1.0 + error * signs
        return replace(space, p=space.p * off[len(q) :]).velocity(q * off[: len(q)], space.qd)[1]

    return look


def _branches(flat: FlatModel, space: Geometry) -> list[Geometry]:
    """Other truths of relations, Booleans and Integers, where rows depend on them; the same ones in every run."""
    layout = space.functions.layout
    if not any(item.switched for item in flat.constraints):
        return []
    whole = {item.name: 4 if item.kind == "Integer" else 2 for item in flat.events.discretes if item.kind != "Real"}
    counts = {"relation": 2, "timed": 2}
    kinds = zip(layout.discretes, layout.kinds, strict=True)
    values = np.array([whole.get(slot.name, 0) if kind == "variable" else counts.get(kind, 0) for slot, kind in kinds])
    inputs = np.array([2 * flag for flag in layout.instants.whole_inputs or [False] * len(space.u)])
    generator = np.random.default_rng(SEED)

    def chosen(now: Floats, counts: Floats) -> Floats:
        return np.where(counts > 0, np.floor(generator.random(len(now)) * counts), now)

    return [replace(space, w=chosen(space.w, values), u=chosen(space.u, inputs)) for _ in range(_SIZED_AT)]


def _discretes(
    functions: Functions, t: float, q: Floats, qd: Floats, z: Floats, u: Floats, p: Floats
) -> tuple[Floats, Floats]:
    """The discretes of the start, relations as they stand: with contacts open and slips free, and with contacts closed
    and slips held, whose rows have their size then."""
    layout = functions.layout
    if not layout.discretes:
        return np.zeros(0), np.zeros(0)
    (started,) = functions.evaluate("discrete_start", t, p)
    still, free = np.zeros(len(q)), np.zeros(len(layout.constraints))
    (open_,) = functions.evaluate("standing", t, q, qd, z, u, started, p, still, free)
    closed = np.where(np.isin(layout.kinds, ("contact", "sticks")), 1.0, open_)
    return open_, closed


def random_points(
    coordinates: tuple[Coordinate, ...], start: Floats, sizes: Floats, count: int, seed: int = SEED
) -> list[Floats]:
    """`count` points about the start, ever wider apart; the same for every run."""
    generator = np.random.default_rng(seed)
    points = []
    for index in range(count):
        width = 0.4 * 1.2 ** min(index, 12)
        point = start + width * sizes * generator.standard_normal(len(coordinates))
        points.append(_inside(coordinates, point))
    return points


def random_rates(coordinates: tuple[Coordinate, ...], sizes: Floats, count: int, seed: int = SEED) -> list[Floats]:
    """`count` sets of rates of natural size per second."""
    generator = np.random.default_rng(seed + 1)
    return [sizes * generator.standard_normal(len(coordinates)) for _ in range(count)]


@record()
class Probe:
    """A general point of the constraint set with rates of natural size: J there, its rows scaled to size one, M (None
    where it is known to be regular), and how far off the position rows are, as a part of their sizes."""

    q: Floats
    rows: SparseMatrix
    mass: SparseMatrix | None
    residual: float


def probes(
    flat: FlatModel, space: Geometry, rows: list[int], *, wanted: int = 3, tries: int = 24, seed: int = SEED
) -> list[Probe]:
    """Up to `wanted` general points at which the position rows hold and the functions are finite.

    They lie on the branch of the constraint set on which the motion starts, found by walking along it: ranks may differ
    between branches (an overconstrained linkage is mobile on one and rigid on the other), and from a singular start the
    walk leads onto a branch that passes through it. Rows that depend on each other on the constraint set only look
    independent beside it by as much as the residual, so points where the rows hold by and large are taken only if there
    are no others.

    If the functions exist near the start only (roots, logarithms), the steps become shorter and shorter; the start
    itself is the last resort.
    """
    found: list[Probe] = []
    rough: list[Probe] = []
    regular = False  # M at one of them, and so at general ones
    base = space.project(space.q, rows)
    here = base.point if base.size <= HOLDS else space.q
    scale = 1.0
    directions = random_points(flat.coordinates, space.q, space.sizes, tries, seed)
    for direction, rates in zip(directions, random_rates(flat.coordinates, space.sizes, tries, seed), strict=True):
        step = _tangent(space, here, rows, (direction - space.q) / space.sizes) * space.sizes
        probe = _probe(space, _inside(flat.coordinates, here + scale * step), rates, rows, regular)
        if probe is None:
            scale *= 0.6
        else:
            regular = regular or _is_regular(space, probe.mass)
            kept = found if probe.residual <= _EXACT else rough
            kept.append(_sharing(probe, kept[-1]) if kept else probe)
            here = probe.q
        if len(found) == wanted:
            return found
    last = _probe(space, space.q, space.qd, rows, regular)
    return found or rough[:wanted] or ([last] if last is not None else [])


def _is_regular(space: Geometry, mass: SparseMatrix | None) -> bool:
    """True if that is asked of no further M."""
    by_columns = isinstance(space.functions, ProgramFunctions) and space.functions.by_columns
    return by_columns and (mass is None or is_positive_definite(mass))


def _sharing(probe: Probe, other: Probe) -> Probe:
    """The same without matrices of its own where those of another point are equal: constants of a large circuit."""
    rows = other.rows if _are_equal(probe.rows, other.rows) else probe.rows
    alike = probe.mass is not None and other.mass is not None and _are_equal(probe.mass, other.mass)
    return replace(probe, rows=rows, mass=other.mass if alike else probe.mass)


def _are_equal(one: SparseMatrix, other: SparseMatrix) -> bool:
    pairs = ((one.rows, other.rows), (one.columns, other.columns), (one.values, other.values))
    return all(np.array_equal(*pair) for pair in pairs)


def _tangent(space: Geometry, q: Floats, rows: list[int], direction: Floats) -> Floats:
    """The part of `direction` that the position rows leave free at q; all in natural sizes."""
    jacobian = space.scaled(space.position(q)[1]).taken(rows)
    if not jacobian.is_finite():
        return direction
    result = direction.copy()
    jacobian = jacobian.nonzero()  # open contacts tie nothing
    for parts in connected_blocks(jacobian).parts:
        for block, columns in zip(entries(jacobian, parts), parts.columns, strict=True):
            free = null_space(block, 1e-6)
            result[columns] = free @ (free.T @ direction[columns])
    return result


def _inside(coordinates: tuple[Coordinate, ...], q: Floats) -> Floats:
    """q within the bounds of the coordinates."""
    lower = np.array([-np.inf if c.minimum is None else c.minimum for c in coordinates])
    upper = np.array([np.inf if c.maximum is None else c.maximum for c in coordinates])
    return np.clip(q, lower, upper)


def _probe(space: Geometry, start: Floats, rates: Floats, rows: list[int], regular: bool) -> Probe | None:
    """The point nearest to `start`; None where there is none or a function is not finite. `regular`: M is elsewhere."""
    result = space.project(start, rows)
    if result.size > HOLDS:
        return None
    scaled = space.scaled(space.velocity(result.point, space.qd)[1])
    mass = space.mass_in_doubt(result.point, rates, scaled, regular=regular)
    if not scaled.is_finite() or (mass is not None and not mass.is_finite()):
        return None
    return Probe(result.point, scaled, mass, result.size)
