"""What expressions of a flat model depend on: variables and the number of time derivatives they occur with."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

from lagdsl.flat import expression as fx
from lagdsl.flat import model as fm
from lagdsl.flat.traversal import operands, postorder, step_expressions

Orders = dict[str, int]
"""Variable -> highest number of time derivatives: {"theta": 1} for an expression of theta and der(theta)."""


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
        known = self._by_node
        for node in postorder(expression, known):
            # The node is kept with its answer, so that its identity is not given to another one.
            known[id(node)] = (node, self._compute(node))
        return known[id(expression)][1]

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
