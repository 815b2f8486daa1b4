"""Loads that depend on the accelerations and multipliers that they cause: the last entries of the discretes w.

Newton's method in these entries. The accelerations are affine in them, so that their response is found once.
"""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from lagdsl.engines.backends.python.support.linear import Factorization

Floats = NDArray[np.float64]
Evaluate = Callable[..., tuple[Floats, ...]]

MOST_ITERATIONS = 50
# Loads are found where they change no more than by this part of the largest.
SMALLEST_CHANGE = 1e-14


class LoadsNotFound(ArithmeticError):  # noqa: N818  it is a state of the mechanism, not always a mistake
    """No loads are as the accelerations and multipliers that they cause ask for, or the search does not find them."""

    def __init__(self) -> None:
        super().__init__("loads that depend on accelerations or multipliers are not found")


def with_loads(evaluate: Evaluate, solve: Evaluate, count: int, *state: Floats) -> tuple[Floats, ...]:
    """t, q, qd, z, u, w, p with the `count` loads in w found, from those there. Raises LoadsNotFound."""
    *before, discretes, parameters = state
    first = discretes.shape[-1] - count
    held, loads = discretes[..., :first], discretes[..., first:]

    def at(loads: Floats) -> tuple[Floats, ...]:
        leading = np.broadcast_shapes(held.shape[:-1], loads.shape[:-1])
        parts = [np.broadcast_to(part, (*leading, part.shape[-1])) for part in (held, loads)]
        return (*before, np.concatenate(parts, axis=-1), parameters)

    solved = solve(*at(loads))
    moved = [solve(*at(loads + unit)) for unit in np.eye(count)]
    response = [np.stack([found[k] - solved[k] for found in moved], axis=-1) for k in range(2)]
    for _ in range(MOST_ITERATIONS):
        value, *_ = evaluate("load", *at(loads), *solved)
        change = _following(_slope(evaluate, response, *at(loads), *solved), (value - loads)[..., None])[..., 0]
        loads = loads + change
        if not np.isfinite(loads).all():
            break
        largest = np.max(np.abs(loads), axis=-1, keepdims=True)
        if np.all(np.abs(change) <= SMALLEST_CHANGE * largest):
            return at(loads)
        solved = solve(*at(loads))
    raise LoadsNotFound


def changes_with_loads(
    evaluate: Evaluate,
    factors: Factorization,
    solved: Sequence[Floats],
    directions: Sequence[Floats],
    changes: Sequence[Floats],
) -> tuple[Floats, Floats, Floats]:
    """Changes of accelerations (..., k, nq), multipliers (..., k, nc) and loads (..., k, count) along k directions.

    `changes` are the first two while the loads are held, at t, q, qd, z, u, w, p, qdd, lam. Raises LoadsNotFound.
    """
    motion, *_ = evaluate("load_gain", *solved)
    rows = changes[1].shape[-1]
    response = factors.solve(-motion, np.zeros((*motion.shape[:-2], rows, motion.shape[-1])))
    time, *vectors = solved
    spread = (np.asarray(time)[..., None], *(vector[..., None, :] for vector in vectors))
    (asked,) = evaluate("load_tangent", *spread, *directions, *changes)
    loads = np.swapaxes(_following(_slope(evaluate, response, *solved), np.swapaxes(asked, -1, -2)), -1, -2)
    acceleration, multiplier = (
        change + loads @ np.swapaxes(own, -1, -2) for change, own in zip(changes, response, strict=True)
    )
    return acceleration, multiplier, loads


def _slope(evaluate: Evaluate, response: Sequence[Floats], *solved: Floats) -> Floats:
    """The change of loads with those that act, (..., count, count); `response` is that of accelerations and
    of multipliers, by columns."""
    _, by_acceleration, by_multiplier = evaluate("load", *solved)
    *_, own = evaluate("load_gain", *solved)
    return own + by_acceleration @ response[0] + by_multiplier @ response[1]


def _following(slope: Floats, asked: Floats) -> Floats:
    """Changes (..., count, k) of loads of which `asked` are wanted while those that act are held."""
    try:
        return np.asarray(np.linalg.solve(np.eye(slope.shape[-1]) - slope, asked))
    except np.linalg.LinAlgError:
        raise LoadsNotFound from None
