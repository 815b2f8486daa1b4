"""Turns and places as matrices, and as the fixed-axis angles of the text."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from lagdsl.exchange.robots.description import Pose, Vector
from lagdsl.exchange.robots.inertia import rotation

Floats = NDArray[np.float64]
_SMALL = 1e-15


def matrix_of(quaternion: Floats) -> Floats:
    """The rotation matrix of a quaternion, scalar first."""
    w, x, y, z = quaternion / np.linalg.norm(quaternion)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def turn_about(axis: Floats, angle: float) -> Floats:
    """The rotation matrix of a turn by an angle [rad] about an axis."""
    return matrix_of(np.array([math.cos(angle / 2), *(math.sin(angle / 2) * axis / np.linalg.norm(axis))]))


def fixed_angles(matrix: Floats) -> Vector:
    """Roll, pitch, yaw of Rz(yaw) Ry(pitch) Rx(roll), near the vertical pitch, too.

    Roll is found in the axes that yaw has turned: an error of yaw, which nothing determines there, is made good.
    """
    m = matrix
    yaw = math.atan2(m[1, 0], m[0, 0]) if math.hypot(m[0, 0], m[1, 0]) > _SMALL else 0.0
    c, s = math.cos(yaw), math.sin(yaw)
    pitch = math.atan2(-m[2, 0], c * m[0, 0] + s * m[1, 0])
    roll = math.atan2(s * m[0, 2] - c * m[1, 2], c * m[1, 1] - s * m[0, 1])
    if abs(roll) > math.pi / 2 and abs(yaw) > math.pi / 2:  # a turn about y alone is written as one
        roll, pitch, yaw = (math.remainder(a, 2 * math.pi) for a in (roll + math.pi, math.pi - pitch, yaw + math.pi))
    return _snapped(roll), _snapped(pitch), _snapped(yaw)


def _snapped(angle: float) -> float:
    """The whole number of degrees next to it where a rounding error separates them."""
    degrees = math.radians(round(math.degrees(angle)))
    return degrees if abs(angle - degrees) < 4 * _SMALL else angle


def vector_of(values: Floats) -> Vector:
    """Three numbers; those that are rounding errors of ones are zero."""
    x, y, z = without_rounding([float(value) for value in values], 1.0)
    return x, y, z


def without_rounding(values: list[float], size: float) -> list[float]:
    """The numbers; those that are rounding errors of `size` are zero."""
    return [0.0 if abs(value) <= _SMALL * size else value for value in values]


# ---- places ----------------------------------------------------------------------------------------------------------


def place_of(pose: Pose) -> Floats:
    """The pose as a homogeneous matrix (4, 4)."""
    place = np.eye(4)
    place[:3, :3], place[:3, 3] = rotation(pose.rpy), pose.xyz
    return place


def pose_of(place: Floats) -> Pose:
    """The pose of a homogeneous matrix (4, 4)."""
    return Pose(xyz=vector_of(place[:3, 3]), rpy=fixed_angles(place[:3, :3]))


def inverse(pose: Pose) -> Pose:
    """The frame before the pose, seen from the one behind it."""
    if not any(pose.rpy):
        x, y, z = pose.xyz
        return Pose(xyz=(0.0 - x, 0.0 - y, 0.0 - z))
    return pose_of(np.asarray(np.linalg.inv(place_of(pose)), dtype=float))


def behind(pose: Pose, further: Pose) -> Pose:
    """The pose that stands at the end of another one."""
    if further.is_identity:
        return pose
    return pose_of(np.asarray(place_of(pose) @ place_of(further)))
