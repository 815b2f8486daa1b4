# Solving  M a - J' lam = f,  J a = g  for many states at once, whatever the ranks.
#
# The null-space method. Coordinates are scaled to a unit diagonal of M and rows of J to unit length, so that ranks do not
# depend on units. With the singular value decomposition J = U S V', the first components of y = V'a follow from J a = g, the
# others from the rows of M a = f + J'lam that no multiplier enters, and lam from the rest. M itself may be singular; only its
# restriction to the null space of J must not be. J is never multiplied by itself, so ranks are found at the square root of
# the smallness that a factorization of J M^-1 J' would need.

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Indices = NDArray[np.intp]

# A row of J counts as dependent where its singular value is below this part of the largest.
RANK_TOLERANCE = 1e-8
# A row of J is zero below this part of the longest one; a diagonal element of M, being quadratic, below its square.
ZERO_TOLERANCE = 1e-14
# M is singular on the null space of J where an eigenvalue is below nq times this part of the largest.
SINGULAR_TOLERANCE = 2e-15
REFINEMENTS = 2
LARGEST = 1e140


class SingularSystem(ArithmeticError):
    """Some accelerations are not determined: M is singular on the null space of J. `coordinate` is the index of the
    coordinate with the largest part in the undetermined direction."""

    def __init__(self, coordinate: int) -> None:
        super().__init__(f"singular in coordinate {coordinate}")
        self.coordinate = coordinate


class Factorization:
    """Factors of the system for M (..., n, n), J (..., m, n), where at most `rank` rows of J are independent."""

    def __init__(self, mass: Floats, jacobian: Floats, rank: int) -> None:
        n, m = mass.shape[-1], jacobian.shape[-2]
        self.mass = mass
        self.jacobian = jacobian
        self.column_scale = _column_scale(mass)
        scaled_mass = mass * self.column_scale[..., :, None] * self.column_scale[..., None, :]
        scaled_jacobian = jacobian * self.column_scale[..., None, :]
        self.row_scale = _row_scale(scaled_jacobian)
        left, self.singular_values, right = np.linalg.svd(scaled_jacobian * self.row_scale[..., :, None])
        self.basis = np.swapaxes(right, -1, -2)
        self.rank = _rank(self.singular_values, rank)
        order = np.arange(max(n, m))
        self.held = order[:n] < self.rank[..., None]
        self.range = left[..., :, : min(n, m)] * self.held[..., None, : min(n, m)]
        free = ~self.held
        reduced = right @ scaled_mass @ self.basis
        reduced = reduced * (free[..., :, None] & free[..., None, :])
        scale = np.max(np.abs(np.linalg.norm(reduced, axis=-1)), axis=-1, initial=0.0)
        reduced[..., order[:n], order[:n]] += self.held * np.where(scale > 0.0, scale, 1.0)[..., None]
        self.eigenvalues, self.eigenvectors = np.linalg.eigh(reduced)
        self.scaled_mass = scaled_mass
        self.excess = None
        if m and np.any(self.rank < m):
            self.excess = _excess(left, order[:m] < self.rank[..., None], self.row_scale)

    def undetermined(self) -> Indices:
        """Index of the coordinate with the largest part in an undetermined direction, -1 where all are determined."""
        n = self.mass.shape[-1]
        if n == 0:
            return np.full(self.mass.shape[:-2], -1, dtype=np.intp)
        size = np.abs(self.eigenvalues)
        smallest = np.argmin(size, axis=-1)
        least = np.take_along_axis(size, smallest[..., None], axis=-1)[..., 0]
        singular = least <= n * SINGULAR_TOLERANCE * np.max(size, axis=-1)
        direction = np.take_along_axis(self.basis @ self.eigenvectors, smallest[..., None, None], axis=-1)[..., 0]
        # of equal parts the first: rounding must not choose
        part = np.abs(direction) >= (1.0 - 1e-6) * np.max(np.abs(direction), axis=-1, keepdims=True)
        return np.where(singular, np.argmax(part, axis=-1), -1)

    def solve(self, force: Floats, bias: Floats) -> tuple[Floats, Floats]:
        """Accelerations (..., n, k) and multipliers of least Euclidean norm (..., m, k) for k right-hand sides f and g."""
        acceleration, multiplier = self._solve(force, bias)
        transposed = np.swapaxes(self.jacobian, -1, -2)
        for _ in range(REFINEMENTS):
            rest = force - self.mass @ acceleration + transposed @ multiplier
            correction, change = self._solve(rest, bias - self.jacobian @ acceleration)
            acceleration = acceleration + correction
            multiplier = multiplier + change
        return acceleration, multiplier

    def _solve(self, force: Floats, bias: Floats) -> tuple[Floats, Floats]:
        count = self.singular_values.shape[-1]
        held = self.held[..., :count, None]
        force = self.column_scale[..., None] * force
        bias = self.row_scale[..., None] * bias
        divisor = np.where(held, self.singular_values[..., None], 1.0)
        first = self.basis[..., :, :count]
        x = first @ (np.swapaxes(self.range, -1, -2) @ bias / divisor)
        rest = (np.swapaxes(self.basis, -1, -2) @ (force - self.scaled_mass @ x)) * ~self.held[..., None]
        components = np.swapaxes(self.eigenvectors, -1, -2) @ rest / self.eigenvalues[..., None]
        x = x + self.basis @ ((self.eigenvectors @ components) * ~self.held[..., None])
        out_of_balance = np.swapaxes(first, -1, -2) @ (self.scaled_mass @ x - force)
        multiplier = self.row_scale[..., None] * (self.range @ (out_of_balance / divisor))
        return self.column_scale[..., None] * x, self._least(multiplier)

    def _least(self, multiplier: Floats) -> Floats:
        """The part of the multipliers that is orthogonal to everything without effect."""
        if self.excess is None:
            return multiplier
        directions, inverse_gram = self.excess
        return multiplier - directions @ (inverse_gram @ (np.swapaxes(directions, -1, -2) @ multiplier))


