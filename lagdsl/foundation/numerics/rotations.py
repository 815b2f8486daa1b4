"""Rotation matrices and their vectors: logarithm on SO(3) and its derivative.

Source: Chirikjian, *Stochastic Models, Information Theory, and Lie Groups*, vol. 2 (2012), section 10.6.
"""

from __future__ import annotations

import numpy as np

from lagdsl.foundation.numerics.rank import Floats

_SMALL = 1e-4  # angles [rad] below which the series of the coefficient is exact in double precision


def rotation_vector(matrix: Floats) -> Floats:
    """The vector r, |r| <= pi, whose direction is the axis and whose length is the angle [rad] of `matrix` (3, 3)."""
    quaternion = _quaternion(matrix)
    real, imaginary = quaternion[0], quaternion[1:]
    sine = float(np.linalg.norm(imaginary))
    if sine == 0.0:
        return np.zeros(3)
    return np.asarray(2.0 * np.arctan2(sine, real) / sine * imaginary)


def inverse_right_jacobian(vector: Floats) -> Floats:
    """J (3, 3) with log(exp(r) exp(d)) = r + J d for small d, of `vector` r (3,)."""
    x, y, z = vector
    crossed = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    angle = float(np.linalg.norm(vector))
    bend = 1.0 / 12.0 if angle < _SMALL else (1.0 - 0.5 * angle / np.tan(0.5 * angle)) / angle**2
    return np.asarray(np.eye(3) + 0.5 * crossed + bend * crossed @ crossed)


def _quaternion(matrix: Floats) -> Floats:
    """(w, x, y, z) with w >= 0, from its largest component: exact also for half turns."""
    trace = float(np.trace(matrix))
    squares = np.array([trace, *np.diag(matrix)])
    largest = int(np.argmax(squares))
    if largest == 0:
        found = [1.0 + trace, *(matrix[k, j] - matrix[j, k] for j, k in ((1, 2), (2, 0), (0, 1)))]
    else:
        i = largest - 1
        j, k = (i + 1) % 3, (i + 2) % 3
        found = [matrix[k, j] - matrix[j, k], 0.0, 0.0, 0.0]
        found[1 + i] = 1.0 + 2.0 * matrix[i, i] - trace
        found[1 + j] = matrix[j, i] + matrix[i, j]
        found[1 + k] = matrix[k, i] + matrix[i, k]
    quaternion = np.array(found)
    return np.asarray(quaternion / np.linalg.norm(quaternion) * (-1.0 if quaternion[0] < 0.0 else 1.0))
