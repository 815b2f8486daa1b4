"""Loads that depend on the motion that they cause: on multipliers, reactions, accelerations.

Such a value has an entry in the vector of discretes, which the load reads and Newton's method finds. Terms of a
load that do not depend on them stand there as they are, so that their derivatives are exact: of
`-c*der(x) - mu*multiplier(n)` the second term is an entry, not the first.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import assert_never

from lagdsl.foundation.units import Dimension
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.events import Feedback
from lagdsl.language.flat.expression_text import flat_expression_text
from lagdsl.language.flat.quantity import Spans
from lagdsl.language.flat.traversal import postorder
from lagdsl.language.semantics.scope.values import component
from lagdsl.language.semantics.wellformed.effect import load_expressions

_AXES = "xyz"
_LONGEST = 80


def with_feedback(solved: Sequence[Dimension | None], flat: fm.FlatModel, dependence: Dependence) -> fm.FlatModel:
    """The model with entries in the loads that depend on the motion that they cause: `solved` has the dimensions of
    their values, and None for each other load."""
    if all(dimension is None for dimension in solved):
        return flat
    parts = _Parts(flat, dependence)
    pairs = zip(flat.loads, solved, strict=True)
    loads = tuple(load if dimension is None else parts.load(load, dimension) for load, dimension in pairs)
    events = replace(flat.events, feedbacks=(*flat.events.feedbacks, *parts.made.values()))
    return replace(flat, loads=loads, events=events)


class _Parts:
    """Puts entries for the parts of values that need the solved motion."""

    def __init__(self, flat: fm.FlatModel, dependence: Dependence) -> None:
        self.made: dict[str, Feedback] = {}
        self._taken = {each.name for each in flat.events.feedbacks}
        self._variables = {item.name for item in (*flat.coordinates, *flat.states)}
        self._dependence = dependence
        self._known: dict[int, tuple[fx.FlatExpression, bool]] = {}
        self._spans: Spans
        self._dimension: Dimension
        self._name: str

    def load(self, load: fm.Load, dimension: Dimension) -> fm.Load:
        """The load with entries in its value."""
        value = load_expressions(load)[0]
        text = " ".join((load.label or flat_expression_text(value)).split())
        self._name = f"load({text if len(text) <= _LONGEST else f'{text[: _LONGEST - 2]} …'})"
        self._spans, self._dimension = load.spans, dimension
        match load:
            case fm.PointForce():
                return replace(load, force=self._vector(value))
            case fm.FrameTorque():
                return replace(load, torque=self._vector(value))
            case fm.GeneralizedForce() | fm.RateForce():
                return replace(load, value=self._scalar(value))
            case _:
                assert_never(load)

    def _scalar(self, value: fx.FlatExpression, axis: str = "") -> fx.FlatExpression:
        known, solved = self._terms(value)
        if not solved:
            return value
        rest = _sum(solved)
        if isinstance(rest, fx.Conditional) and not self._is_solved(rest.condition):
            rest = fx.Conditional(rest.condition, self._scalar(rest.value, axis), self._scalar(rest.otherwise, axis))
        else:
            rest = self._entry(rest, axis)
        return fx.Binary("+", _sum(known), rest) if known else rest

    def _vector(self, value: fx.FlatExpression) -> fx.FlatExpression:
        known, solved = self._terms(value)
        if not solved:
            return value
        rest = _sum(solved)
        if isinstance(rest, fx.Conditional) and not self._is_solved(rest.condition):
            rest = fx.Conditional(rest.condition, self._vector(rest.value), self._vector(rest.otherwise))
        elif isinstance(rest, fx.Binary) and isinstance(rest.right, fx.FrameAxis):
            rest = fx.Binary("*", self._scalar(rest.left), rest.right)
        else:
            x, y, z = (self._scalar(_component(rest, k), f".{name}") for k, name in enumerate(_AXES))
            rest = fx.Vector(x, y, z)
        return fx.Binary("+", _sum(known), rest) if known else rest

    def _terms(self, value: fx.FlatExpression) -> tuple[list[_Term], list[_Term]]:
        """Terms of the sum that `value` is: those that are known with the state, and the others."""
        known: list[_Term] = []
        solved: list[_Term] = []
        stack: list[_Term] = [(1, value)]
        while stack:
            sign, each = stack.pop()
            if not self._is_solved(each):
                known.append((sign, each))
                continue
            if isinstance(each, fx.Binary) and each.operator in ("+", "-"):
                stack.append((sign if each.operator == "+" else -sign, each.right))
                stack.append((sign, each.left))
            elif isinstance(each, fx.Unary) and each.operator == "-":
                stack.append((-sign, each.operand))
            else:
                solved.append((sign, each))
        return known, solved

    def _entry(self, value: fx.FlatExpression, axis: str) -> fx.FlatExpression:
        """The entry for a value; the same value again has the same one."""
        base, count = f"{self._name}{axis}", 1
        name = base
        while name in self._taken or (name in self.made and self.made[name].value != value):
            count += 1
            name = f"{base} ({count})"
        if name not in self.made:
            self.made[name] = Feedback(spans=self._spans, name=name, value=value, dimension=self._dimension)
        return fx.Variable(name)

    def _is_solved(self, expression: fx.FlatExpression) -> bool:
        """True for what depends on multipliers, reactions, energies of the solved motion, or accelerations."""
        known = self._known
        if id(expression) not in known:
            orders = self._dependence.of(expression)
            accelerated = any(orders[name] > 1 for name in orders.differentiated() if name in self._variables)
            mechanical = any(isinstance(node, fx.Mechanical) for node in postorder(expression))
            known[id(expression)] = expression, accelerated or mechanical
        return known[id(expression)][1]


_Term = tuple[int, fx.FlatExpression]
"""A sign and what it stands before."""


def _component(vector: fx.FlatExpression, axis: int) -> fx.FlatExpression:
    """World component of a vector; zero where the text says so, as in `F*world.x`."""
    if isinstance(vector, fx.Unary):
        inner = _component(vector.operand, axis)
        return inner if inner == fx.ZERO else fx.Unary("-", inner)
    if isinstance(vector, fx.Binary) and vector.operator == "*":
        part = _component(vector.right, axis)
        return part if part == fx.ZERO else vector.left if part == fx.ONE else fx.Binary("*", vector.left, part)
    return component(vector, axis)


def _sum(terms: Sequence[_Term]) -> fx.FlatExpression:
    (sign, first), *others = terms
    total = first if sign > 0 else fx.Unary("-", first)
    for sign, each in others:
        total = fx.Binary("+" if sign > 0 else "-", total, each)
    return total
