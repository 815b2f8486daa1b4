"""M and the linear system of a model that does not write them out: M column by column, one lane for each rate."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Evaluate = Callable[..., tuple[Floats, ...]]

BY_COLUMNS = ("mass_matrix", "dynamics")


def formed(evaluate: Evaluate, function: str, *state: Floats) -> tuple[Floats, ...]:
    """Result blocks of a function of BY_COLUMNS at t, q, qd, z, u, w, p, from other functions of the model."""
    time, *vectors = state
    n = vectors[0].shape[-1]
    lanes = (time[..., None], *(vector[..., None, :] for vector in vectors))
    (columns,) = evaluate("momentum_tangent", *lanes, np.eye(n))
    mass = np.swapaxes(columns, -1, -2)
    if function == "mass_matrix":
        return (mass,)
    still = np.zeros(n)
    (missing,) = evaluate("inverse_dynamics", *state, still)
    residual, jacobian = evaluate("velocity_constraint", *state)
    _, rows = evaluate("residual", *state, still, np.zeros(residual.shape[-1]))
    return mass, -missing, jacobian, -rows
