"""Notation of numbers, arrays and functions: for one state, or for several in the lanes of vectors."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from lagdsl.algebra.graph.operation import ARGUMENT_NAMES, DIRECTION_OF, ELEMENTARY_NAMES, Group, Op
from lagdsl.engines.backends.c.literal import number
from lagdsl.foundation.record import record

_OWN = {
    Op.SIGN: "sign", Op.NOT: "not", Op.MOD: "mod", Op.MIN: "min", Op.MAX: "max", Op.LESS: "less",
    Op.LESS_EQUAL: "less_equal", Op.EQUAL: "equal", Op.AND: "and", Op.OR: "or", Op.SELECT: "select",
}  # fmt: skip
_LIBRARY = {**ELEMENTARY_NAMES, Op.ABS: "fabs", Op.POWER: "pow"}


@record()
class Place:
    """An entry of an array, `q[3]`; the time is an array of one entry."""

    array: str
    index: int


@record()
class Dialect:
    """`real` is the type of a value, `memory` that of its place; arrays of `shared` hold single numbers all the same.

    `fused` is the name of x*y + z rounded once.
    `suffix` ends the names of functions that there is one of per dialect; `splat` makes a value of a single number.
    `primal` is where in the workspace the values start that directions share.
    """

    real: str
    memory: str
    suffix: str
    splat: str
    functions: Mapping[Op, str]
    fused: str
    shared: frozenset[str] = frozenset()
    primal: int = 0

    def literal(self, value: float) -> str:
        return self.splatted(number(value))

    def splatted(self, text: str) -> str:
        """A value of the single number that the expression `text` is."""
        return f"{self.splat}({text})" if self.splat else text

    def read(self, array: str, index: str) -> str:
        """The value of an entry."""
        return self.value(array, f"{array}[{index}]")

    def value(self, array: str, entry: str) -> str:
        """The value of what the expression `entry` says is an entry of `array`."""
        return self.splatted(entry) if array in self.shared else entry

    def kind(self, array: str) -> str:
        """The type of an entry of an array."""
        return "double" if not self.splat or array in self.shared else self.memory

    def declaration(self, array: str) -> str | None:
        """The line that makes an array of arguments known; None for results and scratch, which are parameters."""
        kind = self.kind(array)
        cast = "" if kind == "double" else f"(const {kind} *)"
        if array == ARGUMENT_NAMES[Group.TIME]:
            return f"const {kind} *const t = " + (f"{cast}at->times;" if cast else "&at->t;")
        if array == PREPARED:
            return f"const {kind} *const {PREPARED} = {cast}at->workspace;"
        if array == PRIMAL:
            return f"const double *const {PRIMAL} = at->workspace + {self.primal};"
        if array in _ARGUMENTS:
            return f"const {kind} *const {array} = {cast}at->{array};"
        return None


# Names of the arrays that are no argument: what prepare() wrote, what all directions share, what is passed on.
PREPARED = "c"
PRIMAL = "m"
SCRATCH = "s"
_ARGUMENTS = frozenset(ARGUMENT_NAMES.values())

SINGLE = Dialect(
    real="double",
    memory="double",
    suffix="",
    splat="",
    functions={**_LIBRARY, **{op: f"lag_{name}" for op, name in _OWN.items()}},
    fused="lag_fused",
)
LANES = Dialect(
    real="lag_lanes",
    memory="lag_lanes_memory",
    suffix="_lanes",
    splat="lag_lanes_of",
    functions={op: f"lag_lanes_{name}" for op, name in {**_LIBRARY, **_OWN, Op.ABS: "abs"}.items()},
    fused="lag_lanes_fused",
)


def directions(primal: int) -> Dialect:
    """Lanes that differ in their directions only; values shared by all of them start at `primal` in the workspace."""
    along = {ARGUMENT_NAMES[group] for group in DIRECTION_OF.values()}
    return replace(LANES, shared=frozenset({*_ARGUMENTS - along, PREPARED, PRIMAL}), primal=primal)
