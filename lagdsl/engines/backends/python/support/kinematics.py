"""Position, velocity and Jacobian of one frame or one point of a model."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lagdsl.engines.backends.python.support.values import Call, Entries, Starts, State, by_names, into, no_start

Floats = NDArray[np.float64]
Kinematics = Callable[..., tuple[Floats, ...]]
_MATRIX = 3  # which result is one


class PointKinematics:
    """A point as functions of t [s], q (..., nq), qd (..., nq), in world components and SI units.

    States z, inputs u, discretes w and parameters p go by keyword, as everywhere; all arguments broadcast, and `out` is
    an array for the result. Without q the state is that of the start, with the values `start` by name.
    """

    def __init__(self, name: str, own: Any, calls: Mapping[str, Call]) -> None:
        """`calls` are the functions below by their names; each gets `own` as its first argument."""
        self.name = name
        self._own, self._calls = own, calls

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.name}>"

    def _by_names(self, state: State, start: Starts | None, inputs: Any, parameters: Entries | None) -> State:
        """t, q, qd, z, u, w, p, of which some have other names or are those of the start. Raises ValueError."""
        return by_names(state, start, inputs, parameters, no_start)

    def position(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        *,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        start: Starts | None = None,
        inputs: Entries | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """Position in the world, shape (..., 3) [m]."""
        if q is None or start is not None or inputs is not None or parameters is not None:
            t, q, _, z, u, w, p = self._by_names((t, q, None, z, u, w, p), start, inputs, parameters)
        return self._calls["position"](self._own, t, q, None, z, u, w, p, None, out)

    def velocity(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        qd: Entries | None = None,
        *,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        start: Starts | None = None,
        inputs: Entries | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """Velocity [m/s], shape (..., 3); of a frame that of its origin, then the angular one [rad/s], (..., 6)."""
        if q is None or start is not None or inputs is not None or parameters is not None:
            t, q, qd, z, u, w, p = self._by_names((t, q, qd, z, u, w, p), start, inputs, parameters)
        return self._calls["velocity"](self._own, t, q, qd, z, u, w, p, None, out)

    def jacobian(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        qd: Entries | None = None,
        *,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        start: Starts | None = None,
        inputs: Entries | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """J, the derivative of the velocity by qd, shape (..., 3, nq), of a frame (..., 6, nq). Velocities of a moving
        support are no part of J qd."""
        if q is None or start is not None or inputs is not None or parameters is not None:
            t, q, qd, z, u, w, p = self._by_names((t, q, qd, z, u, w, p), start, inputs, parameters)
        return self._calls["jacobian"](self._own, t, q, qd, z, u, w, p, None, out)

    def bias_acceleration(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        qd: Entries | None = None,
        *,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        start: Starts | None = None,
        inputs: Entries | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """Acceleration at qdd = 0, shape (..., 3), of a frame (..., 6): the whole one is J qdd and this."""
        if q is None or start is not None or inputs is not None or parameters is not None:
            t, q, qd, z, u, w, p = self._by_names((t, q, qd, z, u, w, p), start, inputs, parameters)
        return self._calls["bias_acceleration"](self._own, t, q, qd, z, u, w, p, None, out)


class FrameKinematics(PointKinematics):
    """A frame as functions of t [s], q (..., nq), qd (..., nq), in world components and SI units.

    Velocity, bias acceleration and rows of the Jacobian are those of the origin, then the angular ones.
    """

    def rotation(
        self,
        t: ArrayLike | None = None,
        q: Entries | None = None,
        *,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        start: Starts | None = None,
        inputs: Entries | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """Rotation matrix, shape (..., 3, 3): its columns are the axes of the frame in world components."""
        if q is None or start is not None or inputs is not None or parameters is not None:
            t, q, _, z, u, w, p = self._by_names((t, q, None, z, u, w, p), start, inputs, parameters)
        return self._calls["rotation"](self._own, t, q, None, z, u, w, p, None, out)


def frame_of(evaluate: Kinematics, frames: tuple[str, ...], name: str) -> FrameKinematics:
    """Frame `name` of `frames`, whose motion comes first among the results of `evaluate`. Raises KeyError."""
    if name not in frames:
        raise KeyError(f"there is no frame {name!r} here; there are {', '.join(frames) or 'none'}")
    place = frames.index(name)
    return FrameKinematics(name, evaluate, kinematic_calls(place, slice(6 * place, 6 * place + 6)))


def point_of(evaluate: Kinematics, frames: tuple[str, ...], points: tuple[str, ...], name: str) -> PointKinematics:
    """Point `name` of `points`, whose motion comes after that of `frames`. Raises KeyError."""
    if name not in points:
        raise KeyError(f"there is no point {name!r} here; there are {', '.join(points) or 'none'}")
    first = 6 * len(frames) + 3 * points.index(name)
    return PointKinematics(name, evaluate, kinematic_calls(len(frames) + points.index(name), slice(first, first + 3)))


def kinematic_calls(place: int, twist: slice) -> dict[str, Call]:
    """The functions of the frame or point at this place, over leading axes; their first argument is the function
    `kinematics` of t, q, qd, z, u, w, p."""
    return {
        "position": _Picked(0, slice(3 * place, 3 * place + 3)),
        "rotation": _Picked(1, slice(9 * place, 9 * place + 9), (3, 3)),
        "velocity": _Picked(2, twist),
        "jacobian": _Picked(3, twist),
        "bias_acceleration": _Picked(4, twist),
    }


class _Picked:
    """Some entries of a result, of a matrix some rows; `shape` is another one for them."""

    def __init__(self, block: int, entries: slice, shape: tuple[int, ...] = ()) -> None:
        self._block, self._entries, self._shape = block, entries, shape

    def __call__(self, own: Kinematics, *arguments: Any) -> Floats:
        *state, _, out = arguments
        found = own(*state)[self._block]
        value = found[..., self._entries, :] if self._block == _MATRIX else found[..., self._entries]
        value = value.reshape((*value.shape[:-1], *self._shape)) if self._shape else value
        return value if out is None else into(out, value)
