"""The shape of flat expressions: what stands below a node, orders to visit it in without recursion, and passes over all
expressions of a model."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any, TypeAlias, TypeVar, assert_never

from lagdsl.foundation.source import SourceFile, Span
from lagdsl.foundation.units import Dimension
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm

Part = TypeVar("Part")


def operands(expression: fx.FlatExpression) -> tuple[fx.FlatExpression, ...]:  # noqa: C901, PLR0912 a case per node
    """The direct subexpressions, in the order of the text."""
    match expression:  # those that models consist of stand first
        case fx.Binary():
            return (expression.left, expression.right)
        case fx.Number() | fx.Variable():
            return ()
        case fx.Unary() | fx.Derivative():
            return (expression.operand,)
        case fx.Function():
            return expression.arguments
        case fx.Previous() | fx.PointReference() | fx.FrameOrigin() | fx.FrameAxis():
            return ()
        case fx.Dot() | fx.Cross():
            return (expression.left, expression.right)
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
        case fx.AdmissibleMotion():
            return (expression.point,)
        case fx.AngularVelocity() | fx.Multiplier() | fx.FrameReaction() | fx.SystemEnergy():
            return ()
        case fx.GeneralizedMomentum() | fx.ForceBalance() | fx.LinearMomentum():
            return ()
        case fx.Motion():
            given = tuple(value for _, value in expression.parameters)
            return (*expression.positions, *expression.rates, *expression.accelerations, *given)
        case fx.RequiredForce():
            return (expression.motion,)
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


def postorder(expression: fx.FlatExpression, done: Container[int] = ()) -> Iterator[fx.FlatExpression]:
    """Every node after its operands, shared ones once; nodes whose `id` is in `done` are left out with all below.

    `done` may grow while this runs. Long sums are deep trees: passes that use this need no deep recursion.
    """
    seen: set[int] = set()
    stack: list[fx.FlatExpression | None] = [expression]
    waiting: list[fx.FlatExpression] = []  # nodes above the stack, each until None shows that its operands are done
    while stack:
        node = stack.pop()
        if node is None:
            yield waiting.pop()
            continue
        key = id(node)
        if key in seen or key in done:
            continue
        seen.add(key)
        if type(node) is fx.Binary:  # most nodes
            waiting.append(node)
            stack += (None, node.right, node.left)
            continue
        below = operands(node)
        if not below:
            yield node
            continue
        waiting.append(node)
        stack.append(None)
        stack.extend(below[::-1])


# ---- records that hold expressions -----------------------------------------------------------------------------------


def substituted(part: Part, values: Mapping[str, fx.FlatExpression]) -> Part:
    """`part` with `values` for the variables of these names; what holds none of them is the same object."""
    return rewritten(part, lambda node, _: values.get(node.name, node) if isinstance(node, fx.Variable) else None)


Rule: TypeAlias = Callable[[Any, Callable[[Any], Any]], Any]


def rewritten(part: Part, rule: Rule) -> Part:
    """`part` with what `rule` gives for its records, from the outside. A rule gets a record and the function that
    rewrites parts of it; where it gives None, the fields of the record are rewritten. A part without a change is the
    same object, and shared parts stay shared."""
    return _Rewriting(rule).of(part)  # type: ignore[no-any-return]


def records(part: Any) -> Iterator[Any]:
    """All records that `part` consists of, shared ones once: items and expressions, in the order of their fields."""
    seen: set[int] = set()
    stack = [part]
    while stack:
        found = stack.pop()
        if isinstance(found, tuple):
            stack += reversed(found)
        elif _is_record(found) and id(found) not in seen:
            seen.add(id(found))
            yield found
            stack += [getattr(found, each.name) for each in reversed(fields(found))]


def _is_record(part: Any) -> bool:
    return is_dataclass(part) and not isinstance(part, (Span, SourceFile, Dimension))


class _Rewriting:
    def __init__(self, rule: Rule) -> None:
        self._rule = rule
        self._known: dict[int, tuple[Any, Any]] = {}

    def of(self, part: Any) -> Any:
        if isinstance(part, tuple):
            found = tuple(self.of(each) for each in part)
            return found if any(new is not old for new, old in zip(found, part, strict=True)) else part
        if not _is_record(part):
            return part
        known = self._known.get(id(part))
        if known is None:
            changed = self._rule(part, self.of)
            known = self._known[id(part)] = part, self._fields(part) if changed is None else changed
        return known[1]

    def _fields(self, part: Any) -> Any:
        changed = {}
        for each in fields(part):
            old = getattr(part, each.name)
            new = self.of(old)
            if new is not old:
                changed[each.name] = new
        return replace(part, **changed) if changed else part
