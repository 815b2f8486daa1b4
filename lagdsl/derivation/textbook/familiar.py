"""The flat model in the quantities that people write down.

Zeros that belong to components (an offset nobody wants, a product of inertia) are left out, so that they burden no
formula; equal moments of inertia of one body are written as one. Numbers that carry a unit in the text get a letter:
`gravity = {0, -9.81 m/s2}` is g = 9.81 m/s2, `mass 2 kg at P` is m_P. Dry friction has the sense of its slip. Only
people read this model.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, fields, replace
from typing import Any

from lagdsl.foundation.source import Span
from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import ACCELERATION, INERTIA, MASS
from lagdsl.language.flat.events import Friction
from lagdsl.language.flat.expression import (
    ONE,
    ZERO,
    Binary,
    Component,
    Conditional,
    FlatExpression,
    FrameOrigin,
    Function,
    Number,
    PointReference,
    Unary,
    Variable,
    Vector,
)
from lagdsl.language.flat.model import Definition, FlatModel, Parameter, PointMass, RigidBody
from lagdsl.language.flat.quantity import Variability, fields_of
from lagdsl.language.flat.traversal import postorder, rewritten

_STANDARD_GRAVITY = 9.80665
# Items that say which mode holds: their entries stay.
_LAWS = ("constraints", "events")


@dataclass(frozen=True, slots=True)
class Familiar:
    """`flat` is the model for people. It has lost the parameters `zeros`, and of `twins` the first ones, which have the
    value of the second."""

    flat: FlatModel
    zeros: tuple[str, ...]
    twins: tuple[tuple[str, str], ...]


def familiar(model: FlatModel) -> Familiar:
    """The model for people."""
    model = _with_senses(model)
    zeros = tuple(item.name for item in model.parameters if _is_idle(item))
    idle = frozenset(zeros)
    twins = dict(_twins(model.parameters))
    parameters = [
        replace(item, structural=True) if item.name in idle else item
        for item in model.parameters
        if item.name not in twins
    ]
    aliases = tuple(
        Definition(**fields_of(item), value=Variable(twins[item.name]), variability=Variability.PARAMETER)
        for item in model.parameters
        if item.name in twins
    )
    taken = {*(item.name for item in (*model.parameters, *model.coordinates, *model.states, *model.inputs))}
    taken |= {item.name for item in model.named}
    gravity = model.gravity
    if gravity is not None:
        gravity, letter = _gravity(model, gravity, taken)
        parameters += letter
    masses, letters = _masses(model.masses, taken)
    parameters += letters
    bodies, letters = _bodies(model.bodies, taken)
    parameters += letters
    flat = replace(
        model,
        parameters=tuple(parameters),
        named=(*aliases, *model.named),
        gravity=gravity,
        masses=masses,
        bodies=bodies,
    )
    return Familiar(flat, zeros, tuple(twins.items()))


def _twins(parameters: tuple[Parameter, ...]) -> Iterator[tuple[str, str]]:
    """Equal moments of inertia of one body, each with the first of them: the body is symmetric."""
    first: dict[tuple[str, float], str] = {}
    for item in parameters:
        array, bracket, _ = item.name.rpartition("[")
        if not bracket or item.structural or item.free or item.value == 0 or item.dimension != INERTIA:
            continue
        known = first.setdefault((array, item.value), item.name)
        if known != item.name:
            yield item.name, known


def _is_idle(item: Parameter) -> bool:
    """A zero of a component or in an array; a zero that stands by itself is one that its author wants to see."""
    inside = "." in item.name or "[" in item.name
    return inside and item.value == 0 and not item.structural and not item.free


def _gravity(model: FlatModel, gravity: FlatExpression, taken: set[str]) -> tuple[FlatExpression, list[Parameter]]:
    """The one number of gravity by its letter."""
    numbers = {node.value for node in postorder(gravity) if isinstance(node, Number)} - {0.0, 1.0, -1.0}
    if len(numbers) != 1 or {abs(number) for number in numbers} == {_STANDARD_GRAVITY}:
        return gravity, []
    [value] = numbers
    name = _free(("g", "g_0", "g_local"), taken)
    if name is None or not model.gravity_span:
        return gravity, []
    letter: FlatExpression = Variable(name) if value > 0 else Unary("-", Variable(name))
    words = "gravitational acceleration"
    made = _parameter(name, abs(value), ACCELERATION, "m/s2", words, (model.gravity_span,))
    return _replaced(gravity, value, letter), [made]


def _masses(items: tuple[PointMass, ...], taken: set[str]) -> tuple[tuple[PointMass, ...], list[Parameter]]:
    made: list[Parameter] = []
    result = []
    for number, item in enumerate(items, start=1):
        labels: tuple[str, ...] = (f"m_{number}",)
        if isinstance(item.position, PointReference):
            labels = (f"m_{item.position.name}", *labels)
        if isinstance(item.position, FrameOrigin):
            labels = (f"m_{item.position.frame}", *labels)
        mass, letter = _mass(item.mass, labels, taken, item.spans)
        made += letter
        result.append(replace(item, mass=mass))
    return tuple(result), made


def _bodies(items: tuple[RigidBody, ...], taken: set[str]) -> tuple[tuple[RigidBody, ...], list[Parameter]]:
    made: list[Parameter] = []
    result = []
    for item in items:
        mass, letter = _mass(item.mass, (f"m_{item.label or item.frame}",), taken, item.spans)
        made += letter
        result.append(replace(item, mass=mass))
    return tuple(result), made


def _mass(
    value: FlatExpression, labels: tuple[str, ...], taken: set[str], spans: tuple[Span, ...]
) -> tuple[FlatExpression, list[Parameter]]:
    if not isinstance(value, Number) or value.value == 0:
        return value, []
    name = _free(labels, taken)
    if name is None:
        return value, []
    return Variable(name), [_parameter(name, value.value, MASS, "kg", "mass", spans)]


def _free(names: tuple[str, ...], taken: set[str]) -> str | None:
    """The first name that nothing bears, which is taken from now on."""
    for name in names:
        if name not in taken:
            taken.add(name)
            return name
    return None


def _parameter(
    name: str, value: float, dimension: Dimension, unit: str, doc: str, spans: tuple[Span, ...]
) -> Parameter:
    return Parameter(name=name, dimension=dimension, unit=unit, doc=doc, type_name="Real", value=value, spans=spans)


def _replaced(expression: FlatExpression, value: float, letter: FlatExpression) -> FlatExpression:
    """The vector with `letter` for a number; forms that gravity is not written in stay as they are."""
    if expression == Number(value):
        return letter
    if isinstance(expression, Unary):
        return replace(expression, operand=_replaced(expression.operand, value, letter))
    if isinstance(expression, Binary):
        left, right = (_replaced(each, value, letter) for each in (expression.left, expression.right))
        return replace(expression, left=left, right=right)
    if isinstance(expression, Vector):
        x, y, z = (_replaced(each, value, letter) for each in (expression.x, expression.y, expression.z))
        return replace(expression, x=x, y=y, z=z)
    if isinstance(expression, Component):
        return replace(expression, vector=_replaced(expression.vector, value, letter))
    return expression


# ---- dry friction ----------------------------------------------------------------------------------------------------


def _with_senses(flat: FlatModel) -> FlatModel:
    """The model with senses of slips in place of the entries for them: -R sign(s') while it slides, -R v/|v| in a
    plane, and a multiplier while it sticks. Both may stand in one equation, as the sense of no slip is zero."""
    frictions = flat.events.frictions
    if not frictions:
        return flat
    sticking = {each.sticks for each in frictions}
    senses = {name: sense for each in frictions for name, sense in _senses(each).items()}

    def rule(part: Any, of: Callable[[Any], Any]) -> Any:
        if isinstance(part, Variable):
            return senses.get(part.name)
        if isinstance(part, Conditional):
            condition = part.condition
            if isinstance(condition, Variable) and condition.name in sticking:
                return _sum(of(part.value), of(part.otherwise))
            if condition == Binary(">", part.value, ZERO) and part.otherwise == ONE:
                return of(part.value)  # the speed of a slip, by which nothing is divided where it is zero
        if isinstance(part, Binary) and part.operator == "+":
            return _sum(of(part.left), of(part.right))
        return None

    changed = {each.name: rewritten(getattr(flat, each.name), rule) for each in fields(flat) if each.name not in _LAWS}
    return replace(flat, **changed)


def _senses(friction: Friction) -> Mapping[str, FlatExpression]:
    if len(friction.slips) == 1:
        return {friction.directions[0]: Function("sign", friction.slips)}
    return dict.fromkeys(friction.directions, ZERO)


def _sum(one: FlatExpression, other: FlatExpression) -> FlatExpression:
    if ZERO in (one, other):
        return other if one == ZERO else one
    return Binary("+", one, other)
