"""Flat expressions to nodes: scalars to one, geometric vectors to three.

Definitions, points and frames are lowered when first used, in an explicit stack instead of recursion, so that neither
long sums nor long chains of frames meet a limit. `der` of anything is the total derivative of its nodes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TypeAlias, assert_never, cast

from lagdsl.flat import expression as flat
from lagdsl.flat.expression import FlatExpression
from lagdsl.flat.model import Definition, FlatModel, Frame, Point
from lagdsl.flat.quantity import Spans
from lagdsl.flat.traversal import operands, step_expressions
from lagdsl.graph.graph import Graph
from lagdsl.graph.operation import Group, Op
from lagdsl.graph.taylor import TimeDerivative
from lagdsl.mechanics.kinematics import vectors
from lagdsl.mechanics.kinematics.body_frame_vectors import OwnVectors
from lagdsl.mechanics.kinematics.poses import Poses, Release
from lagdsl.mechanics.kinematics.vectors import Vector
from lagdsl.mechanics.lowering.acceleration import needs_accelerations
from lagdsl.mechanics.lowering.operations import binary, function
from lagdsl.mechanics.lowering.symbols import Symbols, input_rates

Value: TypeAlias = "int | Vector"
Provided: TypeAlias = (
    "flat.Multiplier | flat.FrameReaction | flat.ReactionAlong | flat.SystemEnergy | flat.GeneralizedMomentum "
    "| flat.LinearMomentum | flat.AngularMomentum"
)


class Lowering:
    """Values of expressions of one model on one graph, memoised by identity.

    With `release` points and frames are displaced by symbols that stand for zero, see `reactions`. `provide` computes
    quantities of the mechanics (energies, momenta, reactions); it is set once the equations are formed. `place` is the
    span of the item that is being lowered, for diagnostics.
    """

    def __init__(self, graph: Graph, model: FlatModel, symbols: Symbols, release: Release | None = None) -> None:
        self.graph = graph
        self.model = model
        self.symbols = symbols
        self.provide: Callable[[Provided], Value] | None = None
        self.place: Spans = ()
        self.rate = TimeDerivative(graph, self._rate_of_symbol)
        self.bias_rate = TimeDerivative(graph, self._rate_of_symbol, bias=True)
        self._release = release or Release()
        self._input_rate = input_rates(graph, model)
        self._values: dict[int, Value] = {}
        self._kept: list[FlatExpression] = []
        self._definitions = {item.name: item for item in model.named if isinstance(item, Definition)}
        self._points = {item.name: item for item in model.named if isinstance(item, Point)}
        self._frames = {item.name: item for item in model.named if isinstance(item, Frame)}
        self._origins = {name: flat.FrameOrigin(name) for name in self._frames}
        self._poses = Poses(graph, self.rate, self._release)
        self.own = OwnVectors(graph, self._poses, self.rate, self._points, lambda x: self._values[id(x)])

    # ---- what others ask for -----------------------------------------------------------------------------------------

    def scalar(self, expression: FlatExpression) -> int:
        value = self.value(expression)
        assert isinstance(value, int), expression
        return value

    def vector(self, expression: FlatExpression) -> Vector:
        value = self.value(expression)
        assert isinstance(value, tuple), expression
        return value

    def value(self, expression: FlatExpression) -> Value:
        """The node or the three nodes of an expression of this model."""
        values = self._values
        stack = [expression]
        while stack:
            current = stack[-1]
            if id(current) in values:
                stack.pop()
                continue
            missing = [x for x in self._needed(current) if id(x) not in values]
            if missing:
                stack += reversed(missing)
                continue
            self._kept.append(current)
            values[id(current)] = self._combine(current)
            stack.pop()
        return values[id(expression)]

    def replace(self, nodes: Mapping[int, int]) -> None:
        """Nodes to be others in all values so far, and so in what is made of them later."""
        if not nodes:
            return
        for key, value in self._values.items():
            if isinstance(value, int):
                self._values[key] = nodes.get(value, value)
            else:
                x, y, z = (nodes.get(component, component) for component in value)
                self._values[key] = (x, y, z)

    def poses(self, frame: str) -> Poses:
        """Poses and angular velocities, with that of `frame` made."""
        if frame in self._origins:
            self.value(self._origins[frame])
        return self._poses

    def velocity(self, position: Vector) -> Vector:
        of = self.rate.of
        return (of(position[0]), of(position[1]), of(position[2]))

    def own_velocity(self, point: FlatExpression) -> Vector | None:
        """The velocity of a point along the axes of the frame that carries it; None where none does."""
        return self.own.velocity(point) if self._release == Release() else None

    # ---- order of lowering -------------------------------------------------------------------------------------------

    def _needed(self, expression: FlatExpression) -> list[FlatExpression]:
        """Expressions to lower before `expression`: operands, and the binding of a name."""
        match expression:
            case flat.Variable(name):
                return [self._definitions[name].value] if name in self._definitions else []
            case flat.PointReference(name):
                return [self._points[name].position]
            case flat.FrameOrigin(frame):
                return self._needed_for_frame(frame)
            case flat.FrameAxis(frame=frame) | flat.AngularVelocity(frame) | flat.FrameReaction(frame=frame):
                return [self._origins[frame]] if frame in self._origins else []
            case flat.MaterialVelocity(point, frame):
                return [point, *([self._origins[frame]] if frame in self._origins else [])]
            case flat.Number() | flat.Previous() | flat.Derivative() | flat.Operation() | flat.Mechanical():
                return list(operands(expression))
            case _:
                assert_never(expression)

    def _needed_for_frame(self, name: str) -> list[FlatExpression]:
        if name in self._poses or name not in self._frames:
            return []
        frame = self._frames[name]
        parent: list[FlatExpression] = [self._origins[frame.parent]] if frame.parent in self._origins else []
        if frame.image is not None and frame.image.within in self._origins:
            parent.append(self._origins[frame.image.within])
        return parent + [x for step in frame.steps for x in step_expressions(step)]

    # ---- values ------------------------------------------------------------------------------------------------------

    def _combine(self, expression: FlatExpression) -> Value:
        match expression:
            case (
                flat.Number()
                | flat.Variable()
                | flat.Previous()
                | flat.Function()
                | flat.Derivative()
                | flat.Component()
            ):
                return self._simple(expression)
            case flat.Unary() | flat.Binary() | flat.Conditional():
                return self._operator(expression)
            case flat.Dot() | flat.Norm() | flat.Vector() | flat.Cross():
                return self._product(expression)
            case flat.PointReference() | flat.OfFrame():
                return self._geometry(expression)
            case flat.Mechanical():
                assert self.provide is not None, expression
                return self.provide(expression)
            case _:
                assert_never(expression)

    def _known(self, expression: FlatExpression) -> Value:
        return self._values[id(expression)]

    def _node(self, expression: FlatExpression) -> int:
        return cast(int, self._values[id(expression)])

    def _triple(self, expression: FlatExpression) -> Vector:
        return cast(Vector, self._values[id(expression)])

    def _simple(
        self,
        expression: flat.Number | flat.Variable | flat.Previous | flat.Function | flat.Derivative | flat.Component,
    ) -> Value:
        match expression:
            case flat.Number(number):
                return self.graph.constant(number)
            case flat.Variable(name):
                definition = self._definitions.get(name)
                return self.symbols.by_name[name] if definition is None else self._known(definition.value)
            case flat.Previous(name):
                return self.symbols.previous[name]
            case flat.Function(name, arguments):
                return function(self.graph, name, [self._node(x) for x in arguments])
            case flat.Derivative(operand):
                value = self._known(operand)
                return self.velocity(value) if isinstance(value, tuple) else self.rate.of(value)
            case flat.Component(vector, axis):
                return self._triple(vector)[axis]
        assert_never(expression)

    def _operator(self, expression: flat.Unary | flat.Binary | flat.Conditional) -> Value:
        graph = self.graph
        match expression:
            case flat.Unary("-", operand):
                value = self._known(operand)
                return vectors.negate(graph, value) if isinstance(value, tuple) else graph.negate(value)
            case flat.Unary(_, operand):
                return graph.unary(Op.NOT, self._node(operand))
            case flat.Binary():
                return self._binary(expression)
            case flat.Conditional(condition, value_, otherwise):
                test, first, second = self._node(condition), self._known(value_), self._known(otherwise)
                if isinstance(first, tuple):
                    x, y, z = (graph.select(test, a, b) for a, b in zip(first, cast(Vector, second), strict=True))
                    return (x, y, z)
                return graph.select(test, first, cast(int, second))
        assert_never(expression)

    def _binary(self, expression: flat.Binary) -> Value:
        graph, operator = self.graph, expression.operator
        left, right = self._known(expression.left), self._known(expression.right)
        if isinstance(left, int) and isinstance(right, int):
            return binary(graph, operator, left, right)
        if isinstance(left, int):
            assert operator == "*"
            return vectors.scale(graph, left, cast(Vector, right))
        if isinstance(right, int):
            assert operator == "/"
            return vectors.divide(graph, left, right)
        assert operator in ("+", "-")
        return vectors.add(graph, left, right) if operator == "+" else vectors.subtract(graph, left, right)

    def _product(self, expression: flat.Dot | flat.Norm | flat.Vector | flat.Cross) -> Value:
        match expression:
            case flat.Vector(x, y, z):
                return (self._node(x), self._node(y), self._node(z))
            case flat.Dot(left, right):
                return self._dot(left, right)
            case flat.Cross(left, right):
                return vectors.cross(self.graph, self._triple(left), self._triple(right))
            case flat.Norm(vector):
                return self.graph.unary(Op.SQRT, self._dot(vector, vector))
        assert_never(expression)

    def _dot(self, left: FlatExpression, right: FlatExpression) -> int:
        if self._release == Release():
            return self.own.dot(left, right)
        return self.graph.dot(self._triple(left), self._triple(right))

    def _geometry(
        self,
        expression: flat.PointReference
        | flat.FrameOrigin
        | flat.FrameAxis
        | flat.AngularVelocity
        | flat.MaterialVelocity,
    ) -> Vector:
        match expression:
            case flat.PointReference(name):
                return self._release.move_point(self.graph, name, self._triple(self._points[name].position))
            case flat.FrameOrigin(frame):
                if frame not in self._poses:
                    self._poses.make(self._frames[frame], self._node, self._triple)
                return self._poses[frame].origin
            case flat.FrameAxis(frame, axis):
                return self._poses[frame].axes[axis]
            case flat.AngularVelocity(frame):
                return self._poses.world_velocity(frame)
            case flat.MaterialVelocity(point, frame):
                origin = self._poses[frame].origin
                arm = vectors.subtract(self.graph, self._triple(point), origin)
                turning = vectors.cross(self.graph, self._poses.world_velocity(frame), arm)
                return vectors.add(self.graph, self.velocity(origin), turning)
        assert_never(expression)

    # ---- what symbols do in time -------------------------------------------------------------------------------------

    def _rate_of_symbol(self, symbol: int) -> int:
        """States by their equations, inputs by the inputs that are their derivatives; accelerations have none here."""
        index = self.graph.b[symbol]
        group = self.graph.group(symbol)
        if group is Group.Z:
            return self.scalar(self.model.states[index].derivative)
        if group is Group.U:
            return self._input_rate(index)
        assert group in (Group.QDD, Group.LAMBDA), group
        raise needs_accelerations(self.place, "this expression")
