"""Bodies that turn steadily in a quaternion: the linearized motion in axes that move along with it.

A steady rotation e(t) = exp(s t/2) o e(0) o exp(b t/2) turns at s about axes of the frame that e is given against, and
at b about axes of the body. All four numbers run and all have an influence, so they are no ignorable coordinates. But
where the motion is the same after such a rotation, G = exp(X t) with de/dt = X e, the derivatives A along the motion
are G A G^-1, and those of the deviations in turning axes are A - X: constant. Its eigenvalues decide.
Source: Marsden, Lectures on Mechanics, chapter 5 (relative equilibria); quaternions: Shuster, A survey of attitude
representations, Journal of the Astronautical Sciences 41 (1993) 439-517.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import islice, product

import numpy as np

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.traversal import postorder
from lagdsl.motion.analysis.linearize import Reduced
from lagdsl.motion.analysis.point import Point, System

# Angular velocities below this, as a part of the fastest rates, are none; accelerations likewise.
_RESTS = 1e-9
_ROUNDING = 1e-14
# So many ways of shared turning are tried: two for each quaternion.
_MOST_TRIED = 32


@dataclass(frozen=True, slots=True)
class Turning:
    """dq/dt = X q of the steady rotation; `generator` X (nq, nq) is zero but for quaternions. `names` are those that
    turn, `with_body` tells that the axes turn with some of the bodies."""

    generator: Floats
    names: tuple[str, ...]
    with_body: bool

    def turned(self, point: Point, time: float) -> tuple[Point, Floats]:
        """The point on the motion that the rotation alone leads to in this time, and exp(X time)."""
        from scipy.linalg import expm

        group = np.asarray(expm(self.generator * time))
        return replace(point, q=group @ point.q, qd=group @ point.qd), group

    def relative(self, at: Reduced) -> Reduced:
        """`at` with F - X x and A - X in the place of F and A."""
        point, states = at.flow.point, len(at.value)
        flow = self._applied(at, point.q[None], point.qd[None])[0]
        along = self._applied(at, at.along.q[:states], at.along.qd[:states]).T
        a = at.a - along
        a[np.abs(a) <= _ROUNDING * self._entry_sizes(at, along)] = 0.0
        value = at.value - flow
        value[np.abs(value) <= _ROUNDING * (np.abs(at.value) + np.abs(flow))] = 0.0
        return replace(at, value=value, a=a)

    def _entry_sizes(self, at: Reduced, along: Floats) -> Floats:
        """Scales of the entries of A - X, by which zeros are zeros: the numbers that they are differences of, and
        between numbers of quaternions that turn the powers of their pace. Round-off would make pairs of eigenvalues of
        double zeros."""
        sizes = np.abs(at.a) + np.abs(along)
        turning = np.flatnonzero(np.any(self.generator != 0.0, axis=1))
        places = (*at.partition.position, *at.partition.rate)
        rows = [row for row, place in enumerate(places) if place in turning]
        order = np.array([float(row >= len(at.partition.position)) for row in rows])
        power = 1.0 + order[:, None] - order
        own = np.ix_(rows, rows)
        pace = float(np.max(sizes[own] ** (1.0 / np.maximum(power, 1.0)), initial=0.0, where=power > 0.0))
        sizes[own] = np.maximum(sizes[own], pace**power)
        return sizes

    def _applied(self, at: Reduced, q: Floats, qd: Floats) -> Floats:
        """X of directions, one a row, in the minimal state."""
        return in_chart(at, q @ self.generator.T, qd @ self.generator.T, np.zeros((len(q), len(at.flow.point.z))))


def in_chart(at: Reduced, q: Floats, qd: Floats, z: Floats) -> Floats:
    """Directions, one a row, by their entries of the minimal state."""
    return np.hstack([q[:, list(at.partition.position)], qd[:, list(at.partition.rate)], z])


def turnings(system: System, at: Reduced) -> Iterator[Turning]:
    """Steady rotations that lead through the point with its rates, those in axes that do not turn with bodies first."""
    found = [each for each in (_Spin.at(system, at, *named) for named in _quaternions(system)) if each is not None]
    if not found:
        return
    free = [not spin.bends for spin in found]
    shares: list[tuple[float, ...]] = [(share,) for share in _bent_shares(found, at)]
    choices = [(0.0, 1.0) if each else shares[k] for k, each in enumerate(free)]
    for chosen in islice(product(*choices), _MOST_TRIED):
        generator = sum(spin.generator(share) for spin, share in zip(found, chosen, strict=True))
        with_body = any(share == 1.0 for share, each in zip(chosen, free, strict=True) if each)
        yield Turning(np.asarray(generator), tuple(spin.name for spin in found), with_body)


@dataclass(frozen=True, slots=True)
class _Spin:
    """One quaternion that turns: `omega` and its rate `alpha` against the frame it is given against, in axes of that.

    s = omega x alpha/omega^2 + share omega for some share: then s x omega = alpha.
    """

    name: str
    places: tuple[int, ...]
    size: int
    e: Floats
    omega: Floats
    alpha: Floats

    @classmethod
    def at(cls, system: System, at: Reduced, name: str, places: tuple[int, ...]) -> _Spin | None:
        """None if it does not turn."""
        point = at.flow.point
        chosen = list(places)
        e, rate, acceleration = point.q[chosen], point.qd[chosen], at.flow.qdd[chosen]
        omega = 2.0 * (_right(e).T @ rate)[1:]
        alpha = 2.0 * (_right(e).T @ acceleration)[1:]
        fastest = float(np.max(np.abs(point.qd), initial=0.0))
        if float(np.linalg.norm(omega)) <= _RESTS * fastest or not fastest:
            return None
        return cls(name, places, len(point.q), e, omega, alpha)

    @property
    def bends(self) -> bool:
        """True if the axis moves."""
        return float(np.linalg.norm(self.alpha)) > _RESTS * float(self.omega @ self.omega)

    def generator(self, share: float) -> Floats:
        space = np.cross(self.omega, self.alpha) / (self.omega @ self.omega) + share * self.omega
        body = _rotation(self.e).T @ (self.omega - space)
        result = np.zeros((self.size, self.size))
        quarter = 0.5 * (_left(np.concatenate([[0.0], space])) + _right(np.concatenate([[0.0], body])))
        result[np.ix_(self.places, self.places)] = quarter
        return result


def _bent_shares(found: list[_Spin], at: Reduced) -> list[float]:
    """The shares with which the acceleration stays what it is in turning axes: A F = X F, by least squares."""
    rates = at.a @ at.value
    point = at.flow.point
    q, qd, none = point.qd[None], at.flow.qdd[None], np.zeros((1, len(point.z)))

    def moved(generator: Floats) -> Floats:
        return np.asarray(in_chart(at, q @ generator.T, qd @ generator.T, none)[0])

    base = [moved(spin.generator(0.0)) for spin in found]
    slopes = [moved(spin.generator(1.0)) - rest for spin, rest in zip(found, base, strict=True)]
    # Only the entries of quaternions are theirs.
    rows = [row for row, place in enumerate((*at.partition.position, *at.partition.rate)) if _is_place(found, place)]
    right = (rates - np.sum(base, axis=0))[rows]
    return [float(share) for share in np.linalg.lstsq(np.array(slopes).T[rows], right, rcond=1e-9)[0]]


def _is_place(found: list[_Spin], place: int) -> bool:
    return any(place in spin.places for spin in found)


def _quaternions(system: System) -> Iterator[tuple[str, tuple[int, ...]]]:
    """Each with the places of its four numbers."""
    places = {coordinate.name: place for place, coordinate in enumerate(system.flat.coordinates)}
    for constraint in system.flat.constraints:
        if constraint.normalisation:
            nodes = (node for node in postorder(constraint.residuals[0], {}) if isinstance(node, fx.Variable))
            names = sorted({node.name for node in nodes if node.name in places}, key=places.__getitem__)
            yield constraint.name.removeprefix("norm(").removesuffix(")"), tuple(places[name] for name in names)


def _left(a: Floats) -> Floats:
    """The matrix of e -> a o e (Hamilton's product, scalar first)."""
    w, x, y, z = a
    return np.array([[w, -x, -y, -z], [x, w, -z, y], [y, z, w, -x], [z, -y, x, w]])


def _right(a: Floats) -> Floats:
    """The matrix of e -> e o a."""
    w, x, y, z = a
    return np.array([[w, -x, -y, -z], [x, w, z, -y], [y, -z, w, x], [z, y, -x, w]])


def _rotation(e: Floats) -> Floats:
    """Of a unit quaternion, (3, 3)."""
    return np.asarray((_left(e) @ _right(e).T)[1:, 1:])
