"""Accelerations and multipliers from the functions of a model."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from lagdsl.engines.backends.python.support.delassus import solve_kept
from lagdsl.engines.backends.python.support.linear import SingularSystem, solve_system

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Evaluate = Callable[..., tuple[Floats, ...]]


class Sizes:
    """Numbers of coordinates, states, inputs, discretes, parameters and constraint rows.

    `loads` is the number of the last discretes that are loads. At most `rank` rows are independent. `kept` are the rows
    that the function `elimination` leaves, None where there is no such function; those of them that are flagged
    `independent` are that, unless they are zero at a state (open contacts).
    """

    def __init__(
        self,
        *,
        q: int,
        z: int,
        u: int,
        w: int,
        p: int,
        c: int,
        rank: int,
        kept: tuple[int, ...] | None,
        independent: tuple[bool, ...],
        loads: int = 0,
    ) -> None:
        self.q, self.z, self.u, self.w, self.p, self.c, self.rank = q, z, u, w, p, c, rank
        self.kept, self.independent = kept, independent
        self.loads = loads


# If elimination leaves less than this part of a pivot, the dense system decides whether the position is singular. With
# rows left to run time, their multipliers cancel much of the accelerations without them, and digits that these lost
# show in the difference.
SMALLEST_PIVOT = 1e-6
SMALLEST_PIVOT_WITH_ROWS_LEFT = 1e-4


def solve_motion(evaluate: Evaluate, sizes: Sizes, *state: Floats) -> tuple[Floats, Floats]:
    """Accelerations (..., nq) and multipliers (..., nc) at t, q, qd, z, u, w, p. Raises SingularSystem."""
    if sizes.kept is None:
        return _solve_dense(evaluate, sizes, *state)
    acceleration, multiplier, response, multiplier_response, jacobian, bias, pivot = evaluate("elimination", *state)
    sound: Flags = np.asarray(pivot > (SMALLEST_PIVOT_WITH_ROWS_LEFT if sizes.kept else SMALLEST_PIVOT))
    if sizes.kept:
        acceleration, multiplier, regular = solve_kept(
            acceleration,
            multiplier,
            response,
            multiplier_response,
            jacobian,
            bias,
            sizes.kept,
            sizes.independent,
        )
        sound = sound & regular
    sound = sound & np.isfinite(acceleration).all(axis=-1) & np.isfinite(multiplier).all(axis=-1)
    if not sound.any():
        return _solve_dense(evaluate, sizes, *state)
    if not sound.all():
        time, *vectors = (_at(~sound, argument, axes) for argument, axes in zip(state, (0, *[1] * 6), strict=True))
        acceleration[~sound], multiplier[~sound] = _solve_dense(evaluate, sizes, time, *vectors)
    return acceleration, multiplier


def _at(states: Flags, argument: Floats, axes: int) -> Floats:
    """The argument at some of the states; it has `axes` axes of its own."""
    own = argument.shape[argument.ndim - axes :]
    return np.broadcast_to(argument, states.shape + own)[states]


def _solve_dense(evaluate: Evaluate, sizes: Sizes, *state: Floats) -> tuple[Floats, Floats]:
    mass, force, jacobian, bias = evaluate("dynamics", *state)
    acceleration, multiplier, undetermined = solve_system(mass, force, jacobian, bias, sizes.rank)
    if np.any(undetermined >= 0):
        raise SingularSystem(int(undetermined[undetermined >= 0].flat[0]))
    return acceleration, multiplier
