"""The diagram of a circuit beside the machine: a branch for each charge, with the symbols of IEC 60617.

A potential of a charge is a capacitor, a kinetic energy of its current an inductor, a dissipation a resistor, a term
that is linear in the current an electric machine, a load a source of voltage, a constraint of the current a source of
current. Branches meet where Kirchhoff's law holds; what leaves one node alone flows to earth.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from itertools import count, pairwise

import numpy as np

from lagdsl.derivation.scene.looks import COLORS, arrow
from lagdsl.derivation.scene.machine import Machine, fixed, number
from lagdsl.derivation.scene.shapes import Numbers, Part, Scene, Shape, Size
from lagdsl.derivation.scene.stage import first_sight, places_of
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.foundation.units.dimension import CHARGE
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm

_CELL = 0.25  # of the machine beside it: the length of a symbol with its leads
_ROW = 0.7  # of a cell: between branches above each other
_WIRE = 0.04  # of a cell, as wide as the strokes of symbols
_SYMBOLS = {
    "kinetic": "inductor",
    "potential": "capacitor",
    "dissipation": "resistor",
    "lagrangian": "electric machine",
}
_ORDER = ("voltage source", "current source", "resistor", "inductor", "capacitor", "electric machine")
_SOURCES = frozenset({"voltage source", "current source", "electric machine"})
_EARTH = -1

Cells = tuple[float, float]
"""A place, to the right and up."""


@record()
class _Edge:
    """A symbol, or none, between two nodes of the diagram, in the sense of the current."""

    charge: str
    symbol: str
    ends: tuple[int, ...]


@record()
class _Stroke:
    """A symbol of one cell, or a wire; `sense`: of the current in it."""

    charge: str
    symbol: str
    start: Cells
    end: Cells
    sense: float = 0.0


def circuits(machine: Machine, scene: Scene, up: Floats) -> Iterator[Shape]:
    """One shape for each branch, left of what the scene shows where the motion begins."""
    strokes = _laid_out(_edges(machine))
    if not strokes:
        return
    points = places_of(scene, np.array([[number(machine.start, each) for each in scene.columns]]))
    right = np.cross(up, first_sight(up))
    cell = _CELL * float(np.linalg.norm(np.ptp(points, axis=0)))
    width = max(each.end[0] for each in strokes) + 1.0
    corner, middle = points @ np.array([right, up]).T, points.mean(axis=0)
    (left, low), (own, high) = corner.min(axis=0), np.array([right, up]) @ middle
    origin = middle + (left - own - width * cell) * right + (low - high) * up

    @cache
    def place(x: float, y: float) -> fx.FlatExpression:
        return fixed(origin + cell * (x * right + y * up))

    thin, one = Size(_WIRE * cell, None, False), Size(cell, None, False)
    across = fixed(-up), fixed(right)
    for charge in machine.flat.coordinates:
        parts: list[Part] = []
        numbers: Numbers = {}
        for each in (stroke for stroke in strokes if stroke.charge == charge.name):
            stands = each.start[0] == each.end[0]
            form, sizes = (each.symbol, (one, one, one)) if each.symbol else ("beam", (thin, thin, Size(1.0)))
            ends = {"at": place(*each.start), "to": place(*each.end), "x": across[stands]}
            parts.append(Part(form=form, numbers=ends, sizes=sizes))
            if each.sense and not numbers:
                x, y = np.add(each.start, (-0.35, 0.5) if stands else (0.5, 0.3))
                way = fixed(each.sense * (up if stands else right))
                current = fx.Binary("*", fx.Derivative(fx.Variable(charge.name)), way)
                numbers = {"at": place(x, y), "vector": current}
                parts.append(replace(arrow({"at": place(x, y), "z": current}, "current"), color=COLORS["arrow"]))
        if parts:
            yield Shape(kind="branch", name=charge.name, numbers=numbers, parts=tuple(parts), spans=charge.spans)


def _edges(machine: Machine) -> list[_Edge]:
    """The symbols of a charge are in series, the node between two of them is new; so are the ends of a charge that
    leaves no node, which flows in a ring."""
    flat = machine.flat
    rows = [row for each in flat.constraints if each.node for row in each.residuals]
    new, grounded = count(len(rows)), {_EARTH}
    found: list[_Edge] = []
    for charge in (each for each in flat.coordinates if each.dimension == CHARGE):
        at = machine.at(0, {charge.name: 1.0})
        currents = np.array([number(at, row) for row in rows])
        tails, heads = (np.flatnonzero(sign * currents > 0.0).tolist() for sign in (1.0, -1.0))
        symbols = _symbols(machine, charge.name)
        if len(tails) + len(heads) == 1 and not symbols:
            grounded.update(tails, heads)
            continue
        other = _EARTH if tails or heads else next(new)
        tail, head = (*tails, other)[0], (*heads, other)[0]
        symbols += [""] * (1 - len(symbols) + (tail == head))
        nodes = [tail, *(next(new) for _ in symbols[1:]), head]
        found += [_Edge(charge.name, each, ends) for each, ends in zip(symbols, pairwise(nodes), strict=True)]
    return [replace(each, ends=tuple(_EARTH if node in grounded else node for node in each.ends)) for each in found]


def _symbols(machine: Machine, charge: str) -> list[str]:
    flat = machine.flat
    found = {_SYMBOLS[each.kind] for each in flat.energies if charge in machine.movers_of(each.value)}
    if any(isinstance(each, fm.GeneralizedForce) and each.target == fx.Variable(charge) for each in flat.loads):
        found.add("voltage source")
    laws = (row for each in flat.constraints if not (each.node or each.of_law) for row in each.residuals)
    if any(charge in machine.movers_of(row) for row in laws):
        found.add("current source")
    return sorted(found, key=_ORDER.index)


def _laid_out(edges: list[_Edge]) -> list[_Stroke]:
    """Each connected part over a rail, which is the earth or the node of most branches: branches to the rail stand, in
    columns, those between neighbours lie above them, all others higher."""
    found: list[_Stroke] = []
    x = 0.0
    while edges:
        nodes = {edges[0].ends[0], *_along(edges, edges[0].ends[0])}
        x = _lay([each for each in edges if each.ends[0] in nodes], x, found)
        edges = [each for each in edges if each.ends[0] not in nodes]
    return found


def _lay(edges: list[_Edge], x: float, found: list[_Stroke]) -> float:
    """Adds the strokes of a connected part to those `found`, and returns the first free column."""
    degrees = Counter(node for each in edges for node in each.ends)
    rail = _EARTH if _EARTH in degrees else max(degrees, key=lambda node: (degrees[node], -node))
    order = _along(edges, rail)
    first, left, right = x, dict[int, float](), dict[int, float]()
    for node in order:
        left[node] = right[node] = x
        standing = [each for each in edges if set(each.ends) == {node, rail}]
        for each in standing:
            found.append(_Stroke(each.charge, each.symbol, (x, 0.0), (x, 1.0), 1.0 if each.ends[0] == rail else -1.0))
            found += _wires(each.charge, (right[node], 1.0), (x, 1.0))
            found += _wires(each.charge, (first, 0.0), (x, 0.0))
            right[node], x = x, x + 1.0
        x = max(x, left[node] + 1.0)
    if rail == _EARTH:
        found.append(_Stroke(edges[0].charge, "earth", (first, 0.0), (first, -1.0)))
    above, taken = 1.0, set[tuple[int, int]]()
    for each in (each for each in edges if rail not in each.ends):
        a, b = sorted(each.ends, key=order.index)
        y = 1.0
        if order.index(b) - order.index(a) > 1 or (a, b) in taken:
            y = above = above + _ROW
        taken.add((a, b))
        begin = (right[a] + left[b] - 1.0) / 2.0
        sense = 1.0 if each.ends[0] == a else -1.0
        found.append(_Stroke(each.charge, each.symbol, (begin, y), (begin + 1.0, y), sense))
        found += _wires(each.charge, (right[a], 1.0), (right[a], y), (begin, y))
        found += _wires(each.charge, (begin + 1.0, y), (left[b], y), (left[b], 1.0))
    return x


def _wires(charge: str, *places: Cells) -> list[_Stroke]:
    """From each place to the next one, if it is another."""
    return [_Stroke(charge, "", a, b) for a, b in pairwise(places) if a != b]


def _along(edges: list[_Edge], rail: int) -> list[int]:
    """The nodes but the rail, each beside the one that a branch leads from, beginning at the sources."""
    ranked = sorted(edges, key=lambda each: each.symbol not in _SOURCES)
    found: list[int] = []
    waiting = [node for each in reversed(ranked) if rail in each.ends for node in each.ends]
    while waiting:
        node = waiting.pop()
        if node != rail and node not in found:
            found.append(node)
            waiting += [other for each in reversed(ranked) if node in each.ends for other in each.ends]
    return found
