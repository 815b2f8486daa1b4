"""Memory in which a model is called for many states, used again from call to call."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from ctypes import addressof, c_double, c_size_t

from lagdsl.algebra.graph.operation import ARGUMENT_NAMES
from lagdsl.engines.runtime.engines.broadcast import Spread
from lagdsl.engines.runtime.engines.buffers import Buffers, place_of
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.engines.one_state import VECTORS
from lagdsl.engines.runtime.structures import Arguments, Batch, Strided

# Doubles that are kept for the next call; memory as large as this is made as fast as it is used.
_LARGEST = 1 << 21


class Bench:
    """`batch` is what C is told; arrays that are not given are those of `single`. For one thread at a time."""

    def __init__(self, model: NativeModel, single: Arguments) -> None:
        self._own, self._time = Buffers(model), c_double(0.0)
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

    def point_at_time(self, t: float) -> None:
        """The time of all states."""
        self._time.value = t
        self.point("t", addressof(self._time), 0)

    def release(self, names: Iterable[str]) -> None:
        """Arrays of these names are no longer looked at."""
        for name in names:
            self.point(name, self._single.get(name, 0), 0)


class Benches:
    """Free memory of one model."""

    def __init__(self, model: NativeModel, single: Arguments) -> None:
        self._model, self._single = model, single
        self._free: list[Bench] = []

    def take(self) -> Bench:
        """One that nobody else has until it is put back."""
        try:
            return self._free.pop()
        except IndexError:
            return Bench(self._model, self._single)

    def worker(
        self, many: Spread, call: Callable[[Batch, int, c_size_t], None], used: list[Bench]
    ) -> Callable[[int, int], None]:
        """Works on parts of `many` in memory of its own, which it adds to `used`."""
        bench = self.take()
        used.append(bench)
        batch, coordinate = bench.batch, bench.coordinate
        places = []
        for name, array, stride in many.arrays:
            if array.size:  # nobody looks at what has no entries
                address = place_of(array)
                strided = bench.point(name, address, stride)
                if stride:
                    places.append((strided, address, 8 * stride))

        def part(first: int, end: int) -> None:
            batch.count = end - first
            for strided, address, step in places:
                strided.first = address + first * step
            call(batch, first, coordinate)

        return part

    def put_back(self, used: list[Bench], names: Iterable[str]) -> None:
        """Takes back the memory of workers; arrays of these names may go."""
        for bench in used:
            bench.release(names)
        if self._model.workspace + self._model.memory + self._model.lanes < _LARGEST:
            self._free += used
