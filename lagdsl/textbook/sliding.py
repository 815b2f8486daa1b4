"""Dry friction as people write it: -R sign(s') while it slides, -R v/|v| in a plane, and a multiplier while it sticks.

Both terms may stand in one equation: the multiplier is zero while it slides, and the sense of no slip is zero.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any

from lagdsl.flat import expression as fx
from lagdsl.flat.events import Friction
from lagdsl.flat.model import FlatModel
from lagdsl.source import SourceFile, Span
from lagdsl.units import Dimension

# Items that say which mode holds: their entries stay.
_LAWS = ("constraints", "events")


def with_senses(flat: FlatModel) -> FlatModel:
    """The model with senses of slips in place of the entries for them; it is only read."""
    frictions = flat.events.frictions
    if not frictions:
        return flat
    rewriting = _Rewriting(frictions)
    changed = {each.name: rewriting.of(getattr(flat, each.name)) for each in fields(flat) if each.name not in _LAWS}
    return replace(flat, **changed)


class _Rewriting:
    def __init__(self, frictions: tuple[Friction, ...]) -> None:
        self._sticking = {each.sticks for each in frictions}
        self._senses = {name: sense for each in frictions for name, sense in _senses(each).items()}
        self._known: dict[int, tuple[Any, Any]] = {}

    def of(self, part: Any) -> Any:
        if isinstance(part, tuple):
            return tuple(self.of(each) for each in part)
        if isinstance(part, (Span, SourceFile, Dimension)) or not is_dataclass(part):
            return part
        known = self._known.get(id(part))
        if known is None:
            known = self._known[id(part)] = part, self._changed(part)
        return known[1]

    def _changed(self, part: Any) -> Any:
        match part:
            case fx.Variable(name):
                return self._senses.get(name, part)
            case fx.Conditional(fx.Variable(name), value, otherwise) if name in self._sticking:
                return _sum(self.of(value), self.of(otherwise))
            case fx.Binary("+", left, right):
                return _sum(self.of(left), self.of(right))
            case fx.Conditional(fx.Binary(">", square, fx.ZERO), value, fx.ONE) if square == value:
                return self.of(value)  # the speed of a slip, which is not divided by where it is zero
            case _:
                return replace(part, **{each.name: self.of(getattr(part, each.name)) for each in fields(part)})


def _senses(friction: Friction) -> Mapping[str, fx.FlatExpression]:
    if len(friction.slips) == 1:
        return {friction.directions[0]: fx.Function("sign", friction.slips)}
    return dict.fromkeys(friction.directions, fx.ZERO)


def _sum(one: fx.FlatExpression, other: fx.FlatExpression) -> fx.FlatExpression:
    if fx.ZERO in (one, other):
        return other if one == fx.ZERO else one
    return fx.Binary("+", one, other)
