"""Functions of one state, applied over leading axes."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
Shape = tuple[int, ...]


def vector(name: str, value: ArrayLike, entries: Sequence[str]) -> Floats:
    """`value` as floats whose last axis has one entry per name. Raises ValueError that says which they are."""
    array = np.asarray(value, dtype=np.float64)
    if array.ndim == 0 and len(entries) == 1:
        array = array.reshape(1)
    if array.ndim == 0 or array.shape[-1] != len(entries):
        names = ", ".join(entries) if entries else "none"
        raise ValueError(f"the last axis of {name} must have {len(entries)} entries ({names}), not shape {array.shape}")
    return array


def over_leading_axes(function: Callable[..., Floats], shape: Shape, time: ArrayLike, *vectors: Floats) -> Floats:
    """`function(t, *vectors)`, a result of `shape`, for every entry of the common leading axes of the arguments."""
    times = np.asarray(time, dtype=np.float64)
    leading = np.broadcast_shapes(times.shape, *(v.shape[:-1] for v in vectors))
    times = np.broadcast_to(times, leading)
    spread = [np.broadcast_to(v, leading + v.shape[-1:]) for v in vectors]
    result = np.empty(leading + shape)
    for index in np.ndindex(leading):
        result[index] = function(float(times[index]), *(np.ascontiguousarray(v[index]) for v in spread))
    return result
