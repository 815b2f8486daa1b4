"""The functions of a program as plain Python, with every corner frozen on one branch.

A corner is a node whose formula changes: abs, min, a comparison, floor. In a mode each of them stays on one branch, so
that what is integrated is smooth; `valid` tells how far each still is from its border (negative beyond it).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lagdsl.algebra.graph.operation import ELEMENTARY_NAMES, Group, Op
from lagdsl.derivation.program.program import Program

Floats = NDArray[np.float64]

ARGUMENTS = "t, q, qd, z, u, w, p, qdd, lam"
_NAMES = {
    Group.Q: "q",
    Group.QD: "qd",
    Group.Z: "z",
    Group.U: "u",
    Group.W: "w",
    Group.P: "p",
    Group.QDD: "qdd",
    Group.LAMBDA: "lam",
}
_MOVING = (Group.TIME, Group.Q, Group.QD, Group.Z, Group.U, Group.QDD, Group.LAMBDA)
_SIMPLE = {
    Op.NEGATE: "-{0}",
    Op.ADD: "{0} + {1}",
    Op.SUBTRACT: "{0} - {1}",
    Op.MULTIPLY: "{0}*{1}",
    Op.DIVIDE: "_divide({0}, {1})",
    Op.POWER: "_power({0}, {1})",
    Op.NOT: "float({0} == 0)",
    Op.EQUAL: "float({0} == {1})",
    Op.AND: "float({0} != 0 and {1} != 0)",
    Op.OR: "float({0} != 0 or {1} != 0)",
    Op.SELECT: "({1} if {0} != 0 else {2})",
}
# Of a corner: its branch as it stands, its value on the branch `b`, and what stays positive on it.
_CORNERS: dict[Op, tuple[str, str, tuple[str, ...]]] = {
    Op.ABS: ("1.0 if {0} >= 0 else -1.0", "{b}*{0}", ("{b}*{0}",)),
    Op.SIGN: ("1.0 if {0} > 0 else -1.0", "{b}", ("{b}*{0}",)),
    Op.MIN: ("1.0 if {0} <= {1} else -1.0", "({0} if {b} > 0 else {1})", ("{b}*({1} - {0})",)),
    Op.MAX: ("1.0 if {0} >= {1} else -1.0", "({0} if {b} > 0 else {1})", ("{b}*({0} - {1})",)),
    Op.LESS: ("1.0 if {0} < {1} else -1.0", "float({b} > 0)", ("{b}*({1} - {0})",)),
    Op.LESS_EQUAL: ("1.0 if {0} <= {1} else -1.0", "float({b} > 0)", ("{b}*({1} - {0})",)),
    Op.FLOOR: ("float(math.floor({0}))", "{b}", ("{0} - {b}", "{b} + 1 - {0}")),
    Op.CEIL: ("float(math.ceil({0}))", "{b}", ("{b} - {0}", "{0} - {b} + 1")),
    Op.MOD: ("float(math.floor({0}/{1}))", "({0} - {b}*{1})", ("{0}/{1} - {b}", "{b} + 1 - {0}/{1}")),
}


def _divide(a: float, b: float) -> float:
    return a / b if b else math.copysign(math.inf, a) * math.copysign(1.0, b) if a else math.nan


def _power(a: float, b: float) -> float:
    try:
        return float(a**b)
    except (ZeroDivisionError, OverflowError, TypeError):
        return math.nan


@dataclass(frozen=True)
class Point:
    """Arguments of all functions."""

    t: float
    q: Floats
    qd: Floats
    z: Floats
    u: Floats
    w: Floats
    p: Floats
    qdd: Floats
    lam: Floats


class Functions:
    """`call(name, point, branches)` is a dictionary of the results of one function, as arrays of their shapes."""

    def __init__(self, program: Program, frozen: Sequence[str]) -> None:
        self._program, self._graph = program, program.graph
        self.names = [name for name in frozen if program.has(name)]
        roots = [n for name in self.names for block in program.function(name).results for n in block.elements]
        graph = self._graph
        self.corners = [
            node for node in graph.live(roots) if graph.op[node] in _CORNERS and graph.depends(node, *_MOVING)
        ]
        self._place = {node: place for place, node in enumerate(self.corners)}
        self._compiled: dict[tuple[str, bool], Any] = {}
        self._standing = self._corner_function(natural=True)
        self._valid = self._corner_function(natural=False)

    def call(self, name: str, at: Point, branches: Sequence[float] | None) -> dict[str, Floats]:
        """With corners as they stand where `branches` is None."""
        key = (name, branches is None)
        function = self._program.function(name)
        if key not in self._compiled:
            roots = [node for block in function.results for node in block.elements]
            self._compiled[key] = self._function(roots, key[1])
        values = iter(self._compiled[key](*_arguments(at), branches))
        return {
            block.name: np.array([next(values) for _ in block.elements]).reshape(block.shape)
            for block in function.results
        }

    def standing(self, at: Point) -> list[float]:
        """The branch of every corner."""
        return self._standing(*_arguments(at), None)  # type: ignore[no-any-return]

    def valid(self, at: Point, branches: Sequence[float]) -> list[float]:
        return self._valid(*_arguments(at), branches)  # type: ignore[no-any-return]

    def asks_for_accelerations(self, names: Sequence[str]) -> bool:
        """True if one of the functions or a corner depends on accelerations or multipliers."""
        named = [self._program.function(name) for name in names if self._program.has(name)]
        roots = [node for function in named for block in function.results for node in block.elements]
        return any(self._graph.depends(node, Group.QDD, Group.LAMBDA) for node in (*roots, *self.corners))

    # ---- writing -----------------------------------------------------------------------------------------------------

    def _function(self, roots: Sequence[int], natural: bool) -> Any:
        lines = self._lines(roots, natural)
        return _compiled(lines, [f"v{root}" for root in roots])

    def _corner_function(self, natural: bool) -> Any:
        arguments = [node for corner in self.corners for node in self._graph.arguments(corner)]
        lines, results = self._lines(arguments, natural), []
        for corner in self.corners:
            standing, _, valid = _CORNERS[Op(self._graph.op[corner])]
            names = [f"v{node}" for node in self._graph.arguments(corner)]
            forms = (standing,) if natural else valid
            results += [form.format(*names, b=f"b[{self._place[corner]}]") for form in forms]
        return _compiled(lines, results)

    def _lines(self, roots: Sequence[int], natural: bool) -> list[str]:
        return [f"v{node} = {self._expression(node, natural)}" for node in self._graph.live(roots)]

    def _expression(self, node: int, natural: bool) -> str:
        graph = self._graph
        op = Op(graph.op[node])
        names = [f"v{x}" for x in graph.arguments(node)]
        if op is Op.CONSTANT:
            return (
                f"float({graph.value[node]!r})" if math.isfinite(graph.value[node]) else f"float('{graph.value[node]}')"
            )
        if op is Op.SYMBOL:
            group = graph.group(node)
            return "t" if group is Group.TIME else f"{_NAMES[group]}[{graph.b[node]}]"
        if op in _SIMPLE:
            return _SIMPLE[op].format(*names)
        if op in _CORNERS:
            if op is Op.SIGN and (natural or node not in self._place):
                return "float(({0} > 0) - ({0} < 0))".format(*names)
            standing, value, _ = _CORNERS[op]
            frozen = not natural and node in self._place
            return value.format(*names, b=f"b[{self._place[node]}]" if frozen else f"({standing.format(*names)})")
        return f"_safe(math.{ELEMENTARY_NAMES[op]}, {', '.join(names)})"


def _safe(function: Any, *values: float) -> float:
    try:
        return float(function(*values))
    except (ValueError, OverflowError):
        return math.nan


def _arguments(at: Point) -> tuple[Any, ...]:
    lists = (getattr(at, name).tolist() for name in ("q", "qd", "z", "u", "w", "p", "qdd", "lam"))
    return (float(at.t), *lists)


def _compiled(lines: Sequence[str], results: Sequence[str]) -> Any:
    body = "".join(f"  {line}\n" for line in lines)
    text = f"def function({ARGUMENTS}, b):\n{body}  return [{', '.join(results)}]\n"
    scope: dict[str, Any] = {"math": math, "_divide": _divide, "_power": _power, "_safe": _safe}
    exec(compile(text, "<oracle>", "exec"), scope)
    return scope["function"]
