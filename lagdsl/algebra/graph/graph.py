"""The hash-consed expression graph: every distinct expression is one node, and a node's arguments come before it.

Simplification happens only here, when a node is made, and only by rules that look one level down: constants fold, zeros
and ones vanish, signs move outward. Products are never expanded. Because ids are a topological order, every pass over a
graph is one loop over lists.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Hashable, Iterable, Sequence

from lagdsl.algebra.graph.fold import fold
from lagdsl.algebra.graph.operation import FIRST_BINARY, FIRST_TERNARY, FIRST_UNARY, Group, Op

_LARGEST_UNROLLED_POWER = 8
_ODD = (Op.SIN, Op.TAN, Op.ASIN, Op.ATAN, Op.SINH, Op.TANH, Op.SIGN)
_EVEN = (Op.COS, Op.COSH, Op.ABS)
# Looking a member up in its enumeration costs more than everything else that `add` and `multiply` do.
_CONSTANT, _NEGATE, _ADD, _SUBTRACT, _MULTIPLY = Op.CONSTANT, Op.NEGATE, Op.ADD, Op.SUBTRACT, Op.MULTIPLY


# By number: a call of the enumeration looks for the member.
_GROUPS = tuple(map(Group, range(len(Group))))

# The node of 0.0 in every graph.
ZERO = 0


class Graph:
    """Nodes as parallel lists, indexed by id: `op`, and arguments `a`, `b`, `c` (ids; -1 where absent).

    A constant keeps its value in `value`; a symbol keeps its group in `a` and its index in that array in `b`;
    `operands` are the nodes that a node is computed from, `groups` the groups of symbols, as a bit mask (`1 << group`).
    """

    def __init__(self) -> None:
        self.op: list[Op] = []
        self.a: list[int] = []
        self.b: list[int] = []
        self.c: list[int] = []
        self.operands: list[tuple[int, ...]] = []
        self.groups: list[int] = []
        self.value: dict[int, float] = {}
        self._index: list[dict[Hashable, int]] = [{} for _ in range(max(Op) + 1)]
        self.zero = self.constant(0.0)
        assert self.zero == ZERO
        self.one = self.constant(1.0)

    def __len__(self) -> int:
        return len(self.op)

    # ---- leaves ------------------------------------------------------------------------------------------------------

    def constant(self, value: float) -> int:
        """The node of a finite number or infinity; -0.0 is 0.0."""
        value = float(value) + 0.0
        assert not math.isnan(value)
        node = self._index[_CONSTANT].get(value)
        if node is None:
            node = self._append(_CONSTANT, -1, -1, -1, (), 0)
            self._index[_CONSTANT][value] = node
            self.value[node] = value
        return node

    def symbol(self, group: Group, index: int = 0) -> int:
        table = self._index[Op.SYMBOL]
        key = (int(group), index)
        node = table.get(key)
        if node is None:
            node = self._append(Op.SYMBOL, *key, -1, (), 1 << group)
            table[key] = node
        return node

    def symbols(self, group: Group, size: int) -> list[int]:
        return [self.symbol(group, index) for index in range(size)]

    # ---- arithmetic --------------------------------------------------------------------------------------------------

    def negate(self, x: int) -> int:
        op = self.op[x]
        if op is _CONSTANT:
            return self.constant(-self.value[x])
        if op is _NEGATE:
            return self.a[x]
        if op is _SUBTRACT:
            return self.subtract(self.b[x], self.a[x])
        return self._make_unary(_NEGATE, x)

    def add(self, x: int, y: int) -> int:
        if x == self.zero:
            return y
        if y == self.zero:
            return x
        op_x, op_y = self.op[x], self.op[y]
        if op_x is _CONSTANT and op_y is _CONSTANT:
            folded = self._fold(_ADD, x, y)
            if folded is not None:
                return folded
        if op_y is _NEGATE:
            return self.subtract(x, self.a[y])
        if op_x is _NEGATE:
            return self.subtract(y, self.a[x])
        if x == y:
            return self.multiply(self.constant(2.0), x)
        return self._make_binary(_ADD, x, y) if x < y else self._make_binary(_ADD, y, x)

    def subtract(self, x: int, y: int) -> int:
        if y == self.zero:
            return x
        if x == self.zero:
            return self.negate(y)
        if x == y:
            return self.zero
        op_x, op_y = self.op[x], self.op[y]
        if op_x is _CONSTANT and op_y is _CONSTANT:
            folded = self._fold(_SUBTRACT, x, y)
            if folded is not None:
                return folded
        if op_y is _NEGATE:
            return self.add(x, self.a[y])
        if op_x is _NEGATE:
            return self.negate(self.add(self.a[x], y))
        opposite = self._index[_SUBTRACT].get((y, x))
        if opposite is not None:
            return self._make_unary(_NEGATE, opposite)
        return self._make_binary(_SUBTRACT, x, y)

    def multiply(self, x: int, y: int) -> int:
        zero, one = self.zero, self.one
        if x == zero or y == zero:  # noqa: PLR1714 a tuple takes as long as the rest
            return zero
        if x == one:
            return y
        if y == one:
            return x
        ops = self.op
        op_x, op_y = ops[x], ops[y]
        if op_y is _CONSTANT or op_x is _CONSTANT:
            return self._multiply_by_constant(x, y) if op_x is _CONSTANT else self._multiply_by_constant(y, x)
        if op_x is _NEGATE:
            return self.negate(self.multiply(self.a[x], y))
        if op_y is _NEGATE:
            return self.negate(self.multiply(x, self.a[y]))
        return self._make_binary(_MULTIPLY, x, y) if x < y else self._make_binary(_MULTIPLY, y, x)

    def _multiply_by_constant(self, constant: int, y: int) -> int:
        op_y = self.op[y]
        if op_y is _CONSTANT:
            folded = self._fold(_MULTIPLY, constant, y)
            if folded is not None:
                return folded
        factor = self.value[constant]
        if factor < 0.0:
            return self.negate(self.multiply(self.constant(-factor), y))
        if op_y is _NEGATE:
            return self.negate(self.multiply(constant, self.a[y]))
        if op_y is _MULTIPLY and self.op[self.a[y]] is _CONSTANT:
            gathered = fold(_MULTIPLY, factor, self.value[self.a[y]])
            if gathered is not None:
                return self.multiply(self.constant(gathered), self.b[y])
        return self._make_binary(_MULTIPLY, constant, y)

    def divide(self, x: int, y: int) -> int:
        """Division by the constant 0 is kept as a node: it is a run-time fact."""
        if x == self.zero and y != self.zero:
            return self.zero
        if y == self.one:
            return x
        op_x, op_y = self.op[x], self.op[y]
        if op_y is _CONSTANT and self.value[y] != 0.0:
            if op_x is _CONSTANT:
                folded = self._fold(Op.DIVIDE, x, y)
                if folded is not None:
                    return folded
            if math.frexp(self.value[y])[0] in (0.5, -0.5):
                return self.multiply(self.constant(1.0 / self.value[y]), x)
        if op_x is _NEGATE:
            return self.negate(self.divide(self.a[x], y))
        if op_y is _NEGATE:
            return self.negate(self.divide(x, self.a[y]))
        return self._make_binary(Op.DIVIDE, x, y)

    def power(self, x: int, y: int) -> int:
        """x^y; small whole exponents become products, 1/2 a square root."""
        if self.op[y] is _CONSTANT:
            exponent = self.value[y]
            if self.op[x] is _CONSTANT:
                folded = self._fold(Op.POWER, x, y)
                if folded is not None:
                    return folded
            if exponent == 0.5:
                return self.unary(Op.SQRT, x)
            if exponent.is_integer() and abs(exponent) <= _LARGEST_UNROLLED_POWER:
                product = self._whole_power(x, abs(int(exponent)))
                return product if exponent >= 0 else self.divide(self.one, product)
        return self._make_binary(Op.POWER, x, y)

    def _whole_power(self, x: int, exponent: int) -> int:
        if exponent == 0:
            return self.one
        half = self._whole_power(x, exponent // 2)
        square = self.multiply(half, half)
        return self.multiply(square, x) if exponent % 2 else square

    def unary(self, op: Op, x: int) -> int:
        """Any function of one argument."""
        assert FIRST_UNARY <= op < FIRST_BINARY
        if op is _NEGATE:
            return self.negate(x)
        if self.op[x] is _CONSTANT:
            folded = self._fold(op, x)
            if folded is not None:
                return folded
        if self.op[x] is _NEGATE:
            if op in _ODD:
                return self.negate(self.unary(op, self.a[x]))
            if op in _EVEN:
                return self.unary(op, self.a[x])
        return self._make_unary(op, x)

    def binary(self, op: Op, x: int, y: int) -> int:
        """Any function of two arguments."""
        assert FIRST_BINARY <= op < FIRST_TERNARY
        own = _ARITHMETIC.get(op)
        if own is not None:
            return own(self, x, y)
        both = self.op[x] is _CONSTANT and self.op[y] is _CONSTANT
        folded = self._fold(op, x, y) if both else None
        return self._make_binary(op, x, y) if folded is None else folded

    def select(self, condition: int, value: int, otherwise: int) -> int:
        """`value` where `condition` is not 0, else `otherwise`."""
        if self.op[condition] is _CONSTANT:
            return value if self.value[condition] != 0.0 else otherwise
        if value == otherwise:
            return value
        table = self._index[Op.SELECT]
        key = (condition, value, otherwise)
        node = table.get(key)
        if node is None:
            groups = self.groups[condition] | self.groups[value] | self.groups[otherwise]
            node = table[key] = self._append(Op.SELECT, *key, key, groups)
        return node

    # ---- sums and products -------------------------------------------------------------------------------------------

    def sum(self, terms: Iterable[int]) -> int:
        total = self.zero
        for term in terms:
            total = self.add(total, term)
        return total

    def dot(self, left: Sequence[int], right: Sequence[int]) -> int:
        return self.sum(self.multiply(x, y) for x, y in zip(left, right, strict=True))

    # ---- reading -----------------------------------------------------------------------------------------------------

    def arguments(self, node: int) -> tuple[int, ...]:
        """Ids of the nodes that `node` is computed from."""
        return self.operands[node]

    def is_constant(self, node: int) -> bool:
        return self.op[node] is _CONSTANT

    def group(self, symbol: int) -> Group:
        return _GROUPS[self.a[symbol]]

    def depends(self, node: int, *groups: Group) -> bool:
        """True if a symbol of one of `groups` occurs in the expression of `node`."""
        return any(self.groups[node] >> group & 1 for group in groups)

    def live(self, roots: Iterable[int], given: Collection[int] = ()) -> list[int]:
        """Ids of all nodes that `roots` are computed from, themselves included, ascending; what only `given` nodes are
        computed from is left out."""
        roots = set(roots)  # matrices repeat the zero
        operands = self.operands
        mark = bytearray(max(roots, default=-1) + 1)
        for root in roots:
            mark[root] = 1
        found = []
        node = mark.rfind(1)
        while node >= 0:
            found.append(node)
            if not given or node not in given:
                for argument in operands[node]:
                    mark[argument] = 1
            node -= 1
            if not mark[node]:  # mostly the one before is
                node = mark.rfind(1, 0, node + 1)
        found.reverse()
        return found

    def rebuild(self, node: int, arguments: Sequence[int]) -> int:
        """The operation of `node` on other arguments, simplified anew."""
        op = self.op[node]
        if op < FIRST_UNARY:
            return node
        if op < FIRST_BINARY:
            return self.unary(op, arguments[0])
        if op < FIRST_TERNARY:
            return self.binary(op, arguments[0], arguments[1])
        return self.select(arguments[0], arguments[1], arguments[2])

    # ---- making ------------------------------------------------------------------------------------------------------

    def _fold(self, op: Op, *arguments: int) -> int | None:
        """The constant that `op` gives for these constants, where it is a number."""
        result = fold(op, *(self.value[x] for x in arguments))
        return None if result is None else self.constant(result)

    def _make_unary(self, op: Op, a: int) -> int:
        table = self._index[op]
        node = table.get(a)
        if node is None:
            node = table[a] = self._append(op, a, -1, -1, (a,), self.groups[a])
        return node

    def _make_binary(self, op: Op, a: int, b: int) -> int:
        table = self._index[op]
        key = (a, b)
        node = table.get(key)
        if node is None:
            groups = self.groups
            node = table[key] = len(groups)  # as `_append` does: most nodes are made here
            groups.append(groups[a] | groups[b])
            self.op.append(op)
            self.a.append(a)
            self.b.append(b)
            self.c.append(-1)
            self.operands.append(key)
        return node

    def _append(self, op: Op, a: int, b: int, c: int, operands: tuple[int, ...], groups: int) -> int:
        node = len(self.op)
        self.op.append(op)
        self.a.append(a)
        self.b.append(b)
        self.c.append(c)
        self.operands.append(operands)
        self.groups.append(groups)
        return node


_ARITHMETIC: dict[Op, Callable[[Graph, int, int], int]] = {
    Op.ADD: Graph.add,
    Op.SUBTRACT: Graph.subtract,
    Op.MULTIPLY: Graph.multiply,
    Op.DIVIDE: Graph.divide,
    Op.POWER: Graph.power,
}
