"""Nodes of physics items: energies, bodies, loads, constraints and what else begins with a keyword."""

from __future__ import annotations

from typing import Any, NamedTuple

from lagdsl.source import Span
from lagdsl.syntax import nodes
from lagdsl.syntax.reductions.action import Action
from lagdsl.syntax.reductions.declarations import doc, label


class _Place(NamedTuple):
    """Place at which a load acts, or from which it reacts."""

    at: nodes.Expression | None
    on: nodes.Expression | None


def _energy(c: list[Any], span: Span) -> nodes.Energy:
    keyword, name, value, condition, text = c
    return nodes.Energy(
        span=span, keyword=keyword.value, label=label(name), value=value, condition=condition, doc=doc(text)
    )


def _point_mass(c: list[Any], span: Span) -> nodes.PointMass:
    mass, at, condition, text = c
    return nodes.PointMass(span=span, mass=mass, at=at, condition=condition, doc=doc(text))


def _rigid_body(c: list[Any], span: Span) -> nodes.RigidBody:
    name, modifiers, on, condition, text = c
    return nodes.RigidBody(span=span, label=label(name), modifiers=modifiers, on=on, condition=condition, doc=doc(text))


def _load(c: list[Any], span: Span) -> nodes.Load:
    keyword, name, value, place, origin, condition, text = c
    return nodes.Load(
        span=span,
        keyword=keyword.value,
        label=label(name),
        value=value,
        at=place.at,
        on=place.on,
        origin=None if origin is None else origin.at,
        origin_on=None if origin is None else origin.on,
        condition=condition,
        doc=doc(text),
    )


def _constraint(c: list[Any], span: Span) -> nodes.Constraint:
    name, left, right, condition, text = c
    return nodes.Constraint(span=span, label=label(name), left=left, right=right, condition=condition, doc=doc(text))


def _contact(c: list[Any], span: Span) -> nodes.Contact:
    name, value, options, condition, text = c
    return nodes.Contact(
        span=span, label=label(name), value=value, options=options or (), condition=condition, doc=doc(text)
    )


def _invariant(c: list[Any], span: Span) -> nodes.Invariant:
    name, value, options, condition, text = c
    return nodes.Invariant(
        span=span, label=label(name), value=value, options=options or (), condition=condition, doc=doc(text)
    )


class _Anchors(NamedTuple):
    """Anchors of a drawing."""

    place: str
    expressions: tuple[nodes.Expression, ...]


def _draw(c: list[Any], span: Span) -> nodes.Draw:
    shape, *arguments, anchors, condition = c
    return nodes.Draw(
        span=span,
        shape=shape.value,
        arguments=tuple(argument for argument in arguments if argument is not None),
        place=None if anchors is None else anchors.place,
        anchors=() if anchors is None else anchors.expressions,
        condition=condition,
    )


ITEMS: dict[str, Action] = {
    "energy": _energy,
    "gravity": lambda c, span: nodes.Gravity(span=span, value=c[0], doc=doc(c[1])),
    "point_mass": _point_mass,
    "rigid_body": _rigid_body,
    "load": _load,
    "at_point": lambda c, span: _Place(c[0], c[1]),
    "on_frame_or_scalar": lambda c, span: _Place(None, c[0]),
    "origin": lambda c, span: _Place(c[0], c[1]),
    "constraint": _constraint,
    "contact": _contact,
    "invariant": _invariant,
    "draw": _draw,
    "place_at": lambda c, span: _Anchors("at", tuple(c)),
    "place_on": lambda c, span: _Anchors("on", tuple(c)),
    "place_between": lambda c, span: _Anchors("between", tuple(c)),
    "connect": lambda c, span: nodes.Connect(span=span, items=tuple(c[:-1]), condition=c[-1]),
}
