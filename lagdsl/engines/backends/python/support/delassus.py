"""Multipliers of the rows that elimination left to run time, for many states at once.

With the multipliers of these rows zero, the accelerations are a; a unit multiplier of row i adds Y_i to them. The
constraint J qdd = g then requires S lam = g - J a with the small matrix S = J Y' (Delassus). S is symmetric, and
singular if rows depend on each other. Rows are scaled to a unit diagonal, as those of J are in the dense solution.

S has the square of J's condition; a step of refinement whose residual comes from J itself takes that back as long as S
has digits left (corrected seminormal equations: Bjorck, *Linear Algebra and its Applications* 88/89, 1987). Elsewhere
the dense solution is to be asked.
"""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

# S is solved where its least eigenvalue, of those that independent rows have, is above this part of the largest. The
# residual of J a = g is rounding error down to 1e-10, but that of M a = f + J'lam grows with the digits that
# elimination lost.
LEAST_EIGENVALUE = 1e-6
# The eigenvalues of dependent rows are below this part of it: off the constraints they are not dependent.
LARGEST_EXCESS = 1e-10
# A row whose length, measured by M^-1, is below this part of the longest one is not stretched to unit length.
SHORT_RESPONSE = 1e-3


def solve_kept(
    acceleration: Floats,
    multiplier: Floats,
    response: Floats,
    multiplier_response: Floats,
    jacobian: Floats,
    bias: Floats,
    kept: tuple[int, ...],
    independent: tuple[bool, ...],
) -> tuple[Floats, Floats, Flags]:
    """Accelerations (..., n), all multipliers (..., m) of least Euclidean norm, and where they are sound (...).

    `acceleration` and `multiplier` are those where the multipliers of the rows `kept` are zero; row i of `response` and
    of `multiplier_response` is what a unit of kept multiplier i adds to them. Of the kept rows those flagged
    `independent` are that, except where they are zero, as those of open contacts: their multipliers are zero.
    """
    rank = sum(independent)
    if rank == 0 and not multiplier_response.any():  # the kept ones are zero
        return acceleration, multiplier, np.ones(acceleration.shape[:-1], dtype=np.bool_)
    adds = multiplier_response + np.eye(multiplier.shape[-1])[list(kept)]
    with np.errstate(all="ignore"):
        held, excess, sound = _parts(jacobian @ _transposed(response), rank, _absent(jacobian, independent))
        found = _solution(held, bias - _applied(jacobian, acceleration))
        if rank < len(kept):
            found = found - _without_effect(multiplier + _applied(_transposed(adds), found), excess, adds, kept)
        acceleration = acceleration + _applied(_transposed(response), found)
        change = _solution(held, bias - _applied(jacobian, acceleration))
        acceleration = acceleration + _applied(_transposed(response), change)
        multiplier = multiplier + _applied(_transposed(adds), found + change)
    return acceleration, multiplier, sound


def _absent(jacobian: Floats, independent: tuple[bool, ...]) -> Flags:
    return np.asarray(~jacobian.any(axis=-1) & np.asarray(independent))


def _parts(delassus: Floats, rank: int, absent: Flags) -> tuple[Floats, Floats, Flags]:
    """H with S^-1 = H H' for `rank` independent rows, columns N with S N = 0, and whether the two can be told apart.

    `absent` rows count as independent; H has nothing for them.
    """
    count = delassus.shape[-1]
    if rank == 0:  # S is round-off
        whole = np.broadcast_to(np.eye(count), delassus.shape)
        return whole[..., :0], whole, np.ones(delassus.shape[:-2], dtype=np.bool_)
    scale = _scale(delassus)
    scaled = delassus * scale[..., :, None] * scale[..., None, :] + np.eye(count) * absent[..., None]
    finite = np.asarray(np.isfinite(scaled).all(axis=(-1, -2)))
    size, modes = np.linalg.eigh(np.where(finite[..., None, None], scaled, np.eye(count)))
    largest, free = size[..., -1:], count - rank
    dependent = np.arange(count) < free
    apart = np.where(dependent, np.abs(size) <= LARGEST_EXCESS * largest, size > LEAST_EIGENVALUE * largest)
    held = scale[..., None] * modes[..., free:] / np.sqrt(np.abs(size[..., None, free:]))
    excess = np.where(scale > 0.0, scale, 1.0)[..., None] * modes[..., :free]
    return held, excess, np.asarray(finite & apart.all(axis=-1))


def _scale(delassus: Floats) -> Floats:
    length = np.sqrt(np.abs(np.diagonal(delassus, axis1=-2, axis2=-1)))
    longest = length.max(axis=-1, keepdims=True)
    scale: Floats = np.where(length > 0.0, np.minimum(1.0, length / (SHORT_RESPONSE * longest)) / length, 0.0)
    return scale


def _solution(held: Floats, rest: Floats) -> Floats:
    return _applied(held, _applied(_transposed(held), rest))


def _without_effect(multiplier: Floats, excess: Floats, adds: Floats, kept: tuple[int, ...]) -> Floats:
    """The part of the kept multipliers that changes nothing but the length of all of them."""
    directions = _transposed(adds) @ excess
    length = np.sqrt((directions * directions).sum(axis=-2, keepdims=True))
    basis, _ = np.linalg.qr(np.where(np.isfinite(directions) & (length > 0.0), directions / length, 0.0))
    return _solution(basis, multiplier)[..., list(kept)]


def _applied(matrix: Floats, vector: Floats) -> Floats:
    result: Floats = (matrix @ vector[..., None])[..., 0]
    return result


def _transposed(matrix: Floats) -> Floats:
    return np.swapaxes(matrix, -1, -2)
