"""The order of instructions inside their groups, and the places of values: parts alike run over strides.

A model of many parts alike, the elements of a beam or the links of a chain, computes the same of each. Instructions of
one kind whose operands play the same roles in successive parts become one instruction over strides of the row: words
for one part in place of all, and vector registers for the work. A role is a kind, and the roles of the operands with
how many parts they are away; the roles of arguments are their names without a number.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain, pairwise

import numpy as np

from lagdsl.engines.backends.tape.instructions import STRIDED
from lagdsl.engines.backends.tape.nodes import LEAST, Ints, Roles, sorted_by
from lagdsl.engines.backends.tape.registers import Registers
from lagdsl.engines.backends.tape.selection import Selection
from lagdsl.foundation.record import record

_FACTORS = np.random.default_rng(13).integers(1, 1 << 62, size=16) * 2 + 1


@record()
class Stretch:
    """`steps` that follow on each other: those of one group, or of one instruction over strides."""

    steps: Ints | Sequence[int]
    strided: bool


class Arrangement:
    """The `stretches` of the groups of a `selection`, and the `place` of every value.

    `known` are the places that are settled, -1 for others, those of one and minus one at the end. The values `loaded`
    stand from `first` on, a negative one is no value. `roles` are those of arguments.
    """

    def __init__(
        self,
        selection: Selection,
        grouped: Sequence[Sequence[int]],
        known: Ints,
        loaded: Ints,
        results: Ints,
        roles: Roles,
        first: int,
    ) -> None:
        self._selection, self._first = selection, first
        self.place = known.copy()
        there = loaded >= 0
        self.place[loaded[there]] = first + np.flatnonzero(there)
        self._registers = Registers(self.place, first + len(loaded), (first + np.flatnonzero(~there)).tolist())
        self._role, self._part = roles.role.copy(), roles.part.copy()
        self._next = int(self._role.max(initial=-1)) + 1
        self._turns: dict[tuple[int, int], int] = {}
        self.stretches: list[Stretch] = []
        dying, bounds = self._dying(grouped, known, results)
        count, made = len(selection.made), selection.made.tolist()
        for group, (start, end) in zip(grouped, pairwise(bounds), strict=True):
            if group[0] >= count:
                self._turn(group[0])
            elif self._next and len(group) >= LEAST:
                self._group(np.array(group, dtype=np.int64))
            else:
                self._registers.take([made[step] for step in group])
                self.stretches.append(Stretch(group, strided=False))
            self._registers.give(dying[start:end])

    @property
    def top(self) -> int:
        """The first place beyond all."""
        return self._registers.top

    def _dying(self, grouped: Sequence[Sequence[int]], known: Ints, results: Ints) -> tuple[list[int], list[int]]:
        """The values that no group behind one reads, group by group, and where those of each begin."""
        selection = self._selection
        count = len(selection.made)
        order = np.fromiter(chain.from_iterable(grouped), dtype=np.int64)
        when = np.empty(count + len(selection.turns), dtype=np.int64)
        when[order] = np.repeat(np.arange(len(grouped)), [len(group) for group in grouped])
        last = np.full(selection.count + 2, -1, dtype=np.int64)
        last[selection.made] = when[:count]
        for number, turn in enumerate(selection.turns):
            for values in (turn.sines, turn.cosines):
                last[values[values >= 0]] = when[count + number]
        there = selection.operands >= 0
        rows = np.repeat(np.arange(count), np.count_nonzero(there, axis=1))
        np.maximum.at(last, selection.operands[there], when[rows])
        for number, turn in enumerate(selection.turns):
            last[turn.angles] = np.maximum(last[turn.angles], when[count + number])
        last[results] = -1
        values = np.flatnonzero((known < 0) & (last >= 0))
        ordered, bounds = sorted_by(last[values], len(grouped))
        return values[ordered].tolist(), bounds.tolist()

    def _turn(self, step: int) -> None:
        turn = self._selection.turns[step - len(self._selection.made)]
        for kind, values in enumerate((turn.sines, turn.cosines)):
            there = values >= 0
            own, angles = values[there], turn.angles[there]
            alike = self._role[angles] >= 0
            if np.count_nonzero(alike) >= LEAST:
                self._registers.take_block(own[alike])
                self._part[own[alike]] = self._part[angles[alike]]
                self._role[own[alike]] = [self._turned(kind, role) for role in self._role[angles[alike]].tolist()]
            self._registers.take(own.tolist())
        self.stretches.append(Stretch(np.array([step], dtype=np.int64), strided=False))

    def _turned(self, kind: int, role: int) -> int:
        """The role of sines or of cosines of angles in a role: turns are short, and parts are many."""
        if (kind, role) not in self._turns:
            self._turns[kind, role] = self._next
            self._next += 1
        return self._turns[kind, role]

    def _group(self, steps: Ints) -> None:
        made = self._selection.made
        keys, parts = self._keys(steps)
        order = np.lexsort((parts, keys))
        bounds = [0, *(np.flatnonzero(np.diff(keys[order])) + 1).tolist(), len(order)]
        others, found = [], list[Stretch]()
        for start, end in pairwise(bounds):
            own = order[start:end]
            if end - start < LEAST:
                others.append(own)
                continue
            values = made[steps[own]]
            self._registers.take_block(values)
            self._role[values], self._part[values] = self._next, parts[own]
            self._next += 1
            found += self._runs(steps[own])
        rest = np.concatenate([each.steps for each in found if not each.strided] or [steps[:0]])
        singles = np.sort(np.concatenate([np.zeros(0, dtype=np.int64), *others]))
        self._registers.take(made[steps[singles]].tolist())
        rest = np.concatenate([steps[singles], rest])
        if len(rest):
            self.stretches.append(Stretch(rest, strided=False))
        self.stretches += [each for each in found if each.strided]

    def _keys(self, steps: Ints) -> tuple[Ints, Ints]:
        """A number that is the same for steps of the same role, and the part of each."""
        operands = self._selection.operands[steps]
        roles, parts = self._role[operands], self._part[operands]
        alike = (roles >= 0) & (operands >= 0)
        column = np.argmax(alike, axis=1)
        base = np.where(alike.any(axis=1), parts[np.arange(len(steps)), column], 0)
        apart = np.where(alike, parts - base[:, None], 0)
        roles = np.where(operands >= 0, roles, 0)
        rows = np.concatenate([self._selection.signs[steps][:, None], roles, apart], axis=1)
        with np.errstate(over="ignore"):
            keys: Ints = (rows * _FACTORS[: rows.shape[1]]).sum(axis=1)
        return keys, base

    def _runs(self, steps: Ints) -> list[Stretch]:
        """Steps whose places are those of strides, and the others."""
        selection = self._selection
        if int(selection.code[steps[0]]) not in STRIDED:
            return [Stretch(steps, strided=False)]
        operands = selection.operands[steps]
        places = np.concatenate([self.place[selection.made[steps]][:, None], self.place[operands]], axis=1)
        places[:, 1:][operands < 0] = 0
        strides = np.diff(places, axis=0)
        changes = np.flatnonzero((np.diff(strides, axis=0) != 0).any(axis=1)) + 1
        found: list[Stretch] = []
        start, rest = 0, list[Ints]()
        for end in [*(changes + 1).tolist(), len(steps)]:
            if end - start >= LEAST and self._strided(places[start:end]):
                found.append(Stretch(steps[start:end], strided=True))
            else:
                rest.append(steps[start:end])
            start = end
        return [*found, *(Stretch(each, strided=False) for each in rest if len(each))]

    def _strided(self, places: Ints) -> bool:
        """True if nothing reads what the same instruction writes, and only places of the function itself vary: each of
        the others may be moved by itself."""
        first, second, last = places[0], places[1], places[-1]
        stride = second - first
        fixed = (stride == 0) | ((stride > 0) & (first >= self._first))
        apart = (last[1:] < first[0]) | (first[1:] > last[0])
        return bool(stride[0] == 1 and fixed.all() and apart.all())
