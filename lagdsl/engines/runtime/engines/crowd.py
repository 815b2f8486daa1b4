"""Accelerations of many states that come as arrays of floats: for a caller in a loop, without a look at other forms."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from ctypes import addressof, byref, c_char
from typing import Any

import numpy as np

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Layout
from lagdsl.engines.backends.python.support.values import FLOAT, require_room
from lagdsl.engines.runtime.engines.benches import Bench, Benches
from lagdsl.engines.runtime.engines.broadcast import Crowd
from lagdsl.engines.runtime.engines.cores import share_out
from lagdsl.engines.runtime.engines.engine import Floats, SingularSystem
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.engines.runtime.structures import Status

_OTHERS = {"z": Group.Z, "u": Group.U, "w": Group.W, "p": Group.P}
# Raises TypeError for an array that does not lie in one piece, or that nobody may write to.
_byte_of: Any = c_char.from_buffer


def crowd(layout: Layout, least: int, largest: int, place: Callable[[], tuple[NativeModel, Benches]]) -> Crowd:
    """qdd (count, nq) of at least `least` states, in parts of at most `largest`; None where q and qd are no arrays
    (count, nq), the others no such arrays nor vectors, the time no number. Parameters alone may be left out, and what
    has no entries. `place` gives the model and its memory."""
    n, m = layout.size(Group.Q), layout.size(Group.LAMBDA)
    defaults = np.array([*layout.defaults, 0.0])  # one number more, so that there is a place
    lengths = [(name, layout.size(group)) for name, group in _OTHERS.items()]
    forward = runtime_library().batch_forward_dynamics

    def found(threads: int | None, t: Any, q: Any, qd: Any, others: Sequence[Any], out: Floats | None) -> Floats | None:
        shape = (len(q), n) if isinstance(q, np.ndarray) and q.ndim and isinstance(t, float | int) else (0, n)
        if shape[0] < least or not (_is(q, shape) and _is(qd, shape)):
            return None
        arrays = _given(lengths, shape[0], others, defaults)
        if arrays is None or not (out is None or _lies_apart(out, shape, (q, qd, *others))):
            return None
        try:
            places = [(name, addressof(_byte_of(array)), stride) for name, array, stride in arrays]
            places += [(name, addressof(_byte_of(array)), n) for name, array in (("q", q), ("qd", qd))]
        except (TypeError, ValueError):
            return None
        return solve(threads, t, places, np.empty(shape) if out is None else out)

    def solve(threads: int | None, t: float, places: list[tuple[str, int, int]], qdd: Floats) -> Floats:
        lam = np.empty(len(qdd) * m + 1)
        to, multipliers = addressof(_byte_of(qdd)), addressof(_byte_of(lam))
        model, benches = place()
        used: list[Bench] = []

        def worker() -> Callable[[int, int], None]:
            bench = benches.take()
            used.append(bench)
            batch, coordinate = bench.batch, bench.coordinate
            strides = [(bench.point(*each), each[1], 8 * each[2]) for each in places]
            moving = [each for each in strides if each[2]]
            bench.point_at_time(t)
            told, guilty = byref(batch), byref(coordinate)

            def part(first: int, end: int) -> None:
                batch.count = end - first
                for strided, address, step in moving:
                    strided.first = address + first * step
                results = to + 8 * n * first, multipliers + 8 * m * first
                if forward(model.model, model.part, told, *results, guilty) == Status.SINGULAR:
                    raise SingularSystem(coordinate.value, layout)

            return part

        share_out(len(qdd), threads, worker, largest)
        benches.put_back(used, ("t", *(name for name, _, _ in places)))
        return qdd

    return found


def _given(
    lengths: Sequence[tuple[str, int]], count: int, others: Sequence[Any], defaults: Floats
) -> list[tuple[str, Floats, int]] | None:
    """Names, arrays and the numbers from one state to the next; None where there is another form."""
    found: list[tuple[str, Floats, int]] = []
    for (name, length), given in zip(lengths, others, strict=True):
        if given is None and (name == "p" or not length):
            array = defaults if name == "p" else None
        elif _is(given, (length,)) or _is(given, (count, length)):
            array = given
        else:
            return None
        if array is not None and length:
            found.append((name, array, length if array.ndim > 1 else 0))
    return found


def _lies_apart(out: Floats, shape: tuple[int, ...], given: Sequence[Any]) -> bool:
    """True if nothing is read where `out` is written. Raises ValueError for an `out` that has no room."""
    require_room(out, shape)
    return not any(np.may_share_memory(array, out) for array in given if array is not None)


def _is(given: Any, shape: tuple[int, ...]) -> bool:
    return given.__class__ is np.ndarray and given.dtype is FLOAT and given.shape == shape
