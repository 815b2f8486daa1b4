"""Solving  M a - J'lam = f,  J a = g  for many states at once, whatever the ranks.

The null-space method. Coordinates are scaled to a unit diagonal of M and rows of J to unit length, so that ranks do not
depend on units. With the singular value decomposition J = U S V', the first components of y = V'a follow from J a = g,
the others from the rows of M a = f + J'lam that no multiplier enters, and lam from the rest. M itself may be singular;
only its restriction to the null space of J must not be. J is never multiplied by itself, so that ranks are told apart
down to half the digits further than by a factorization of J M^-1 J'.
"""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]

# A row of J counts as dependent where its singular value is below this part of the largest.
RANK_TOLERANCE = 1e-8
# A row of J is zero below this part of the longest one; a diagonal element of M, being quadratic, below its square.
ZERO_TOLERANCE = 1e-14
# A row of J shorter than this part of the longest one is not stretched to unit length: on the constraints it may be
# zero (the derivative of a unit vector along itself in an overconstrained loop), and its direction round-off.
SHORT_ROW = 1e-3
# For telling which rows are short or zero, no column is scaled up more than this many times the least one: the inertia
# of a quaternion's scalar part vanishes at the identity, and the row of its norm must not dwarf all others there.
LIGHTEST = 1e3
# M is singular on the null space of J where an eigenvalue is below nq times this part of the largest.
SINGULAR_TOLERANCE = 2e-15
# Values beyond this, whose squares are not numbers any more, count as infinite.
LARGEST = 1e140
REFINEMENTS = 1


class SingularSystem(ArithmeticError):  # noqa: N818  it is a state of the mechanism, not always a mistake
    """Some accelerations are not determined: M is singular on the null space of J.

    `coordinate` is the index of the coordinate with the largest part in the undetermined direction.
    """

    def __init__(self, coordinate: int) -> None:
        super().__init__(f"the acceleration of coordinate {coordinate} is not determined")
        self.coordinate = coordinate


class Factorization:
    """Inverse of the system for M (..., n, n) and J (..., m, n), of whose rows at most `rank` are independent.

    a = B g + K (f - M B g) and lam = B'(M a - f): B is the inverse of J, and K that of M on the null space of J. Both
    are explicit; refinement takes back what that costs.
    """

    def __init__(self, mass: Floats, jacobian: Floats, rank: int) -> None:
        n, m = jacobian.shape[-1], jacobian.shape[-2]
        self._mass, self._jacobian = mass, jacobian
        self._column_scale = _column_scale(mass)
        row_inverse = np.zeros((*mass.shape[:-2], n, m))
        basis, held = self._column_scale[..., None] * np.eye(n), np.zeros(n, dtype=np.bool_)
        self._excess: tuple[Floats, Floats] | None = None
        if n and m:
            scaled = jacobian * self._column_scale[..., None, :]
            row_scale = _row_scale(jacobian, scaled, self._column_scale)
            left, values, right = np.linalg.svd(scaled * row_scale[..., None])
            ranks = _rank(values, rank)[..., None]
            held = np.arange(n) < ranks
            basis = self._column_scale[..., None] * np.swapaxes(right, -1, -2)
            row_inverse = (
                _row_inverse(basis, values, left, np.arange(values.shape[-1]) < ranks) * row_scale[..., None, :]
            )
            if (ranks < m).any():
                self._excess = _excess(left, np.arange(m) < ranks, row_scale)
        self._row_inverse = row_inverse
        self._size, self._modes = _modes(mass, basis, held)
        signed = self._modes / self._size[..., None, :]
        self._mass_inverse = signed @ np.swapaxes(self._modes, -1, -2)

    def undetermined(self) -> Indices:
        """Index of the coordinate with the largest part in an undetermined direction, -1 where all are determined."""
        size = np.abs(self._size)
        n = size.shape[-1]
        singular = size.min(axis=-1, initial=np.inf) <= n * SINGULAR_TOLERANCE * size.max(axis=-1, initial=0.0)
        none = np.full(self._mass.shape[:-2], -1, dtype=np.intp)
        if n == 0 or not singular.any():
            return none
        smallest = np.argmin(size, axis=-1)[..., None, None]
        direction = np.abs(np.take_along_axis(self._modes, smallest, axis=-1)[..., 0] / self._column_scale)
        # of equal parts the first: rounding must not choose
        largest = direction >= (1.0 - 1e-6) * direction.max(axis=-1, keepdims=True)
        return np.where(singular, largest.argmax(axis=-1), none)

    def solve(self, force: Floats, bias: Floats) -> tuple[Floats, Floats]:
        """Accelerations (..., n, k) and multipliers (..., m, k) for k right-hand sides f and g, refined.

        Of all multipliers that do the same, those of least Euclidean norm.
        """
        transposed = np.swapaxes(self._jacobian, -1, -2)
        acceleration, multiplier = self._solve(force, bias)
        for _ in range(REFINEMENTS):
            rest = force - self._mass @ acceleration + transposed @ multiplier
            correction, change = self._solve(rest, bias - self._jacobian @ acceleration)
            acceleration = acceleration + correction
            multiplier = multiplier + change
        return acceleration, self._least(multiplier)

    def _solve(self, force: Floats, bias: Floats) -> tuple[Floats, Floats]:
        held = self._row_inverse @ bias
        acceleration = held + self._mass_inverse @ (force - self._mass @ held)
        return acceleration, np.swapaxes(self._row_inverse, -1, -2) @ (self._mass @ acceleration - force)

    def _least(self, multiplier: Floats) -> Floats:
        """The part of the multipliers that is orthogonal to everything without effect."""
        if self._excess is None:
            return multiplier
        directions, inverse_gram = self._excess
        return multiplier - directions @ (inverse_gram @ (np.swapaxes(directions, -1, -2) @ multiplier))


