"""What expressions of a flat model depend on: variables and the number of time derivatives they occur with."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import assert_never

from lagdsl.semantics import flat_expression as fx
from lagdsl.semantics import flat_model as fm

Orders = dict[str, int]
"""Variable -> highest number of time derivatives: {"theta": 1} for an expression of theta and der(theta)."""


def operands(expression: fx.FlatExpression) -> tuple[fx.FlatExpression, ...]:  # noqa: C901, PLR0912 a case per node
    """The direct subexpressions, in the order of the text."""
    match expression:
        case fx.Binary() | fx.Dot() | fx.Cross():
            return (expression.left, expression.right)
        case fx.Unary() | fx.Derivative():
            return (expression.operand,)
        case fx.Function():
            return expression.arguments
        case fx.Conditional():
            return (expression.condition, expression.value, expression.otherwise)
        case fx.Component() | fx.Norm():
            return (expression.vector,)
        case fx.Vector():
            return (expression.x, expression.y, expression.z)
        case fx.MaterialVelocity():
            return (expression.point,)
        case fx.ReactionAlong():
            return (expression.direction,)
        case fx.AngularMomentum():
            return (expression.about,)
        case fx.Number() | fx.Variable() | fx.PointReference() | fx.FrameOrigin() | fx.FrameAxis():
            return ()
        case fx.AngularVelocity() | fx.Multiplier() | fx.FrameReaction() | fx.SystemEnergy():
            return ()
        case fx.GeneralizedMomentum() | fx.LinearMomentum():
            return ()
        case _:
            assert_never(expression)


def step_expressions(step: fm.FrameStep, *, turning_only: bool = False) -> tuple[fx.FlatExpression, ...]:
    """The expressions in one step of a frame; with `turning_only` none for a step that only displaces."""
    match step:
        case fm.Rotate():
            return (step.angle,)
        case fm.RotateAbout():
            return (*step.axis, step.angle)
        case fm.RotateQuaternion():
            return step.e
        case fm.SetAxes():
            return (step.x, step.y, step.z)
        case fm.Move():
            return () if turning_only else step.offset
        case fm.Place():
            return () if turning_only else (step.position,)
        case _:
            assert_never(step)


@dataclass(frozen=True, slots=True)
class Dependence:
    """Answers for one flat model; named elements and shared nodes are looked at once."""

    flat: fm.FlatModel
    _named: dict[str, fm.Named] = field(init=False, repr=False)
    _by_name: dict[tuple[str, str], Orders] = field(init=False, repr=False, default_factory=dict)
    _by_node: dict[int, tuple[fx.FlatExpression, Orders]] = field(init=False, repr=False, default_factory=dict)

    def __post_init__(self) -> None:
        object.__setattr__(self, "_named", {item.name: item for item in self.flat.named})

    def of(self, expression: fx.FlatExpression) -> Orders:
        """Parameters count too, with order 0. What the mechanics provides (multipliers, energies) has none."""
        known = self._by_node.get(id(expression))
        if known is None:
            # The node is kept with its answer, so that its identity is not given to another one.
            known = self._by_node[id(expression)] = (expression, self._compute(expression))
        return known[1]

    def of_all(self, expressions: Iterable[fx.FlatExpression]) -> Orders:
        return _merged(self.of(expression) for expression in expressions)

    def of_frame(self, name: str, *, turning_only: bool = False) -> Orders:
        """Of position and orientation of a frame, or of its orientation only."""
        key = (name, "axes" if turning_only else "frame")
        if key not in self._by_name:
            frame = self._named.get(name)
            orders: Orders = {}
            if isinstance(frame, fm.Frame):
                steps = [step_expressions(step, turning_only=turning_only) for step in frame.steps]
                parent = self.of_frame(frame.parent, turning_only=turning_only)
                orders = _merged([parent, *(self.of_all(expressions) for expressions in steps)])
            self._by_name[key] = orders
        return self._by_name[key]

    def _compute(self, expression: fx.FlatExpression) -> Orders:
        match expression:
            case fx.Variable(name):
                return self._variable(name)
            case fx.Derivative(operand):
                return _raised(self.of(operand))
            case fx.PointReference(name):
                point = self._named.get(name)
                return self.of(point.position) if isinstance(point, fm.Point) else {}
            case fx.FrameOrigin(frame):
                return self.of_frame(frame)
            case fx.FrameAxis(frame):
                return self.of_frame(frame, turning_only=True)
            case fx.AngularVelocity(frame):
                return _raised(self.of_frame(frame, turning_only=True))
            case fx.MaterialVelocity(point_expression, frame):
                return _merged([self.of(point_expression), _raised(self.of_frame(frame))])
            case _:
                return self.of_all(operands(expression))

    def _variable(self, name: str) -> Orders:
        item = self._named.get(name)
        return self.of(item.value) if isinstance(item, fm.Definition) else {name: 0}


def _raised(orders: Orders) -> Orders:
    return {name: order + 1 for name, order in orders.items()}


def _merged(parts: Iterable[Mapping[str, int]]) -> Orders:
    merged: Orders = {}
    for part in parts:
        for name, order in part.items():
            merged[name] = max(order, merged.get(name, 0))
    return merged


def walk(expression: fx.FlatExpression) -> Iterator[fx.FlatExpression]:
    """The expression and all below it, every shared node once."""
    seen: set[int] = set()
    stack = [expression]
    while stack:
        node = stack.pop()
        if id(node) not in seen:
            seen.add(id(node))
            yield node
            stack.extend(reversed(operands(node)))
