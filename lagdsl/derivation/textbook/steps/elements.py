"""Elements of a mesh, found by the coordinates that energies and masses share."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.quantity import Item
from lagdsl.language.flat.traversal import step_expressions


class Elements:
    """An element is what depends on the same coordinates as an energy. A mass belongs to the element with the fewest
    coordinates that has all of its own, the first of them; it is an element of its own where there is none."""

    def __init__(self, flat: fm.FlatModel, dependence: Dependence) -> None:
        self._dependence = dependence
        self._names = frozenset(coordinate.name for coordinate in flat.coordinates)
        self._numbers: dict[frozenset[str], int] = {}
        self._sharing: dict[str, list[frozenset[str]]] = {name: [] for name in self._names}
        self._found: dict[frozenset[str], int] = {}
        self._energies: dict[tuple[str, int], list[fm.EnergyTerm]] = {}
        for term in flat.energies:
            element = self.of([term.value], whole=True)
            for name in self._names.intersection(dependence.of(term.value)):
                self._energies.setdefault((name, element), []).append(term)
        named = {item.name: item for item in flat.named}
        for mass in flat.masses:
            self.of([mass.position])
        for body in flat.bodies:
            frame = same_frame(named, body.frame)
            if frame is not None:
                self.of(places_of(frame))

    def of(self, expressions: Iterable[fx.FlatExpression], *, whole: bool = False) -> int:
        """The number of the element to which the expressions belong, from 1. `whole`: with the same coordinates."""
        names = self._names.intersection(name for each in expressions for name in self._dependence.of(each))
        if names not in self._found:
            holding = [] if whole else [each for each in self._sharing[min(names)] if names <= each] if names else []
            element = min(holding, key=len, default=names)
            if element not in self._numbers:
                self._numbers[element] = len(self._numbers) + 1
                for name in element:
                    self._sharing[name].append(element)
            self._found[names] = self._numbers[element]
        return self._found[names]

    def energies(self, coordinate: str, element: int) -> list[fm.EnergyTerm]:
        """The energies of an element that depend on the coordinate."""
        return self._energies.get((coordinate, element), [])

    def sharing(self, coordinate: str) -> list[int]:
        """The elements of a coordinate."""
        return [self._numbers[each] for each in self._sharing[coordinate]]


def same_frame(named: Mapping[str, Item], name: str) -> fm.Frame | None:
    """The frame, or that from which it takes no step; None for the world."""
    found = named.get(name)
    while isinstance(found, fm.Frame) and not found.steps:
        found = named.get(found.parent)
    return found if isinstance(found, fm.Frame) else None


def places_of(frame: fm.Frame) -> list[fx.FlatExpression]:
    """Expressions of the steps that a frame takes from the one that carries it."""
    return [each for step in frame.steps for each in step_expressions(step)]
