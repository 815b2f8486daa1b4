"""Rotation matrices of frame steps; columns are the new axes in the old ones. All accept complex numbers, and vectors
of shape (3,) or, at several moments, (3, k); matrices are then (3, 3) or (3, 3, k)."""

from __future__ import annotations

import cmath

import numpy as np

from lagdsl.foundation.numerics.complex_step import Complexes, Number


def turned(axes: Complexes, vector: Complexes) -> Complexes:
    """The vector in the coordinates in which the axes are given."""
    return axes @ vector if axes.ndim == 2 else np.asarray(np.einsum("ijk,jk->ik", axes, vector))


def composed(first: Complexes, second: Complexes) -> Complexes:
    """The product of two matrices."""
    return first @ second if first.ndim == second.ndim == 2 else np.asarray(np.einsum("ijm,jkm->ikm", first, second))


def rotation(axis: int, angle: Number) -> Complexes:
    """A turn about x, y or z (0, 1, 2), counterclockwise seen against the axis."""
    unit = np.zeros(3, np.complex128)
    unit[axis] = 1.0
    return rotation_about(unit if not isinstance(angle, np.ndarray) else unit[:, None], angle)


def rotation_about(axis: Complexes, angle: Number) -> Complexes:
    """Rodrigues' formula R = 1 + sin(a) K + (1 - cos(a)) K^2 with K the skew matrix of the normalised axis."""
    zero = 0 * axis[0]
    x, y, z = axis / np.sqrt((axis * axis).sum(axis=0))
    skew = np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]], dtype=np.complex128)
    sine, cosine = (
        (np.sin(angle), np.cos(angle)) if isinstance(angle, np.ndarray) else (cmath.sin(angle), cmath.cos(angle))
    )
    identity = np.eye(3).reshape(3, 3, *(1 for _ in axis.shape[1:]))
    return np.asarray(identity + sine * skew + (1 - cosine) * composed(skew, skew))


def quaternion_rotation(e: Complexes) -> Complexes:
    """The rotation of e/|e|, scalar first; homogeneous of degree zero in e."""
    s, x, y, z = e
    return np.asarray(
        np.array(
            [
                [s * s + x * x - y * y - z * z, 2 * (x * y - s * z), 2 * (x * z + s * y)],
                [2 * (x * y + s * z), s * s - x * x + y * y - z * z, 2 * (y * z - s * x)],
                [2 * (x * z - s * y), 2 * (y * z + s * x), s * s - x * x - y * y + z * z],
            ]
        )
        / (e * e).sum(axis=0)
    )
