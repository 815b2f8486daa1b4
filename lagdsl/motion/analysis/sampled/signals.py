"""Entries of w that a sampled loop goes through: which of them act, and which of those can move by small amounts."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from lagdsl.language.flat.events import Discrete, Entry, Memory, entries
from lagdsl.motion.analysis.held import MOTION, entries_read, nodes_of, reached_by_ticks
from lagdsl.motion.analysis.linearize import Named
from lagdsl.motion.analysis.point import System
from lagdsl.motion.analysis.sparsity.accelerations import bits_of

_KEPT = ("variable", "condition")


@dataclass(frozen=True, slots=True)
class Signals:
    """`places` in w of numbers that move by small amounts, with their names; `modes` are places of what acts, too, and
    changes by jumps only: truths, counters."""

    places: tuple[int, ...]
    names: tuple[Named, ...]
    modes: tuple[int, ...]

    def __len__(self) -> int:
        return len(self.places)


def signals_of(system: System, moving: Iterable[int], *, with_outputs: bool) -> Signals:
    """`moving` are places of Integers that follow numbers by quantizers; without them Integers are modes."""
    layout = system.program.layout
    if not system.flat.events.clocks:
        return Signals((), (), ())
    every = entries(system.flat.events)
    acting = _acting(system, with_outputs=with_outputs)
    moves = {place for place in acting if _is_number(every[place])} | (set(moving) & acting)
    places = tuple(sorted(moves))
    names = tuple(Named(layout.discretes[place].name, layout.discretes[place].unit) for place in places)
    return Signals(places, names, tuple(sorted(p for p in acting - moves if every[p].kind in _KEPT)))


def integers(system: System) -> list[int]:
    """Places of Integers."""
    every = entries(system.flat.events)
    return [k for k, entry in enumerate(every) if isinstance(entry.item, Discrete) and entry.item.kind == "Integer"]


def _is_number(entry: Entry) -> bool:
    item = entry.item
    return (isinstance(item, Discrete) and item.kind == "Real") or (isinstance(item, Memory) and not item.truth)


def _acting(system: System, *, with_outputs: bool) -> set[int]:
    """Places in w that ticks change, and on which the motion depends, what clauses set of it, or the outputs; at
    once or through others."""
    program, layout = system.program, system.program.layout
    acts, values = (block.elements for block in program.function("event").results[1:3])
    acting = [*nodes_of(program, (*MOTION, *(("output",) if with_outputs else ()))), *acts, *values]
    found, read = entries_read(program, acting)
    reached = found.of_all(acting)[0]
    before = 0
    while reached != before:
        before = reached
        for place in bits_of(before):
            reached |= read.get(place, 0)
    return set(bits_of(reached & reached_by_ticks(layout.kinds, read)))
