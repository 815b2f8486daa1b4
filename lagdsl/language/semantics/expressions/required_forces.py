"""`inverse_dynamics(q, a, ...)` and `bias(q, ...)`: forces that a motion of the mechanism requires of the loads."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Literal

from lagdsl.foundation.record import record
from lagdsl.foundation.units.dimension import DIMENSIONLESS, ENERGY
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.quantity import Variability
from lagdsl.language.semantics.operators.arguments import named
from lagdsl.language.semantics.operators.paths import designated
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.naming import kind_of, name_span
from lagdsl.language.semantics.scope.scope import Instance, Scope
from lagdsl.language.semantics.scope.values import POISON, Array, Order, Poison, Scalar, Value, highest
from lagdsl.language.semantics.types.bindings import Expected, bound
from lagdsl.language.syntax import nodes

_OPTIONS = ("positions", "rates")


@record()
class _Change:
    """A parameter that has another value in this motion: its name as the text has it, and the value."""

    target: nodes.Expression
    value: nodes.Expression


def inverse_dynamics(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    """Of pairs of coordinates and their accelerations: the forces at the coordinates of the first pair."""
    plain, changes = _arguments(ctx, scope, node)
    if not plain or len(plain) % 2:
        way = "write pairs of coordinates and their accelerations: `inverse_dynamics(q, a)`"
        return _wrong_number(ctx, node, "pairs of arguments", len(plain), way)
    moved = [_coordinates(ctx, scope, each) for each in plain[::2]]
    given: list[Scalar | Array] = []
    for each, acceleration in zip(moved, plain[1::2], strict=True):
        value = None if each is None else _given(ctx, scope, acceleration, each, "the acceleration", rates=2)
        given += [] if value is None else [value]
    known = [each for each in moved if each is not None]
    if len(given) < len(moved):
        return POISON
    return _forces(ctx, scope, node, "inverse_dynamics", known, given, changes)


def bias(ctx: Context, scope: Scope, node: nodes.Call) -> Value:
    """The forces at the named coordinates, without accelerations."""
    plain, changes = _arguments(ctx, scope, node)
    if len(plain) != 1:
        return _wrong_number(ctx, node, "1 argument", len(plain), "write the coordinates as an array: `bias({q1, q2})`")
    moved = _coordinates(ctx, scope, plain[0])
    return POISON if moved is None else _forces(ctx, scope, node, "bias", [moved], [], changes)


def _wrong_number(ctx: Context, node: nodes.Call, expected: str, found: int, way: str) -> Poison:
    ctx.sink.report("E0315", node.span, function=node.function.span.text, expected=expected, found=found, help=way)
    return POISON


def _arguments(ctx: Context, scope: Scope, node: nodes.Call) -> tuple[list[nodes.Expression], list[_Change]]:
    """The positional arguments, and the parameters that are changed: `m = 2 kg`, `arm(m = 2 kg)`."""
    plain: list[nodes.Expression] = []
    changes: list[_Change] = []
    for argument in node.arguments:
        if isinstance(argument, nodes.Named):
            if argument.name not in _OPTIONS:
                target = nodes.Reference(span=name_span(argument), name=argument.name)
                changes.append(_Change(target, argument.value))
        elif isinstance(argument, nodes.Call) and isinstance(designated(ctx, scope, argument.function), Instance):
            changes += _modified(argument, argument.function)
        else:
            plain.append(argument)
    return plain, changes


def _modified(call: nodes.Call, component: nodes.Expression) -> Iterator[_Change]:
    """The leaves of a modification of a component: `link(m = 2 kg)`, `arm(link(m = 2 kg))`."""
    for argument in call.arguments:
        if isinstance(argument, nodes.Named):
            yield _Change(_inside(component, argument.name, argument), argument.value)
        elif isinstance(argument, nodes.Call):
            yield from _modified(argument, _member(component, argument.function))
        else:
            yield _Change(_member(component, argument), argument)


def _member(component: nodes.Expression, path: nodes.Expression) -> nodes.Expression:
    """The name `path` as it is seen from `component`."""
    if isinstance(path, nodes.Reference):
        return _inside(component, path.name, path)
    if isinstance(path, nodes.Index | nodes.Member):
        return replace(path, target=_member(component, path.target))
    return path


def _inside(component: nodes.Expression, name: str, place: nodes.Node) -> nodes.Member:
    span = name_span(place) if isinstance(place, nodes.Named) else place.span
    return nodes.Member(span=span, target=component, name=name, name_span=span)


def _coordinates(ctx: Context, scope: Scope, node: nodes.Expression) -> Scalar | Array | None:
    """Names of coordinates, also behind names of a component; that they are coordinates shows in the whole model."""
    value = ctx.elaborate(ctx, scope, node, False)
    if isinstance(value, Poison):
        return None
    if (isinstance(value, Scalar) and isinstance(value.expression, flat.Variable)) or (
        isinstance(value, Array) and len(value.shape) == 1 and all(isinstance(x, flat.Variable) for x in value.elements)
    ):
        return value
    ctx.sink.report("E0312", node.span, expected="a coordinate or an array of coordinates", found=kind_of(value))
    return None


def _given(
    ctx: Context, scope: Scope, node: nodes.Expression, like: Scalar | Array, what: str, *, rates: int
) -> Scalar | Array | None:
    """A value for each coordinate, with the dimension of its derivative of the order `rates`."""
    dimension = like.dimension
    for _ in range(rates):
        dimension = ctx.conventions.rate(dimension)
    shape = like.shape if isinstance(like, Array) else ()
    value = bound(ctx, scope, node, Expected(what, dimension, shape, code="E0415"))
    return value if isinstance(value, Scalar | Array) else None


def _forces(
    ctx: Context,
    scope: Scope,
    node: nodes.Call,
    function: Literal["inverse_dynamics", "bias"],
    moved: list[Scalar | Array],
    accelerations: list[Scalar | Array],
    changes: list[_Change],
) -> Value:
    own = [x for each in moved for x in _elements(each)]
    state: dict[str, tuple[flat.FlatExpression, ...]] = {
        "positions": tuple(own),
        "rates": tuple(flat.Derivative(x) for x in own),
    }
    values = [*moved, *accelerations]
    count = len(_elements(moved[0]))
    for rates, option in enumerate(_OPTIONS):
        asked = named(node, option)
        if asked is not None:
            found = _given(ctx, scope, asked, moved[0], f"`{option}`", rates=rates)
            if found is None:
                return POISON
            values.append(found)
            state[option] = (*_elements(found), *state[option][count:])
    parameters = _parameters(ctx, scope, changes, function, values)
    if parameters is None:
        return POISON
    motion = flat.Motion(
        function,
        tuple(x.name for x in own if isinstance(x, flat.Variable)),
        state["positions"],
        state["rates"],
        tuple(x for each in accelerations for x in _elements(each)),
        parameters,
        node.span,
    )
    ctx.counts.motions += 1
    forces = tuple(flat.RequiredForce(motion, place) for place in range(count))
    dimension = ctx.conventions.dimension(ENERGY) / (moved[0].dimension or DIMENSIONLESS)
    order = max(Order.RATE, highest(*values))
    if isinstance(moved[0], Scalar):
        return Scalar(forces[0], dimension, Variability.CONTINUOUS, order)
    return Array(forces, moved[0].shape, dimension, Variability.CONTINUOUS, order)


def _parameters(
    ctx: Context, scope: Scope, changes: list[_Change], function: str, values: list[Scalar | Array]
) -> tuple[tuple[str, flat.FlatExpression], ...] | None:
    """Parameters with their other values, which are added to `values`; None after a diagnostic."""
    found: list[tuple[str, flat.FlatExpression]] = []
    for change in changes:
        target = ctx.elaborate(ctx, scope, change.target, False)
        if isinstance(target, Poison):
            return None
        name = change.target.span.text
        elements = _elements(target) if isinstance(target, Scalar | Array) else ()
        free = isinstance(target, Scalar | Array) and target.variability is Variability.PARAMETER
        if not elements or not free or not all(isinstance(x, flat.Variable) for x in elements):
            reason = f"`{name}` is no parameter whose value may be changed"
            way = "name parameters of the model that are neither structural nor computed from others"
            ctx.sink.report("E0528", change.target.span, function=function, reason=reason, help=way)
            return None
        assert isinstance(target, Scalar | Array)
        value = _given(ctx, scope, change.value, target, f"`{name}`", rates=0)
        if value is None:
            return None
        values.append(value)
        names = [x.name for x in elements if isinstance(x, flat.Variable)]
        found += zip(names, _elements(value), strict=True)
    return tuple(found)


def _elements(value: Scalar | Array) -> tuple[flat.FlatExpression, ...]:
    return (value.expression,) if isinstance(value, Scalar) else value.elements
