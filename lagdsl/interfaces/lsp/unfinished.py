"""Leaves out of a tree what the parser completed: a declaration with a syntax error in it, a block without its `end`.

The parser ends them where it can, so that `point P` stands in the tree while `point P[3];` is being typed, and a loop
holds all that follows it. Other statements would be judged by a shape or a place that the text does not mean. Without
them their names are names that nothing declares, of which nothing is said in an incomplete text.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from lagdsl.foundation.diagnostics import Diagnostic, Severity
from lagdsl.language.syntax import nodes

_OPEN_BLOCK = "E0113"


def without_unfinished(unit: nodes.Unit, syntax: Iterable[Diagnostic]) -> nodes.Unit:
    """The tree without what is unfinished by the diagnostics of the parser; its blocks that are closed stay whole."""
    errors = [each for each in syntax if each.severity is Severity.ERROR and each.labels]
    places = [each.labels[0].span.start for each in errors]
    heads = {each.labels[0].span.start for each in errors if each.code == _OPEN_BLOCK}

    def finished(items: tuple[nodes.Item, ...]) -> tuple[nodes.Item, ...]:
        return tuple(inner(item) for item in items if not is_unfinished(item))

    def is_unfinished(item: nodes.Item) -> bool:
        if isinstance(item, nodes.Component | nodes.Coordinate | nodes.Geometry):
            return any(item.span.start <= place <= item.span.end for place in places)
        return isinstance(item, nodes.For | nodes.If | nodes.When) and item.span.start in heads

    def inner(item: nodes.Item) -> nodes.Item:
        if not isinstance(item, nodes.Class):
            return item
        sections = tuple(replace(section, items=finished(section.items)) for section in item.sections)
        return replace(item, items=finished(item.items), sections=sections)

    return replace(unit, items=finished(unit.items)) if places else unit
