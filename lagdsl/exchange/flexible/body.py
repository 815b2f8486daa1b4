"""A body with small deformations as data: all that `Lag.Flexible.ModalBody` asks for, in SI units."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from lagdsl.foundation.record import record

Floats = NDArray[np.float64]
PAIRS = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
"""Elements of a symmetric tensor in the order xx, yy, zz, xy, xz, yz."""
PERMUTATION = np.zeros((3, 3, 3))
PERMUTATION[[0, 1, 2], [1, 2, 0], [2, 0, 1]] = 1
PERMUTATION[[0, 1, 2], [2, 0, 1], [1, 2, 0]] = -1


@record(kw_only=True)
class Station:
    """A node with a frame: place at rest [3], displacement [3, n] and turn [3, n] by each mode, second derivative of
    the displacement [3, n, n]."""

    name: str
    place: Floats
    shape: Floats
    turn: Floats
    shape2: Floats


@record(kw_only=True)
class Wire:
    """Points [w, 3] with their shapes [w, 3, n], and pairs of points, from 0 on, between which a line is drawn."""

    points: Floats
    shapes: Floats
    edges: tuple[tuple[int, int], ...]


@record(kw_only=True)
class Body:
    """Data of a body in axes of its floating frame. The names are those of the parameters of ModalBody; `inertia`
    [3, 3] is I, `inertia1` [6, n] and `inertia2` [6, n, n] are I1 and I2."""

    mass: float
    com: Floats
    inertia: Floats
    M: Floats
    K: Floats
    D: Floats
    S: Floats
    H: Floats
    inertia1: Floats
    inertia2: Floats
    S2: Floats
    H2: Floats
    stations: tuple[Station, ...]
    wire: Wire | None


def arrays(body: Body) -> tuple[Floats, ...]:
    """All numbers of a body."""
    stations = [part for each in body.stations for part in (each.place, each.shape, each.turn, each.shape2)]
    wire = [] if body.wire is None else [body.wire.points, body.wire.shapes]
    own = [body.com, body.inertia, body.M, body.K, body.D, body.S, body.H, body.S2, body.H2]
    return (np.array(body.mass), *own, body.inertia1, body.inertia2, *stations, *wire)


@record(kw_only=True)
class Moments:
    """Integrals over the mass about the origin of the floating frame, with their derivatives by the modes.

    First moment `first` [3], its derivatives `S` [3, n] and `S2` [3, n, n]; inertia tensor `inertia` [3, 3], `inertia1`
    [3, 3, n], `inertia2` [3, 3, n, n]; angular momentum `H` [3, n] of each mode and its derivative `H2` [3, l, k] by
    mode l.
    """

    mass: float
    first: Floats
    S: Floats
    S2: Floats
    inertia: Floats
    inertia1: Floats
    inertia2: Floats
    H: Floats
    H2: Floats


def central(about: Moments) -> Moments:
    """The same integrals about the mass center of the deformed body, with Steiner's terms to the second order; `first`
    is the place of the mass center at rest.

    `H2` is the part that changes its sign with the order of the modes: the products of two shapes. The other part comes
    from displacements of second order. With it, and without its square, the kinetic energy would not be positive.
    """
    m = about.mass
    com = about.first / m
    return Moments(
        mass=m,
        first=com,
        S=about.S,
        S2=about.S2,
        inertia=about.inertia - m * _steiner(com, com) / 2,
        inertia1=about.inertia1 - _steiner(com, about.S),
        inertia2=about.inertia2 - _steiner(com, about.S2) - _products(about.S) / m,
        H=about.H - np.einsum("iab,a,bk->ik", PERMUTATION, com, about.S),
        H2=0.5 * (about.H2 - about.H2.swapaxes(1, 2)) - np.einsum("iab,al,bk->ilk", PERMUTATION, about.S, about.S) / m,
    )


def body_of(
    about: Moments, mass: Floats, stiffness: Floats, damping: Floats, stations: tuple[Station, ...], wire: Wire | None
) -> Body:
    """The body of integrals about its mass center and of the matrices [n, n] of its modes."""
    return Body(
        mass=about.mass,
        com=about.first,
        inertia=about.inertia,
        M=mass,
        K=stiffness,
        D=damping,
        S=about.S,
        H=about.H,
        inertia1=_six(about.inertia1),
        inertia2=_six(about.inertia2),
        S2=about.S2,
        H2=about.H2,
        stations=stations,
        wire=wire,
    )


def _steiner(com: Floats, moments: Floats) -> Floats:
    """2 (c . p) 1 - c p' - p c' for each moment p [3, ...]."""
    mixed = np.multiply.outer(com, moments)
    trace = 2 * np.tensordot(com, moments, axes=(0, 0))
    return np.asarray(np.multiply.outer(np.eye(3), trace) - mixed - np.swapaxes(mixed, 0, 1))


def _products(moments: Floats) -> Floats:
    """2 (p . q) 1 - p q' - q p' for the moments of each pair of modes: the second derivatives of m (d.d 1 - d d')."""
    mixed = np.einsum("ik,jl->ijkl", moments, moments)
    trace = 2 * np.einsum("ik,il->kl", moments, moments)
    return np.asarray(np.multiply.outer(np.eye(3), trace) - mixed - np.swapaxes(mixed, 0, 1))


def _six(tensor: Floats) -> Floats:
    """xx, yy, zz, xy, xz, yz of symmetric tensors [3, 3, ...]."""
    return np.stack([tensor[i, j] for i, j in PAIRS])
