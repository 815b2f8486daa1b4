"""Passes over all expressions of a model, or of a part of it, wherever they stand."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any, TypeVar

from lagdsl.flat.expression import FlatExpression, Variable
from lagdsl.source import SourceFile, Span
from lagdsl.units import Dimension

Part = TypeVar("Part")


def substituted(part: Part, values: Mapping[str, FlatExpression]) -> Part:
    """`part` with `values` for the variables of these names; what holds none of them is the same object."""
    return _Substitution(values).of(part)  # type: ignore[no-any-return]


def records(part: Any) -> Iterator[Any]:
    """All records that `part` consists of, shared ones once: items and expressions."""
    seen: set[int] = set()
    stack = [part]
    while stack:
        found = stack.pop()
        if isinstance(found, tuple):
            stack += found
        elif _is_record(found) and id(found) not in seen:
            seen.add(id(found))
            yield found
            stack += [getattr(found, each.name) for each in fields(found)]


def _is_record(part: Any) -> bool:
    return is_dataclass(part) and not isinstance(part, (Span, SourceFile, Dimension))


class _Substitution:
    """Shared parts stay shared."""

    def __init__(self, values: Mapping[str, FlatExpression]) -> None:
        self._values = values
        self._known: dict[int, tuple[Any, Any]] = {}

    def of(self, part: Any) -> Any:
        if isinstance(part, Variable):
            return self._values.get(part.name, part)
        if isinstance(part, tuple):
            found = tuple(self.of(each) for each in part)
            return found if any(new is not old for new, old in zip(found, part, strict=True)) else part
        if not _is_record(part):
            return part
        known = self._known.get(id(part))
        if known is None:
            known = self._known[id(part)] = part, self._record(part)
        return known[1]

    def _record(self, part: Any) -> Any:
        changed = {}
        for each in fields(part):
            old = getattr(part, each.name)
            new = self.of(old)
            if new is not old:
                changed[each.name] = new
        return replace(part, **changed) if changed else part