def factorize(mass: Floats, jacobian: Floats, rank: int) -> tuple[Factorization, Flags]:
    """Factors, and where M and J are finite (their squares, too); elsewhere they are those of another system."""
    with np.errstate(all="ignore"):
        finite = np.all(np.abs(mass) < LARGEST, axis=(-1, -2)) & np.all(np.abs(jacobian) < LARGEST, axis=(-1, -2))
        if not finite.all():
            mass = np.where(finite[..., None, None], mass, np.eye(mass.shape[-1]))
            jacobian = np.where(finite[..., None, None], jacobian, 0.0)
        return Factorization(mass, jacobian, rank), finite


def solve_system(
    mass: Floats, force: Floats, jacobian: Floats, bias: Floats, rank: int
) -> tuple[Floats, Floats, Indices]:
    """Accelerations (..., n), multipliers (..., m) of least norm, and the undetermined coordinate (...) or -1.

    States with values that are not finite give values that are not finite, and -1. If a coordinate is undetermined, the
    other results mean nothing.
    """
    factors, finite = factorize(mass, jacobian, rank)
    with np.errstate(all="ignore"):
        acceleration, multiplier = factors.solve(force[..., None], bias[..., None])
    if finite.all():
        return acceleration[..., 0], multiplier[..., 0], factors.undetermined()
    known = finite[..., None]
    undetermined = np.where(finite, factors.undetermined(), -1)
    return (
        np.where(known, acceleration[..., 0], np.nan),
        np.where(known, multiplier[..., 0], np.nan),
        undetermined,
    )


def _column_scale(mass: Floats) -> Floats:
    diagonal = np.abs(np.diagonal(mass, axis1=-2, axis2=-1))
    largest = diagonal.max(axis=-1, keepdims=True, initial=0.0)
    largest = np.where(largest > 0.0, largest, 1.0)
    scale: Floats = 1.0 / np.sqrt(np.where(diagonal > ZERO_TOLERANCE**2 * largest, diagonal, largest))
    return scale


def _row_scale(jacobian: Floats, scaled: Floats, column_scale: Floats) -> Floats:
    least = column_scale.min(axis=-1, keepdims=True)
    judged = _length(jacobian * np.minimum(column_scale, LIGHTEST * least)[..., None, :])
    longest = judged.max(axis=-1, keepdims=True)
    significant = judged > ZERO_TOLERANCE * longest
    part = np.minimum(1.0, judged / np.where(longest > 0.0, SHORT_ROW * longest, 1.0))
    scale: Floats = significant * part / np.where(significant, _length(scaled), 1.0)
    return scale


def _length(rows: Floats) -> Floats:
    length: Floats = np.sqrt((rows * rows).sum(axis=-1))
    return length


def _rank(singular_values: Floats, bound: int) -> Indices:
    significant = singular_values > RANK_TOLERANCE * singular_values[..., :1]
    return np.minimum(np.sum(significant, axis=-1, dtype=np.intp), bound)


def _row_inverse(basis: Floats, singular_values: Floats, left: Floats, held: Flags) -> Floats:
    least = singular_values.shape[-1]
    inverse = held / np.where(held, singular_values, 1.0)
    combined: Floats = (basis[..., :least] * inverse[..., None, :]) @ np.swapaxes(left[..., :least], -1, -2)
    return combined


def _modes(mass: Floats, basis: Floats, held: Flags) -> tuple[Floats, Floats]:
    """Eigenvalues (..., n) of M on the null space of J, and modes (..., n, n) as columns, in which M is diagonal there.

    The held directions have an eigenvalue of the same size, and no part in any mode.
    """
    n = mass.shape[-1]
    free = ~held
    reduced = np.swapaxes(basis, -1, -2) @ mass @ basis * (free[..., :, None] & free[..., None, :])
    if held.any():
        largest = np.abs(reduced).max(axis=(-1, -2), initial=0.0)
        reduced[..., np.arange(n), np.arange(n)] += held * np.where(largest > 0.0, largest, 1.0)[..., None]
    size, vectors = np.linalg.eigh(reduced)
    return size, basis @ (vectors * free[..., :, None])


def _excess(left: Floats, held: Flags, row_scale: Floats) -> tuple[Floats, Floats]:
    """Combinations of rows that vanish, as columns (..., m, m), padded with zeros; their inverse Gram matrix."""
    directions = np.where(row_scale > 0.0, row_scale, 1.0)[..., None] * left * ~held[..., None, :]
    length = np.sqrt((directions * directions).sum(axis=-2, keepdims=True))
    directions = directions / np.where(length > 0.0, length, 1.0)
    gram = np.swapaxes(directions, -1, -2) @ directions + np.eye(left.shape[-1]) * held[..., None, :]
    return directions, np.asarray(np.linalg.inv(gram), dtype=np.float64)
