"""Walks over the syntax tree: children of a node, everything below it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields

from lagdsl.language.syntax import nodes

_FIELD_NAMES: dict[type[nodes.Node], tuple[str, ...]] = {}
_WITHOUT_NODES = ("str", "str | None", "bool", "Span", "Span | None", "tuple[str, ...]")


def children(node: nodes.Node) -> list[nodes.Node]:
    """The nodes that are fields of `node`, in source order."""
    found: list[nodes.Node] = []
    for name in _field_names(type(node)):
        _add(getattr(node, name), found)
    return found


def _field_names(kind: type[nodes.Node]) -> tuple[str, ...]:
    known = _FIELD_NAMES.get(kind)
    if known is None:
        known = tuple(field.name for field in fields(kind) if field.type not in _WITHOUT_NODES)
        _FIELD_NAMES[kind] = known
    return known


def _add(value: object, found: list[nodes.Node]) -> None:
    if isinstance(value, nodes.Node):
        found.append(value)
    elif isinstance(value, tuple):
        for part in value:
            _add(part, found)


def descendants(node: nodes.Node) -> Iterator[nodes.Node]:
    """The node and everything below it, in source order, without recursion."""
    stack = [node]
    while stack:
        current = stack.pop()
        yield current
        below = children(current)
        if below:
            below.reverse()
            stack += below
