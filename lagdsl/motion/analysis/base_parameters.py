"""Base parameters: the combinations of inertial parameters that motion can identify.

Columns of the regressor depend on each other whatever the motion is. Regressors of random states, one below the
other, have the rank of all motions, and QR with column pivoting finds the independent columns and what the others add
to them (Gautier, *J. Robotic Systems* 8(4), 1991).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import qr, solve_triangular

from lagdsl.foundation.record import record

Floats = NDArray[np.float64]

_STATES_PER_PARAMETER = 3
# Relative to the largest: columns of random states depend on each other to round-off, or not at all.
_DEPENDENT = 1e-9
_NONE = 1e-9


@record(kw_only=True)
class BaseParameters:
    """`combination @ pi`, shape (n,), are the base parameters of inertial parameters pi, and Y[..., columns] their
    regressor.

    `names` tell each as text: `arm.Izz + 0.25*load.m`. `columns` are those of the regressor that are independent.
    """

    names: tuple[str, ...]
    columns: tuple[int, ...]
    combination: Floats


def base_parameters(regressor: Callable[..., Floats], coordinates: int, names: Sequence[str]) -> BaseParameters:
    """Of `regressor(q, qd, qdd)`, shape (..., nq, len(names)), by the same random states whenever it is called."""
    random = np.random.default_rng(1991)
    count = _STATES_PER_PARAMETER * max(len(names), 1)
    q = random.uniform(-np.pi, np.pi, (count, coordinates))
    qd, qdd = random.normal(0.0, 2.0, (2, count, coordinates))
    stacked = regressor(q, qd, qdd).reshape(-1, len(names))
    if not stacked.size:
        return BaseParameters(names=(), columns=(), combination=np.zeros((0, len(names))))
    _, upper, order = qr(stacked, mode="economic", pivoting=True)
    sizes = np.abs(np.diag(upper))
    rank = int(np.sum(sizes > _DEPENDENT * sizes[0]))
    added = solve_triangular(upper[:rank, :rank], upper[:rank, rank:])
    added[np.abs(added) < _NONE] = 0.0
    sequence = np.argsort(order[:rank])
    combination = np.zeros((rank, len(names)))
    for row, k in enumerate(sequence):
        combination[row, order[k]] = 1.0
        combination[row, order[rank:]] = added[k]
    columns = tuple(int(order[k]) for k in sequence)
    told = tuple(_text(row, column, names) for row, column in zip(combination, columns, strict=True))
    return BaseParameters(names=told, columns=columns, combination=combination)


def _text(row: Floats, column: int, names: Sequence[str]) -> str:
    text = names[column]
    for k in np.flatnonzero(row).tolist():
        if k != column:
            factor = f"{abs(row[k]):.6g}*".removeprefix("1*")
            text += f" {'-' if row[k] < 0 else '+'} {factor}{names[k]}"
    return text
