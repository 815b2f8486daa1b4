"""The instructions of a function: one for every node, but that sums take in their terms.

Products join the sums that they are terms of, and a sum takes in the one that it goes on from: up to three products are
added in one instruction, with the roundings of separate ones. A term that is no product is multiplied by one, which
changes no bit.
"""

from __future__ import annotations

import numpy as np

from lagdsl.algebra.graph.operation import FIRST_UNARY, Op
from lagdsl.engines.backends.tape.instructions import ANGLES, INSTRUCTION, MOST_OPERANDS, THREE_PRODUCTS, TWO_PRODUCTS
from lagdsl.engines.backends.tape.nodes import Flags, Ints, Nodes, distinct
from lagdsl.foundation.record import record

# A product in more sums than this is computed once.
_MOST_SUMS = 3


@record()
class Turn:
    """Sines and cosines of angles; local numbers, -1 for what nothing reads."""

    angles: Ints
    sines: Ints
    cosines: Ints


@record()
class Selection:
    """The instructions of a function, by the local number of the node that each computes, ascending.

    Local numbers count the `count` nodes that the function needs; the next two are one and minus one. `code` and
    `operands` (instructions, MOST_OPERANDS), local numbers or -1, are by instruction; `signs` where these are sums: 1
    the last product is subtracted; of three products, 2 the second one is.
    """

    count: int
    made: Ints
    code: Ints
    operands: Ints
    signs: Ints
    turns: tuple[Turn, ...]


def select(nodes: Nodes, live: Ints, at_hand: Flags, results: Ints) -> Selection:
    """Instructions for the nodes `live` that are not `at_hand`; `results` are asked for, by local number."""
    op = nodes.op[live]
    count = len(live)
    local = np.zeros(int(live[-1]) + 1 if count else 0, dtype=np.int64)
    local[live] = np.arange(count)
    computed = (op >= FIRST_UNARY) & ~at_hand
    operands = np.full((3, count), -1, dtype=np.int64)
    raw = nodes.operands[:, live]
    there = (raw >= 0) & computed
    operands[there] = local[raw[there]]
    turned = computed & ((op == Op.SIN) | (op == Op.COS))
    joined = _joined(op, operands, computed, results)
    made = np.flatnonzero(computed & ~turned & ~joined)
    code, own = INSTRUCTION[op[made]], _operands(op, operands, joined, made)
    signs = (op[made] == Op.SUBTRACT).astype(np.int64)
    turns = _turns(op, operands, turned, computed)
    kept = np.concatenate([results, *(turn.angles for turn in turns)])
    once = np.bincount(own[own >= 0], minlength=count + 2) == 1
    once[kept] = False
    remaining = _take_in(made, code, own, signs, once)
    return Selection(count, made[remaining], code[remaining], own[remaining], signs[remaining], turns)


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


def _operands(op: Ints, operands: Ints, joined: Flags, made: Ints) -> Ints:
    """The operands of the instructions for the nodes `made`."""
    one, minus_one = len(op), len(op) + 1
    own = np.full((len(made), MOST_OPERANDS), -1, dtype=np.int64)
    own[:, :3] = operands[:, made].T
    own[op[made] == Op.NEGATE, 1] = minus_one
    sums = np.flatnonzero((op[made] == Op.ADD) | (op[made] == Op.SUBTRACT))
    for column, term in zip((0, 2), operands[:2, made[sums]], strict=True):
        own[sums, column] = np.where(joined[term], operands[0, term], term)
        own[sums, column + 1] = np.where(joined[term], operands[1, term], one)
    return own


def _take_in(made: Ints, code: Ints, own: Ints, signs: Ints, once: Flags) -> Ints:
    """Sums take in the sum of two products that they go on from, if it is read `once`. Returns what remains."""
    one = len(once) - 2
    maker = np.full(len(once), -1, dtype=np.int64)
    maker[made] = np.arange(len(made))
    rows = np.flatnonzero(code == TWO_PRODUCTS)
    pairs = []
    for column in (0, 2):
        value = own[rows, column]
        inner = maker[value]
        fits = (own[rows, column + 1] == one) & once[value] & (inner >= 0) & (code[inner] == TWO_PRODUCTS)
        fits &= (column == 0) | (signs[rows] == 0)  # x - (y + z) is none
        pairs.append(np.array([rows[fits], inner[fits], np.full(np.count_nonzero(fits), 2 - column)]))
    outer, inner, rest = _apart(np.concatenate(pairs, axis=1), len(made))
    last = own[outer, rest], own[outer, rest + 1]
    own[outer, :4] = own[inner, :4]
    own[outer, 4], own[outer, 5] = last
    signs[outer] += 2 * signs[inner]
    code[outer] = THREE_PRODUCTS
    remains = np.ones(len(made), dtype=np.bool_)
    remains[inner] = False
    return np.flatnonzero(remains)


def _apart(pairs: Ints, count: int) -> Ints:
    """Pairs, in the order of their first members, that share no member with the ones before."""
    pairs = pairs[:, np.argsort(pairs[0], kind="stable")]
    kept = (np.bincount(pairs[:2].ravel(), minlength=count)[pairs[:2]] == 1).all(axis=0)
    used = bytearray(count)
    shared = np.flatnonzero(~kept)
    for index, outer, inner in zip(shared.tolist(), *pairs[:2, shared].tolist(), strict=True):
        if not (used[outer] or used[inner]):
            used[outer] = used[inner] = 1
            kept[index] = True
    return pairs[:, kept]


def _turns(op: Ints, operands: Ints, turned: Flags, computed: Flags) -> tuple[Turn, ...]:
    """Sines and cosines together, those first whose angles hold no others."""
    where = np.flatnonzero(turned)
    if not len(where):
        return ()
    angles = distinct(len(op), operands[0, where])
    values = np.full((2, len(turned)), -1, dtype=np.int64)
    values[np.where(op[where] == Op.SIN, 0, 1), operands[0, where]] = where
    level = _levels(operands, turned, computed, angles)
    turns = []
    for k in range(int(level.max()) + 1):
        members = angles[level == k]
        for start in range(0, len(members), ANGLES):
            own = members[start : start + ANGLES]
            turns.append(Turn(own, *values[:, own]))
    return tuple(turns)


def _levels(operands: Ints, turned: Flags, computed: Flags, angles: Ints) -> Ints:
    """Depth of nested sines in each of `angles`."""
    if not computed[angles].any():
        return np.zeros(len(angles), dtype=np.int64)
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
    return np.array([level.get(angle, 0) for angle in angles.tolist()], dtype=np.int64)
