"""Memory in which a model is called for many states, used again from call to call."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from ctypes import c_size_t

from lagdsl.algebra.graph.operation import ARGUMENT_NAMES
from lagdsl.engines.runtime.engines.broadcast import Spread
from lagdsl.engines.runtime.engines.buffers import Buffers, place_of
from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.engines.one_state import VECTORS
from lagdsl.engines.runtime.structures import Arguments, Batch, Strided

# Doubles that are kept for the next call; memory as large as this is made as fast as it is used.
_LARGEST = 1 << 21


class Bench:
    """`batch` is what C is told; arrays that are not given are those of `single`. For one thread at a time."""

    def __init__(self, model: NativeModel, single: Arguments) -> None:
        self._own = Buffers(model)
        self.batch, self.coordinate = Batch(), c_size_t(0)
        for name in ("workspace", "memory", "lanes"):
            setattr(self.batch, name, getattr(self._own, name).ctypes.data)
        self._single = {ARGUMENT_NAMES[group]: getattr(single, ARGUMENT_NAMES[group]) for group in VECTORS}
        self._strided: dict[str, Strided] = {
            name: getattr(self.batch, name) for name, *kind in Batch._fields_ if kind == [Strided]
        }
        self.release(self._strided)

    def point(self, name: str, address: int, stride: int) -> Strided:
        """The array of this name begins there."""
        strided = self._strided[name]
        strided.first, strided.stride = address, stride
        return strided

    def release(self, names: Iterable[str]) -> None:
        """Arrays of these names are no longer looked at."""
        for name in names:
            self.point(name, self._single.get(name, 0), 0)


class Benches:
    """Free memory of one model."""

    def __init__(self, model: NativeModel, single: Arguments) -> None:
        self._model, self._single = model, single
        self._free: list[Bench] = []

    def worker(
        self, many: Spread, call: Callable[[Batch, int, c_size_t], None], used: list[Bench]
    ) -> Callable[[int, int], None]:
        """Works on parts of `many` in memory of its own, which it adds to `used`."""
        try:
            bench = self._free.pop()
        except IndexError:
            bench = Bench(self._model, self._single)
        used.append(bench)
        batch = bench.batch
        places = []
        for name, array, stride in _filled(many):
            address = place_of(array)
            strided = bench.point(name, address, stride)
            if stride:
                places.append((strided, address, 8 * stride))

        def part(first: int, end: int) -> None:
            batch.count = end - first
            for strided, address, step in places:
                strided.first = address + first * step
            call(batch, first, bench.coordinate)

        return part

    def put_back(self, used: list[Bench], many: Spread) -> None:
        """Takes back the memory of workers; arrays of `many` may go."""
        names = [name for name, _, _ in _filled(many)]
        for bench in used:
            bench.release(names)
        if self._model.workspace + self._model.memory + self._model.lanes < _LARGEST:
            self._free += used


def _filled(many: Spread) -> list[tuple[str, Floats, int]]:
    """Arrays that have entries; nobody looks at the others."""
    return [each for each in many.arrays if each[1].size]
