"""Disjoint sets (union-find): things that are one, in the order in which they were entered."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from typing import Generic, TypeVar

Thing = TypeVar("Thing", bound=Hashable)


class DisjointSets(Generic[Thing]):
    """Every thing is alone until it is joined; the first of a set stands for it. Things are entered in their order."""

    def __init__(self, things: Iterable[Thing] = ()) -> None:
        self._numbers: dict[Thing, int] = {}
        self._things: list[Thing] = []
        self._parents: list[int] = []
        for thing in things:
            self.enter(thing)

    def enter(self, thing: Thing) -> None:
        if thing not in self._numbers:
            self._numbers[thing] = len(self._things)
            self._things.append(thing)
            self._parents.append(self._numbers[thing])

    def first(self, thing: Thing) -> Thing:
        """The earliest of the set that the thing is in."""
        return self._things[self._root(self._numbers[thing])]

    def join(self, one: Thing, two: Thing) -> bool:
        """Make two sets one; False if they were."""
        a, b = self._root(self._numbers[one]), self._root(self._numbers[two])
        self._parents[max(a, b)] = min(a, b)
        return a != b

    def all(self) -> list[list[Thing]]:
        """The sets in the order of their first, each in order."""
        found: dict[int, list[Thing]] = {}
        for number, thing in enumerate(self._things):
            found.setdefault(self._root(number), []).append(thing)
        return list(found.values())

    def _root(self, number: int) -> int:
        while self._parents[number] != number:
            self._parents[number] = self._parents[self._parents[number]]
            number = self._parents[number]
        return number
