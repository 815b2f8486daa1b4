"""Flat expressions to nodes: scalars to one, geometric vectors to three.

Definitions, points and frames are lowered when first used, in an explicit stack instead of recursion, so that neither
long sums nor long chains of frames meet a limit. `der` of anything is the total derivative of its nodes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias, assert_never, cast

from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.algebra.graph.taylor import TimeDerivative
from lagdsl.derivation.mechanics.kinematics import vectors
from lagdsl.derivation.mechanics.kinematics.body_frame_vectors import OwnVectors
from lagdsl.derivation.mechanics.kinematics.poses import Poses, Release
from lagdsl.derivation.mechanics.kinematics.vectors import Vector
from lagdsl.derivation.mechanics.lowering.acceleration import as_coordinate, needs_accelerations
from lagdsl.derivation.mechanics.lowering.operations import binary, function
from lagdsl.derivation.mechanics.lowering.symbols import Symbols, delay_rates
from lagdsl.derivation.mechanics.lowering.values import Value, Values
from lagdsl.foundation.record import record
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.model import Definition, FlatModel, Frame, Point, State
from lagdsl.language.flat.quantity import Spans
from lagdsl.language.flat.traversal import operands, step_expressions

Provided: TypeAlias = (
    "flat.Multiplier | flat.FrameReaction | flat.ReactionAlong | flat.SystemEnergy | flat.GeneralizedMomentum "
    "| flat.ForceBalance | flat.LinearMomentum | flat.AngularMomentum | flat.AdmissibleMotion | flat.RequiredForce"
)


@record()
class _Items:
    """The items of a model that expressions name."""

    states: tuple[State, ...]
    definitions: dict[str, Definition]
    points: dict[str, Point]
    frames: dict[str, Frame]
    origins: dict[str, flat.FrameOrigin]


def _items(model: FlatModel) -> _Items:
    frames = {item.name: item for item in model.named if isinstance(item, Frame)}
    return _Items(
        model.states,
        {item.name: item for item in model.named if isinstance(item, Definition)},
        {item.name: item for item in model.named if isinstance(item, Point)},
        frames,
        {name: flat.FrameOrigin(name) for name in frames},
    )


class Lowering:
    """Values of expressions of one model on one graph, memoised by identity.

    With `release` points and frames are displaced by symbols that stand for zero, see `reactions`. `provide` computes
    quantities of the mechanics from the nodes of their operands: forces that motions require at all times; energies,
    momenta, reactions once the equations are formed. `place` is the span of the item that is being lowered, for
    diagnostics.
    """

    def __init__(self, graph: Graph, model: FlatModel, symbols: Symbols, release: Release | None = None) -> None:
        self.graph = graph
        self.symbols = symbols
        self.provide: Callable[[Provided, Sequence[int]], Value] | None = None
        self.place: Spans = ()
        delayed = delay_rates(symbols, model)
        self.rate = TimeDerivative(graph, self._rate_of_symbol, delayed=delayed)
        self.bias_rate = TimeDerivative(graph, self._rate_of_symbol, bias=True, delayed=delayed)
        self.values = Values()
        self._items = _items(model)
        self._poses = Poses(graph, self.rate, release or Release())
        self.own = OwnVectors(graph, self._poses, self.rate, self._items.points, self.values.__getitem__)

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
        values, known = self.values, self.values.by_identity
        stack = [expression]
        while stack:
            current = stack[-1]
            if id(current) in known:
                stack.pop()
                continue
            before = len(stack)
            needed = (current.left, current.right) if isinstance(current, flat.Binary) else self._needed(current)
            for x in reversed(needed):
                if id(x) not in known:
                    stack.append(x)
            if len(stack) == before:
                values[current] = self._combine(current)
                stack.pop()
        return known[id(expression)]

    def poses(self, frame: str) -> Poses:
        """Poses and angular velocities, with that of `frame` made."""
        if frame in self._items.origins:
            self.value(self._items.origins[frame])
        return self._poses

    def with_held_states(self, model: FlatModel) -> Lowering:
        """The same for values in which rates of states are symbols."""
        held = _HeldStates(self.graph, model, self.symbols, self._poses.release)
        held.provide = self.provide
        return held

    def velocity(self, position: Vector) -> Vector:
        of = self.rate.of
        return (of(position[0]), of(position[1]), of(position[2]))

    def own_velocity(self, point: FlatExpression) -> Vector | None:
        """The velocity of a point along the axes of the frame that carries it; None where none does."""
        return self.own.velocity(point) if self._poses.release == Release() else None

    # ---- order of lowering -------------------------------------------------------------------------------------------

    def _needed(self, expression: FlatExpression) -> Sequence[FlatExpression]:
        """Expressions to lower before `expression`: operands, and the binding of a name."""
        match expression:
            case flat.Operation():
                return operands(expression)
            case flat.Variable(name):
                return [self._items.definitions[name].value] if name in self._items.definitions else ()
            case flat.PointReference(name):
                return [self._items.points[name].position]
            case flat.FrameOrigin(frame):
                return self._needed_for_frame(frame)
            case flat.FrameAxis(frame=frame) | flat.AngularVelocity(frame) | flat.FrameReaction(frame=frame):
                return [self._items.origins[frame]] if frame in self._items.origins else []
            case flat.MaterialVelocity(point, frame):
                return [point, *([self._items.origins[frame]] if frame in self._items.origins else [])]
            case flat.RequiredForce(motion):
                return operands(motion)
            case flat.Number() | flat.Previous() | flat.Derivative() | flat.Mechanical():
                return operands(expression)
            case flat.Motion():
                raise AssertionError(expression)
            case _:
                assert_never(expression)

    def _needed_for_frame(self, name: str) -> list[FlatExpression]:
        frame, origins = self._items.frames.get(name), self._items.origins
        if name in self._poses or frame is None:
            return []
        seen_from = (frame.parent, frame.image.within if frame.image is not None else "world")
        before: list[FlatExpression] = [origins[other] for other in seen_from if other in origins]
        return before + [x for step in frame.steps for x in step_expressions(step)]

    # ---- values ------------------------------------------------------------------------------------------------------

    def _combine(self, expression: FlatExpression) -> Value:
        match expression:
            case flat.Binary():
                return self._binary(expression)
            case (
                flat.Number()
                | flat.Variable()
                | flat.Previous()
                | flat.Function()
                | flat.Derivative()
                | flat.Component()
            ):
                return self._simple(expression)
            case flat.Unary() | flat.Conditional():
                return self._operator(expression)
            case flat.Dot() | flat.Norm() | flat.Vector() | flat.Cross():
                return self._product(expression)
            case flat.PointReference() | flat.OfFrame():
                return self._geometry(expression)
            case flat.Mechanical():
                assert self.provide is not None, expression
                return self.provide(expression, ())
            case flat.RequiredForce(motion):
                assert self.provide is not None, expression
                return self.provide(expression, [self.values.node(x) for x in operands(motion)])
            case flat.Motion():
                raise AssertionError(expression)
            case _:
                assert_never(expression)

    def _simple(
        self,
        expression: flat.Number | flat.Variable | flat.Previous | flat.Function | flat.Derivative | flat.Component,
    ) -> Value:
        match expression:
            case flat.Number(number):
                return self.graph.constant(number)
            case flat.Variable(name):
                definition = self._items.definitions.get(name)
                return self.symbols.by_name[name] if definition is None else self.values[definition.value]
            case flat.Previous(name):
                return self.symbols.previous[name]
            case flat.Function(name, arguments):
                return function(self.graph, name, [self.values.node(x) for x in arguments])
            case flat.Derivative(operand):
                value = self.values[operand]
                return self.velocity(value) if isinstance(value, tuple) else self.rate.of(value)
            case flat.Component(vector, axis):
                return self.values.triple(vector)[axis]
        assert_never(expression)

    def _operator(self, expression: flat.Unary | flat.Conditional) -> Value:
        graph = self.graph
        match expression:
            case flat.Unary("-", operand):
                value = self.values[operand]
                return vectors.negate(graph, value) if isinstance(value, tuple) else graph.negate(value)
            case flat.Unary(_, operand):
                return graph.unary(Op.NOT, self.values.node(operand))
            case flat.Conditional(condition, value_, otherwise):
                test, first, second = self.values.node(condition), self.values[value_], self.values[otherwise]
                if isinstance(first, tuple):
                    x, y, z = (graph.select(test, a, b) for a, b in zip(first, cast(Vector, second), strict=True))
                    return (x, y, z)
                return graph.select(test, first, cast(int, second))
        assert_never(expression)

    def _binary(self, expression: flat.Binary) -> Value:
        graph, operator, known = self.graph, expression.operator, self.values.by_identity
        left, right = known[id(expression.left)], known[id(expression.right)]
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
                return (self.values.node(x), self.values.node(y), self.values.node(z))
            case flat.Dot(left, right):
                return self._dot(left, right)
            case flat.Cross(left, right):
                return vectors.cross(self.graph, self.values.triple(left), self.values.triple(right))
            case flat.Norm(vector):
                return self.graph.unary(Op.SQRT, self._dot(vector, vector))
        assert_never(expression)

    def _dot(self, left: FlatExpression, right: FlatExpression) -> int:
        if self._poses.release == Release():
            return self.own.dot(left, right)
        return self.graph.dot(self.values.triple(left), self.values.triple(right))

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
                return self._poses.release.move_point(
                    self.graph, name, self.values.triple(self._items.points[name].position)
                )
            case flat.FrameOrigin(frame):
                if frame not in self._poses:
                    self._poses.make(self._items.frames[frame], self.values.node, self.values.triple)
                return self._poses[frame].origin
            case flat.FrameAxis(frame, axis):
                return self._poses[frame].axes[axis]
            case flat.AngularVelocity(frame):
                return self._poses.world_velocity(frame)
            case flat.MaterialVelocity(point, frame):
                origin = self._poses[frame].origin
                arm = vectors.subtract(self.graph, self.values.triple(point), origin)
                turning = vectors.cross(self.graph, self._poses.world_velocity(frame), arm)
                return vectors.add(self.graph, self.velocity(origin), turning)
        assert_never(expression)

    # ---- what symbols do in time -------------------------------------------------------------------------------------

    def _rate_of_symbol(self, symbol: int) -> int:
        """States by their equations, inputs by the inputs that are their derivatives; accelerations have none here."""
        index = self.graph.b[symbol]
        group = self.graph.group(symbol)
        if group is Group.Z:
            return self.scalar(self._items.states[index].derivative)
        if group is Group.U:
            return self.symbols.input_rate(index)
        assert group in (Group.QDD, Group.LAMBDA), group
        raise needs_accelerations(self.place, "this expression")


class _HeldStates(Lowering):
    """Rates of states are symbols, DIRECTION_Z, in the place of their equations."""

    def _rate_of_symbol(self, symbol: int) -> int:
        graph, index = self.graph, self.graph.b[symbol]
        if graph.group(symbol) is Group.Z:
            return graph.symbol(Group.DIRECTION_Z, index)
        if graph.group(symbol) is Group.DIRECTION_Z:
            return self._second_rate(self._items.states[index])
        return super()._rate_of_symbol(symbol)

    def _second_rate(self, state: State) -> int:
        """By the rates of states; E0308 where coordinates have a part in it, which would not be held."""
        found = self.rate.of(self.scalar(state.derivative))
        if self.graph.depends(found, Group.Q, Group.QD, Group.RELEASE, Group.RELEASE_RATE):
            raise needs_accelerations(
                self.place, f"what `der(der({state.name}))` carries", help=as_coordinate(state.name)
            )
        return found
