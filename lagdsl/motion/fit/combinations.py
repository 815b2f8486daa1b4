"""Functions of unknowns that data show, as sums of products: `I2 + m2*c2^2`, the base parameters of a robot.

A function is visible where its gradient is normal to all directions that change no value. Among sums of given products,
with constant factors, those are the null space of linear equations, some for each of many points. Base parameters are
such sums: M. Gautier, W. Khalil, IEEE Trans. Robotics and Automation 6 (1990) 368.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations, permutations
from typing import TypeAlias

import numpy as np

from lagdsl.foundation.numerics.rank import Floats

# Exponents of the unknowns in a product.
Powers: TypeAlias = "tuple[int, ...]"

# More unknowns have too many products for the motions that it would take.
_MOST_NAMES = 8
# Equations for each product, so that chance has no say, and the part of a size by which the points lie apart.
_EQUATIONS, _APART = 1.5, 0.2
# At so many times as many points as are wanted directions are asked for.
_TRIALS = 3
# Singular values below this part of the largest are zero; factors below the other one are errors of derivatives.
_NOTHING = 1e-5
_NO_FACTOR = 3e-3


def visible_sums(
    names: Sequence[str], x: Floats, sizes: Floats, unseen: Callable[[Floats], Floats | None], count: int
) -> list[str] | None:
    """So many independent sums of products that do not change along the directions `unseen` (names, d), in x / sizes,
    at any x near the given one; None where there are none, or where they cannot be found."""
    if len(names) > _MOST_NAMES:
        return None
    for products in _libraries(len(names)):
        equations = _equations(products, x / sizes, lambda y: unseen(y * sizes), len(names) - count)
        if equations is None:
            return None
        found = _null(equations)
        if len(found) >= count:
            sparse = [_refined(equations, row) for row in reduced(found, _NO_FACTOR)]
            chosen = _independent(products, x / sizes, sparse, count)
            if chosen is not None:
                return [_text(names, products, row, sizes) for row in chosen]
    return None


def _libraries(k: int) -> list[list[Powers]]:
    """Products of growing degree, those that are to be written in terms of others first."""

    def powers(**at: int) -> Powers:
        return tuple(at.get(str(i), 0) for i in range(k))

    single = [powers(**{str(i): 1}) for i in range(k)]
    pairs = [powers(**{str(i): 1, str(j): 1}) for i, j in combinations(range(k), 2)]
    squares = [powers(**{str(i): 1, str(j): 2}) for i, j in permutations(range(k), 2)]
    return [[*pairs, *single], [*squares, *pairs, *single]]


def _equations(
    products: Sequence[Powers], y: Floats, unseen: Callable[[Floats], Floats | None], directions: int
) -> Floats | None:
    """Rows (equations, products): changes of the products along directions that change no value, at points near y."""
    random = np.random.default_rng(1990)
    wanted = int(_EQUATIONS * len(products)) + 1
    rows: list[Floats] = []
    for _ in range(_TRIALS * wanted // directions):
        if len(rows) >= wanted:
            break
        there = y + _APART * random.standard_normal(len(y))
        found = unseen(there)
        if found is None:
            continue
        basis, sizes, _ = np.linalg.svd(found, full_matrices=False)
        if np.sum(sizes > _NO_FACTOR) == directions:
            rows += list((_gradients(products, there) @ basis[:, :directions]).T)
    return np.array(rows) if len(rows) >= wanted else None


def _gradients(products: Sequence[Powers], y: Floats) -> Floats:
    """Of the products (products, names) at y."""
    found = np.zeros((len(products), len(y)))
    for row, powers in enumerate(products):
        for i, power in enumerate(powers):
            if power:
                others = np.prod([y[j] ** p for j, p in enumerate(powers) if j != i])
                found[row, i] = power * y[i] ** (power - 1) * others
    return found


def _null(equations: Floats) -> Floats:
    """Orthonormal rows of factors (functions, products) that satisfy all of them."""
    _, sizes, across = np.linalg.svd(equations, full_matrices=False)
    return np.asarray(across[sizes <= _NOTHING * sizes[0]])


def reduced(rows: Floats, zero: float) -> Floats:
    """Orthonormal rows combined so that each has an entry 1 where the others have 0: reduced row echelon form, where
    entries up to `zero` are none."""
    found, k = rows.copy(), 0
    for column in range(found.shape[1]):
        if k == len(found):
            break
        pivot = k + int(np.argmax(np.abs(found[k:, column])))
        if abs(found[pivot, column]) <= zero:
            continue
        found[[k, pivot]] = found[[pivot, k]]
        found[k] /= found[k, column]
        others = np.arange(len(found)) != k
        found[others] -= found[others, column, None] * found[k]
        k += 1
    found[np.abs(found) < zero] = 0.0
    return found


def _refined(equations: Floats, row: Floats) -> Floats:
    """The function with factors that follow from the equations of its own products alone."""
    own = np.flatnonzero(row)
    found = np.zeros(len(row))
    found[own] = np.linalg.svd(equations[:, own])[2][-1]
    return found


def _independent(products: Sequence[Powers], y: Floats, rows: Sequence[Floats], count: int) -> list[Floats] | None:
    """So many of the functions with independent gradients, short ones first; None where there are fewer."""
    gradients = _gradients(products, y)
    chosen: list[Floats] = []
    for row in sorted(rows, key=lambda each: int(np.sum(each != 0.0))):
        tried = np.array([*chosen, row]) @ gradients
        if np.linalg.matrix_rank(tried, tol=1e-2 * float(np.max(np.abs(tried)))) == len(tried):
            chosen.append(row)
        if len(chosen) == count:
            return chosen
    return None


def _text(names: Sequence[str], products: Sequence[Powers], row: Floats, sizes: Floats) -> str:
    """In terms of the unknowns themselves, single ones first, the first product with the factor 1."""
    factors = [float(f / np.prod(sizes ** np.array(p))) if f else 0.0 for f, p in zip(row, products, strict=True)]
    first = next(f for f in factors if f)
    terms = sorted((sum(p), k) for k, p in enumerate(products) if factors[k])
    text = ""
    for _, k in terms:
        factor = factors[k] / first
        size = f"{abs(factor):.4g}*".removeprefix("1*")
        product = "*".join(n if p == 1 else f"{n}^{p}" for n, p in zip(names, products[k], strict=True) if p)
        sign = "-" if factor < 0.0 else "+"
        text += f" {sign} {size}{product}" if text else f"{'-' if factor < 0.0 else ''}{size}{product}"
    return text
