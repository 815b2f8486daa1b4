"""Rotation matrices of frame steps; columns are the new axes in the old ones. All accept complex numbers."""

from __future__ import annotations

import cmath

import numpy as np
from numpy.typing import NDArray

Complexes = NDArray[np.complex128]


def rotation(axis: int, angle: complex) -> Complexes:
    """A turn about x, y or z (0, 1, 2), counterclockwise seen against the axis."""
    unit = np.zeros(3, np.complex128)
    unit[axis] = 1.0
    return rotation_about(unit, angle)


def rotation_about(axis: Complexes, angle: complex) -> Complexes:
    """Rodrigues' formula R = 1 + sin(a) K + (1 - cos(a)) K^2 with K the skew matrix of the normalised axis."""
    x, y, z = axis / cmath.sqrt(complex(axis @ axis))
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]], dtype=np.complex128)
    return np.eye(3) + cmath.sin(angle) * skew + (1 - cmath.cos(angle)) * (skew @ skew)


def quaternion_rotation(e: Complexes) -> Complexes:
    """The rotation of e/|e|, scalar first; homogeneous of degree zero in e."""
    s, x, y, z = e
    return np.array(
        [
            [s * s + x * x - y * y - z * z, 2 * (x * y - s * z), 2 * (x * z + s * y)],
            [2 * (x * y + s * z), s * s - x * x + y * y - z * z, 2 * (y * z - s * x)],
            [2 * (x * z - s * y), 2 * (y * z + s * x), s * s - x * x - y * y + z * z],
        ]
    ) / complex(e @ e)
