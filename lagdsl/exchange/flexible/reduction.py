"""Craig and Bampton's reduction of a free body: R. R. Craig and M. C. C. Bampton, AIAA J. 6 (1968) 1313.

Interfaces are sets of nodes that a rigid motion of a point ties together. The first one is held: the six rigid motions,
which the floating frame carries, are those of this interface and leave the reduced body. The basis has the static
shapes of the other interfaces and the modes with all of them held; the modes of both together, with the first interface
held, are orthogonal in both matrices.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from scipy import linalg, sparse
from scipy.sparse.linalg import LinearOperator, eigsh, splu

from lagdsl.exchange.flexible.matrices import Floats, Integers, Sparse
from lagdsl.exchange.flexible.refusal import Refused
from lagdsl.foundation.record import record

_SINGULAR = 1e-13
"""Of the largest pivot: below it there are only rounding errors of the sum of stiffnesses."""


@record(kw_only=True)
class Interface:
    """Nodes, by their place in the matrices, that move with a rigid point."""

    name: str
    point: Floats
    members: Integers


@record(kw_only=True)
class Reduction:
    """Modes of a body that is held at its first interface, lowest frequency first.

    `shapes` [nodes, 3, n] has 1 as its largest displacement of each mode; `mass` [n] and `stiffness` [n] are the
    diagonal matrices; `motions` [interfaces, 6, n] the displacements and turns of the interfaces. `response` solves the
    static equations of the whole body for loads [unknowns, k].
    """

    shapes: Floats
    mass: Floats
    stiffness: Floats
    motions: Floats
    response: Callable[[Floats], Floats]


def rigid_motions(places: Floats, share: Floats | None = None) -> Floats:
    """Displacements [3*nodes, 6] of nodes at `places` [nodes, 3] by three translations and three turns about 0.

    `share` [nodes] is 1 of nodes and 0 of unknowns inside elements, whose shapes are no part of a rigid motion.
    """
    count = len(places)
    motions = np.zeros((count, 3, 6))
    motions[:, :, :3] = np.eye(3) if share is None else np.multiply.outer(share, np.eye(3))
    for k, axis in enumerate(np.eye(3)):
        motions[:, :, 3 + k] = np.cross(axis, places)
    return motions.reshape(3 * count, 6)


def reduced(
    stiffness: Sparse, mass: Sparse, places: Floats, share: Floats, interfaces: Sequence[Interface], modes: int
) -> Reduction:
    """The reduction of a body with `modes` modes beside the static shapes; `share` as in `rigid_motions`.

    Raises Refused, E1213 to E1215.
    """
    tie, inner = _ties(places, interfaces)
    tied_stiffness, tied_mass = (sparse.csc_array(tie.T @ matrix @ tie) for matrix in (stiffness, mass))
    outer = tie.shape[1] - inner
    if inner < 1 or modes > inner:
        raise Refused("E1214", None, modes=modes, most=inner)
    factor = _factor(sparse.csc_matrix(tied_stiffness[:inner, :inner]))
    static = -_solved(factor, tied_stiffness[:inner, inner:].toarray())
    fixed = _fixed_modes(tied_stiffness[:inner, :inner], tied_mass[:inner, :inner], factor, modes)
    basis = np.zeros((inner + outer, modes + outer))
    basis[:inner, :modes], basis[:inner, modes:] = fixed, static
    basis[inner:, modes:] = np.eye(outer)
    small = [basis.T @ (matrix @ basis) for matrix in (tied_stiffness, tied_mass)]
    try:
        values, vectors = linalg.eigh(*(0.5 * (matrix + matrix.T) for matrix in small))
    except linalg.LinAlgError:
        raise Refused("E1215", None, reason="not positive definite") from None
    if values[0] <= 0 or not np.isfinite(values).all():
        raise Refused("E1213", None)
    all_shapes = basis @ vectors
    shapes = (tie @ all_shapes).reshape(len(places), 3, -1)
    scale = _scales(shapes[share > 0])
    motions = np.concatenate([np.zeros((6, len(values))), all_shapes[inner:]]).reshape(-1, 6, len(values))
    coupling = tied_stiffness[inner:, inner:].toarray() + tied_stiffness[inner:, :inner] @ static

    def response(loads: Floats) -> Floats:
        given = tie.T @ loads
        ends = np.linalg.solve(coupling, given[inner:] + static.T @ given[:inner])
        return np.asarray(tie @ np.concatenate([_solved(factor, given[:inner]) + static @ ends, ends]))

    return Reduction(
        shapes=shapes / scale,
        mass=1 / scale**2,
        stiffness=values / scale**2,
        motions=motions / scale,
        response=response,
    )


def _ties(places: Floats, interfaces: Sequence[Interface]) -> tuple[Sparse, int]:
    """All displacements by those of the inner nodes and the motions of all interfaces but the first; how many are
    inner."""
    count = len(places)
    owner = np.full(count, -1)
    for k, interface in enumerate(interfaces):
        owner[interface.members] = k
    free = np.flatnonzero(owner < 0)
    inner = 3 * len(free)
    rows = [(3 * free[:, None] + np.arange(3)).ravel()]
    columns = [np.arange(inner)]
    values = [np.ones(inner)]
    for k, interface in enumerate(interfaces[1:]):
        own = (3 * interface.members[:, None] + np.arange(3)).ravel()
        block = rigid_motions(places[interface.members] - interface.point)
        rows.append(np.repeat(own, 6))
        columns.append(np.tile(inner + 6 * k + np.arange(6), len(own)))
        values.append(block.ravel())
    shape = (3 * count, inner + 6 * (len(interfaces) - 1))
    together = (np.concatenate(values), (np.concatenate(rows), np.concatenate(columns)))
    return sparse.csr_array(together, shape=shape), inner


def _factor(matrix: Sparse) -> Any:
    """LU factors of a stiffness matrix, symmetric pivots first. Raises Refused, E1213, where it is singular."""
    try:
        factor = splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    except RuntimeError:  # SuperLU: "Factor is exactly singular"
        raise Refused("E1213", None) from None
    pivots = np.abs(factor.U.diagonal())
    if not pivots.min() > _SINGULAR * pivots.max():
        raise Refused("E1213", None)
    return factor


def _solved(factor: Any, loads: Floats) -> Floats:
    return np.asarray(factor.solve(np.ascontiguousarray(loads))) if loads.size else loads


def _fixed_modes(stiffness: Sparse, mass: Sparse, factor: Any, modes: int) -> Floats:
    """The lowest modes with all interfaces held, by shift and invert about 0; the start of the iteration is always the
    same one."""
    size = stiffness.shape[0]
    if modes == 0:
        return np.zeros((size, 0))
    if size <= _DENSE or modes >= size - 1:
        try:
            vectors = linalg.eigh(stiffness.toarray(), mass.toarray(), subset_by_index=[0, modes - 1])[1]
        except linalg.LinAlgError:
            raise Refused("E1215", None, reason="not positive definite") from None
        return np.asarray(vectors)
    inverse = LinearOperator((size, size), matvec=factor.solve, dtype=np.float64)
    start = np.linspace(1, 2, size)
    try:
        values, vectors = eigsh(stiffness, modes, mass, sigma=0, OPinv=inverse, v0=start, tol=0)
    except (RuntimeError, ValueError):  # ArpackError is a RuntimeError: a mass matrix that is not definite
        raise Refused("E1215", None, reason="not positive definite") from None
    return np.asarray(vectors[:, np.argsort(values)])


_DENSE = 200
"""Unknowns up to which the dense solver is as fast as the iteration."""


def _scales(shapes: Floats) -> Floats:
    """The largest displacement of each mode, with the sign that makes its largest component positive."""
    count = shapes.shape[2]
    largest = np.linalg.norm(shapes, axis=1).max(axis=0)
    flat = shapes.reshape(-1, count)
    sizes = np.round(np.abs(flat) / np.abs(flat).max(axis=0), 6)
    return np.asarray(largest * np.sign(flat[np.argmax(sizes, axis=0), np.arange(count)]))
