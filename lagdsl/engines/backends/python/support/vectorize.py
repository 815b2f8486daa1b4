"""Calling the body of a function over leading axes."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lagdsl.engines.backends.python.support.columns import BY_COLUMNS, formed
from lagdsl.engines.backends.python.support.elementary import Elementary
from lagdsl.engines.backends.python.support.names import real_numbers

Floats = NDArray[np.float64]
Signature = tuple[tuple[str, int | None], ...]
Shapes = tuple[tuple[int, ...], ...]
Row = tuple[Callable[..., Sequence[float]], Signature, Shapes]


class Functions:
    """The functions of a model by name, over leading axes of their arguments."""

    def __init__(self, rows: Mapping[str, Row]) -> None:
        self._rows = rows

    def __call__(self, function: str, *arguments: ArrayLike) -> tuple[Floats, ...]:
        """Result blocks of one row, each of shape (leading axes, own shape)."""
        if function in BY_COLUMNS and function not in self._rows:
            return formed(self, function, *map(np.asarray, arguments))
        return apply(function, *self._rows[function], arguments)


def apply(
    name: str,
    body: Callable[..., Sequence[float]],
    signature: Signature,
    shapes: Shapes,
    arguments: Sequence[ArrayLike],
) -> tuple[Floats, ...]:
    """Results of `body`, each of shape (leading axes of the arguments, own shape).

    `signature` has the name and length of every argument, None for the time, which has no axis of its own. Raises
    ValueError for an argument of another length.
    """
    if len(arguments) != len(signature):
        raise ValueError(f"{name} takes {len(signature)} arguments, not {len(arguments)}")
    arrays = [real_numbers(label, argument) for argument, (label, _) in zip(arguments, signature, strict=True)]
    leading: tuple[int, ...] = ()
    for array, (label, length) in zip(arrays, signature, strict=True):
        if length is not None and (array.ndim == 0 or array.shape[-1] != length):
            raise ValueError(
                f"{label} of {name} must have {length} entries along its last axis, its shape is {array.shape}"
            )
        leading = np.broadcast_shapes(leading, array.shape if length is None else array.shape[:-1])
    columns = [
        array if length is None else [array[..., index] for index in range(length)]
        for array, (_, length) in zip(arrays, signature, strict=True)
    ]
    with np.errstate(all="ignore"):
        values = body(Elementary, *columns)
    flat = np.empty((*leading, len(values)))
    for index, value in enumerate(values):
        flat[..., index] = value
    return split(flat, shapes)


def split(flat: Floats, shapes: Shapes) -> tuple[Floats, ...]:
    """The result blocks of `shapes` out of their concatenation along the last axis."""
    blocks = []
    start = 0
    for shape in shapes:
        stop = start + _size(shape)
        blocks.append(flat[..., start:stop].reshape(flat.shape[:-1] + shape))
        start = stop
    return tuple(blocks)


def _size(shape: tuple[int, ...]) -> int:
    size = 1
    for length in shape:
        size *= length
    return size