def solve_system(mass: Floats, force: Floats, jacobian: Floats, bias: Floats, rank: int) -> tuple[Floats, Floats, Indices]:
    """Accelerations (..., n), multipliers (..., m) of least norm, and the undetermined coordinate (...) or -1.

    States with values that are not finite give values that are not finite, and -1. Where a coordinate is undetermined the
    other results mean nothing.
    """
    factors, finite = factorize(mass, jacobian, rank)
    with np.errstate(all="ignore"):
        acceleration, multiplier = factors.solve(force[..., None], bias[..., None])
    acceleration = np.where(finite[..., None], acceleration[..., 0], np.nan)
    multiplier = np.where(finite[..., None], multiplier[..., 0], np.nan)
    return acceleration, multiplier, np.where(finite, factors.undetermined(), -1)


def factorize(mass: Floats, jacobian: Floats, rank: int) -> tuple[Factorization, NDArray[np.bool_]]:
    """Factors, and where M and J are finite (their squares, too); elsewhere they are those of another system."""
    with np.errstate(all="ignore"):
        finite = (np.abs(mass) < LARGEST).all(axis=(-1, -2)) & (np.abs(jacobian) < LARGEST).all(axis=(-1, -2))
    if not finite.all():
        mass = np.where(finite[..., None, None], mass, np.eye(mass.shape[-1]))
        jacobian = np.where(finite[..., None, None], jacobian, 0.0)
    with np.errstate(all="ignore"):
        return Factorization(mass, jacobian, rank), finite


def _column_scale(mass: Floats) -> Floats:
    diagonal = np.abs(np.diagonal(mass, axis1=-2, axis2=-1))
    largest = np.max(diagonal, axis=-1, keepdims=True, initial=0.0)
    largest = np.where(largest > 0.0, largest, 1.0)
    return 1.0 / np.sqrt(np.where(diagonal > ZERO_TOLERANCE**2 * largest, diagonal, largest))


def _row_scale(jacobian: Floats) -> Floats:
    length = np.linalg.norm(jacobian, axis=-1)
    largest = np.max(length, axis=-1, keepdims=True, initial=0.0)
    significant = length > ZERO_TOLERANCE * largest
    return significant / np.where(significant, length, 1.0)


def _rank(singular_values: Floats, bound: int) -> Indices:
    largest = np.max(singular_values, axis=-1, keepdims=True, initial=0.0)
    rank = np.sum((singular_values > RANK_TOLERANCE * largest) & (singular_values > 0.0), axis=-1)
    return np.minimum(rank, bound)


def _excess(left: Floats, held: NDArray[np.bool_], row_scale: Floats) -> tuple[Floats, Floats]:
    """Combinations of the rows that vanish, as columns (..., m, m; zero where there are fewer), and their inverse Gram matrix."""
    directions = np.where(row_scale > 0.0, row_scale, 1.0)[..., :, None] * left * ~held[..., None, :]
    length = np.linalg.norm(directions, axis=-2, keepdims=True)
    directions = directions / np.where(length > 0.0, length, 1.0)
    gram = np.swapaxes(directions, -1, -2) @ directions + np.eye(left.shape[-1]) * held[..., None, :]
    return directions, np.linalg.inv(gram)
