"""Walks over the syntax tree: children of a node, everything below it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields

from lagdsl.syntax import nodes

_FIELD_NAMES: dict[type[nodes.Node], tuple[str, ...]] = {}


def children(node: nodes.Node) -> Iterator[nodes.Node]:
    """The nodes that are fields of `node`, in source order."""
    for name in _field_names(type(node)):
        value = getattr(node, name)
        if isinstance(value, nodes.Node | tuple):
            yield from _nodes(value)


def _field_names(kind: type[nodes.Node]) -> tuple[str, ...]:
    known = _FIELD_NAMES.get(kind)
    if known is None:
        known = _FIELD_NAMES[kind] = tuple(field.name for field in fields(kind))
    return known


def _nodes(value: object) -> Iterator[nodes.Node]:
    if isinstance(value, nodes.Node):
        yield value
    elif isinstance(value, tuple):
        for part in value:
            yield from _nodes(part)


def descendants(node: nodes.Node) -> Iterator[nodes.Node]:
    """The node and everything below it, in source order, without recursion."""
    stack = [node]
    while stack:
        current = stack.pop()
        yield current
        stack.extend(reversed(list(children(current))))
