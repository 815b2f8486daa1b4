"""The instructions of a function: products join the sums that they are terms of, nodes follow one another in trees."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from lagdsl.backends.tape.instructions import ALONE, ANGLES, MOST_OPERANDS, Form
from lagdsl.backends.tape.nodes import Flags, Ints, Nodes
from lagdsl.graph.operation import FIRST_UNARY, Op

# A product in more sums than this is computed once.
_MOST_SUMS = 3


@dataclass(frozen=True, slots=True)
class Turn:
    """Sines and cosines of angles, after the instructions of `phase`; local numbers, -1 for what nothing reads."""

    phase: int
    angles: Ints
    sines: Ints
    cosines: Ints


@dataclass(frozen=True, slots=True)
class Selection:
    """The instructions of a function in order, by the local number of the node that each computes.

    Local numbers count the nodes that the function needs. `form` and `operands` (instructions, MOST_OPERANDS), local
    numbers or -1, are by instruction. `uses` counts, by local number, how often a value is read,
    `results` last.
    `phase` is that of every instruction, ascending; those of `turns` come between the phases.
    """

    made: Ints
    form: Ints
    operands: Ints
    uses: Ints
    results: Ints
    phase: Ints
    turns: tuple[Turn, ...]


def select(nodes: Nodes, live: Ints, at_hand: Flags, results: Ints) -> Selection:
    """Instructions for the nodes `live` that are not `at_hand`; `results` are asked for, by local number."""
    op = nodes.op[live]
    local = np.zeros(int(live[-1]) + 1 if len(live) else 0, dtype=np.int64)
    local[live] = np.arange(len(live))
    computed = (op >= FIRST_UNARY) & ~at_hand
    operands = np.full((3, len(live)), -1, dtype=np.int64)
    raw = nodes.operands[:, live]
    there = (raw >= 0) & computed
    operands[there] = local[raw[there]]
    turned = computed & ((op == Op.SIN) | (op == Op.COS))
    joined = _joined(op, operands, computed, results)
    made = np.flatnonzero(computed & ~turned & ~joined)
    form, terms = _forms(op, operands, joined, made)
    turns, phase = _turns(op, operands, turned, computed)
    kept = np.concatenate([results, *(turn.angles for turn in turns)])
    uses = np.bincount(np.concatenate([terms[terms >= 0], kept]), minlength=len(live))
    only = uses == 1
    only[kept] = False
    order = _order(made, terms, only, phase)
    return Selection(made[order], form[order], terms[order], uses, results, phase[made][order], turns)


def _joined(op: Ints, operands: Ints, computed: Flags, results: Ints) -> Flags:
    """Products that are read by sums and differences only, and by few."""
    product = computed & (op == Op.MULTIPLY)
    summing = computed & ((op == Op.ADD) | (op == Op.SUBTRACT))
    for row in operands:
        other = row[computed & ~summing]
        product[other[other >= 0]] = False
    product[results] = False
    terms = operands[:2, summing].ravel()
    joined: Flags = product & (np.bincount(terms, minlength=len(op)) <= _MOST_SUMS)
    return joined


def _forms(op: Ints, operands: Ints, joined: Flags, made: Ints) -> tuple[Ints, Ints]:
    """Instructions of the nodes `made`, and their operands."""
    form = ALONE[op[made]]
    terms = np.full((len(made), MOST_OPERANDS), -1, dtype=np.int64)
    terms[:, :3] = operands[:, made].T
    sums = np.flatnonzero((form == Form.ADD) | (form == Form.SUBTRACT))
    x, y = terms[sums, 0], terms[sums, 1]
    of_x, of_y = joined[x], joined[y]
    adds = form[sums] == Form.ADD
    for which, into in (
        (of_x & of_y, (Form.MUL_ADD_MUL, Form.MUL_SUB_MUL)),
        (of_x & ~of_y, (Form.MUL_ADD, Form.MUL_SUB)),
        (~of_x & of_y, (Form.MUL_ADD, Form.SUB_MUL)),
    ):
        rows = sums[which]
        first, second = (x[which], y[which]) if into[1] is not Form.SUB_MUL else (y[which], x[which])
        form[rows] = np.where(adds[which], *into)
        terms[rows, 0], terms[rows, 1] = operands[0, first], operands[1, first]
        if into[0] is Form.MUL_ADD_MUL:
            terms[rows, 2], terms[rows, 3] = operands[0, second], operands[1, second]
        else:
            terms[rows, 2] = second
    return form, terms


def _order(made: Ints, terms: Ints, only: Flags, phase: Ints) -> Ints:
    """Trees of values that are read once stand together, before what reads their roots; as far as phases let them."""
    place = np.full(len(only), -1, dtype=np.int64)
    place[made] = np.arange(len(made))
    above = np.arange(len(made))
    for column in terms.T:
        inner = (column >= 0) & (place[column] >= 0) & only[column]
        above[place[column[inner]]] = np.flatnonzero(inner)
    while True:
        further = above[above]
        if np.array_equal(further, above):
            break
        above = further
    return np.lexsort((made, above, phase[made]))


# ---- sines and cosines -----------------------------------------------------------------------------------------------


def _turns(op: Ints, operands: Ints, turned: Flags, computed: Flags) -> tuple[tuple[Turn, ...], Ints]:
    """Sines and cosines together, those first whose angles hold no others; and the phase of every node."""
    where = np.flatnonzero(turned)
    if not len(where):
        return (), np.zeros(len(turned), dtype=np.int64)
    angles = np.unique(operands[0, where])
    values = np.full((2, len(turned)), -1, dtype=np.int64)
    values[np.where(op[where] == Op.SIN, 0, 1), operands[0, where]] = where
    level = _levels(operands, turned, computed, angles)
    of_angle = np.array([level.get(angle, 0) for angle in angles.tolist()])
    depth = int(of_angle.max()) + 1
    phase = np.full(len(turned), depth, dtype=np.int64)
    phase[list(level)] = list(level.values())
    turns = []
    for k in range(depth):
        members = angles[of_angle == k]
        for start in range(0, len(members), ANGLES):
            own = members[start : start + ANGLES]
            turns.append(Turn(k, own, *values[:, own]))
    return tuple(turns), phase


def _levels(operands: Ints, turned: Flags, computed: Flags, angles: Ints) -> dict[int, int]:
    """For all that angles are computed from: how many sines are one inside the other."""
    columns = operands.tolist()
    wanted = set[int]()
    stack: list[int] = angles.tolist()
    while stack:
        node = stack.pop()
        if node not in wanted and computed[node]:
            wanted.add(node)
            stack.extend(column[node] for column in columns if column[node] >= 0)
    level: dict[int, int] = {}
    for node in sorted(wanted):
        inner = max((level.get(column[node], 0) for column in columns if column[node] >= 0), default=0)
        level[node] = inner + bool(turned[node])
    return level


def live_of(nodes: Nodes, roots: Sequence[int], given: frozenset[int]) -> Ints:
    """All nodes that `roots` are computed from, as far as those of `given`; ascending."""
    return np.array(nodes.graph.live(roots, given), dtype=np.int64)
