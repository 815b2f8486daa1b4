"""Nodes of physics items: energies, bodies, loads, constraints and what else begins with a keyword."""

from __future__ import annotations

from typing import Any, NamedTuple

from lagdsl.foundation.source import Span
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.reductions.action import Action, maker


class _Place(NamedTuple):
    """Place at which a load acts, or from which it reacts."""

    at: nodes.Expression | None
    on: nodes.Expression | None


class _Anchors(NamedTuple):
    """Anchors of a drawing."""

    place: str | None
    expressions: tuple[nodes.Expression, ...]


_LOAD = maker(nodes.Load, "keyword", "label", "value", "at", "on", "origin", "origin_on", "condition", "doc")
_DRAW = maker(nodes.Draw, "shape", "*arguments", "place", "anchors", "condition")


def _load(c: list[Any], span: Span) -> object:
    *head, place, origin, condition, text = c
    return _LOAD([*head, *place, *(origin or _Place(None, None)), condition, text], span)


def _draw(c: list[Any], span: Span) -> object:
    *head, anchors, condition = c
    return _DRAW([*head, *(anchors or _Anchors(None, ())), condition], span)


ITEMS: dict[str, Action] = {
    "energy": maker(nodes.Energy, "keyword", "label", "value", "condition", "doc"),
    "gravity": maker(nodes.Gravity, "value", "doc"),
    "point_mass": maker(nodes.PointMass, "mass", "at", "condition", "doc"),
    "rigid_body": maker(nodes.RigidBody, "label", "modifiers", "on", "condition", "doc"),
    "load": _load,
    "at_point": lambda c, span: _Place(*c),
    "on_frame_or_scalar": lambda c, span: _Place(None, *c),
    "origin": lambda c, span: _Place(*c),
    "constraint": maker(nodes.Constraint, "label", "left", "right", "condition", "doc"),
    "contact": maker(nodes.Contact, "label", "value", "options", "condition", "doc"),
    "friction": maker(nodes.Friction, "label", "value", "options", "condition", "doc"),
    "invariant": maker(nodes.Invariant, "label", "value", "options", "condition", "doc"),
    "measure": maker(nodes.Measure, "column", "value", "options", "doc"),
    "draw": _draw,
    "place_at": lambda c, span: _Anchors("at", tuple(c)),
    "place_on": lambda c, span: _Anchors("on", tuple(c)),
    "place_between": lambda c, span: _Anchors("between", tuple(c)),
    "connect": maker(nodes.Connect, "*items", "condition"),
}
