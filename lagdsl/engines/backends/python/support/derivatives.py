"""Derivatives of the motion by state, inputs or parameters, exact.

With r = M qdd - f - J'lam and s = J qdd - g, differentiated by the model along every direction at once at the
accelerations that solve them, M dqdd - J'dlam = -dr and J dqdd = -ds. Loads that depend on both follow them.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from lagdsl.engines.backends.python.support.feedback import changes_with_loads
from lagdsl.engines.backends.python.support.linear import factorize
from lagdsl.engines.backends.python.support.motion import Sizes, solve_motion

Floats = NDArray[np.float64]
Evaluate = Callable[..., tuple[Floats, ...]]


def variables(sizes: Sizes, by: str) -> tuple[int, int]:
    """Of q, qd, z, u, p in a row, the first one of those that `by` names, and how many. Raises ValueError."""
    state = 2 * sizes.q + sizes.z
    known = {"state": (0, state), "input": (state, sizes.u), "parameter": (state + sizes.u, sizes.p)}
    if by not in known:
        raise ValueError(f"derivatives are by {', '.join(known)}, not by {by!r}")
    return known[by]


def differentiate_motion(evaluate: Evaluate, sizes: Sizes, by: str, *state: Floats) -> tuple[Floats, Floats]:
    """d(qd, qdd, zd)/dx, shape (..., 2 nq + nz, nx), and dy/dx, shape (..., ny, nx), at t, q, qd, z, u, w, p.

    x are the entries of q, qd, z, of u or of p. Raises SingularSystem.
    """
    acceleration, multiplier = solve_motion(evaluate, sizes, *state)
    first, count = variables(sizes, by)
    unit = np.eye(2 * sizes.q + sizes.z + sizes.u + sizes.p)[first : first + count]
    ends = np.cumsum([sizes.q, sizes.q, sizes.z, sizes.u])
    directions = np.split(unit, ends, axis=1)
    time, *vectors = state
    spread = (np.asarray(time)[..., None], *(v[..., None, :] for v in (*vectors, acceleration, multiplier)))
    motion, rows = evaluate("residual_tangent", *spread, *directions)
    mass, _, jacobian, _ = evaluate("dynamics", *state)
    factors, _ = factorize(mass, jacobian, sizes.rank)
    with np.errstate(all="ignore"):
        changes = factors.solve(-np.swapaxes(motion, -1, -2), -np.swapaxes(rows, -1, -2))
    by_direction = [np.swapaxes(change, -1, -2) for change in changes]
    loads, solved = None, (*state, acceleration, multiplier)
    if sizes.loads:
        *by_direction, loads = changes_with_loads(evaluate, factors, solved, directions, by_direction)
    (rates,) = evaluate("state_derivative_tangent", *spread, *directions, *by_direction)
    (outputs,) = evaluate("output_tangent", *spread, *directions, *by_direction)
    if loads is not None:
        _, of_rates, of_outputs, _ = evaluate("load_gain", *solved)
        rates = rates + loads @ np.swapaxes(of_rates, -1, -2)
        outputs = outputs + loads @ np.swapaxes(of_outputs, -1, -2)
    accelerations = np.swapaxes(by_direction[0], -1, -2)
    moved = np.broadcast_to(directions[1].T, accelerations.shape)
    return np.concatenate([moved, accelerations, np.swapaxes(rates, -1, -2)], axis=-2), np.swapaxes(outputs, -1, -2)
