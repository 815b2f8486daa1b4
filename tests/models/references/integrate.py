"""Solutions of ordinary differential equations to about 1e-12."""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.integrate import solve_ivp
from scipy.linalg import expm

Floats = NDArray[np.float64]

G_N = 9.80665


def solve(
    rates: Callable[[float, Floats], ArrayLike],
    start: Sequence[float],
    t: Floats,
    tolerance: float = 1e-12,
    max_step: float = np.inf,
) -> Floats:
    """Rows of the solution of x' = rates(t, x), x(t[0]) = start, at the times `t`; shape (len(start), len(t)).

    Times may come twice, as at events. Where stability limits the steps, what is interpolated is less accurate
    than the ends of steps: give `max_step`, well below the fastest time constant.
    """
    times, rows = np.unique(t, return_inverse=True)
    scale = np.maximum(np.abs(start), 1e-3 * np.max(np.abs(start)))
    solution = solve_ivp(
        lambda time, x: np.asarray(rates(time, x), dtype=float),
        (t[0], t[-1]),
        start,
        method="DOP853",
        t_eval=times,
        rtol=tolerance,
        max_step=max_step,
        atol=tolerance * np.where(scale > 0, scale, 1.0),
    )
    assert solution.success, solution.message
    return np.asarray(solution.y)[:, rows]


def linear(a: ArrayLike, start: Sequence[float], t: Floats) -> Floats:
    """Rows of the solution of x' = a x, x(t[0]) = start, shape (len(start), len(t)): from time to time by the matrix
    exponential, one for each length of a step."""
    matrix, rows = np.asarray(a, dtype=float), [np.asarray(start, dtype=float)]
    over: dict[float, Floats] = {}
    for step in np.diff(t).tolist():
        if step not in over:
            over[step] = expm(matrix * step)
        rows.append(over[step] @ rows[-1])
    return np.array(rows).T
