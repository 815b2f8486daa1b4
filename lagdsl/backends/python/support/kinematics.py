"""Position, velocity and Jacobian of one frame or one point of a model."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
Kinematics = Callable[..., tuple[Floats, ...]]


class PointKinematics:
    """A point as functions of t [s], q (..., nq), qd (..., nq), in world components and SI units.

    States z, inputs u, discretes w and parameters p go by keyword, as everywhere; all arguments broadcast.
    """

    def __init__(self, name: str, evaluate: Kinematics, place: int, twist: slice) -> None:
        self.name = name
        self._evaluate = evaluate
        self._place, self._twist = slice(3 * place, 3 * place + 3), twist

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self.name}>"

    def position(self, t: ArrayLike, q: ArrayLike, **rest: ArrayLike) -> Floats:
        """Position in the world, shape (..., 3) [m]."""
        return self._evaluate(t, q, None, **rest)[0][..., self._place]

    def velocity(self, t: ArrayLike, q: ArrayLike, qd: ArrayLike, **rest: ArrayLike) -> Floats:
        """Velocity [m/s], shape (..., 3); of a frame that of its origin, then the angular one [rad/s], (..., 6)."""
        return self._evaluate(t, q, qd, **rest)[2][..., self._twist]

    def jacobian(self, t: ArrayLike, q: ArrayLike, qd: ArrayLike | None = None, **rest: ArrayLike) -> Floats:
        """J, the derivative of the velocity by qd, shape (..., 3, nq), of a frame (..., 6, nq). Velocities of a moving
        support are no part of J qd."""
        return self._evaluate(t, q, qd, **rest)[3][..., self._twist, :]

    def bias_acceleration(self, t: ArrayLike, q: ArrayLike, qd: ArrayLike, **rest: ArrayLike) -> Floats:
        """Acceleration at qdd = 0, shape (..., 3), of a frame (..., 6): the whole one is J qdd and this."""
        return self._evaluate(t, q, qd, **rest)[4][..., self._twist]


class FrameKinematics(PointKinematics):
    """A frame as functions of t [s], q (..., nq), qd (..., nq), in world components and SI units.

    Velocity, bias acceleration and rows of the Jacobian are those of the origin, then the angular ones.
    """

    def __init__(self, name: str, evaluate: Kinematics, place: int, twist: slice) -> None:
        super().__init__(name, evaluate, place, twist)
        self._axes = slice(9 * place, 9 * place + 9)

    def rotation(self, t: ArrayLike, q: ArrayLike, **rest: ArrayLike) -> Floats:
        """Rotation matrix, shape (..., 3, 3): its columns are the axes of the frame in world components."""
        entries = self._evaluate(t, q, None, **rest)[1][..., self._axes]
        return entries.reshape((*entries.shape[:-1], 3, 3))


def frame_of(evaluate: Kinematics, frames: tuple[str, ...], name: str) -> FrameKinematics:
    """Frame `name` of `frames`, whose motion comes first among the results of `evaluate`. Raises KeyError."""
    if name not in frames:
        raise KeyError(f"there is no frame {name!r} here; there are {', '.join(frames) or 'none'}")
    place = frames.index(name)
    return FrameKinematics(name, evaluate, place, slice(6 * place, 6 * place + 6))


def point_of(evaluate: Kinematics, frames: tuple[str, ...], points: tuple[str, ...], name: str) -> PointKinematics:
    """Point `name` of `points`, whose motion comes after that of `frames`. Raises KeyError."""
    if name not in points:
        raise KeyError(f"there is no point {name!r} here; there are {', '.join(points) or 'none'}")
    first = 6 * len(frames) + 3 * points.index(name)
    return PointKinematics(name, evaluate, len(frames) + points.index(name), slice(first, first + 3))
