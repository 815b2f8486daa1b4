"""Memory of calls that serves again, for as long as a model computes them."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from numpy.typing import ArrayLike

from lagdsl.engines.runtime.engines.benches import Benches
from lagdsl.engines.runtime.engines.engine import Floats
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.engines.one_value import Place
from lagdsl.engines.runtime.structures import Arguments


class Memory:
    """That of one engine; `wholes` are functions of one state, by name, which have it."""

    def __init__(self) -> None:
        self.wholes: dict[str, Callable[[Sequence[ArrayLike]], Floats | None]] = {}
        self._places: list[list[Place]] = []
        self._benches: dict[int, Benches] = {}

    def of_a_value(self) -> list[Place]:
        """A list of what is free for one value, empty at first."""
        free = list[Place]()
        self._places.append(free)
        return free

    def of_many(self, model: NativeModel, single: Arguments) -> Benches:
        """That of `model` for many states; arrays that are not given are those of `single`."""
        known = self._benches.get(id(model))
        if known is None:
            known = self._benches[id(model)] = Benches(model, single)
        return known

    def clear(self) -> None:
        """Another model computes from now on."""
        self._benches = {}
        for places in self._places:
            places.clear()
