"""Definitions of arrays as vectors, where that is shorter than their elements."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from lagdsl.documents.report.sections.condensed import condensed_vector
from lagdsl.documents.report.sections.families import rolled
from lagdsl.language.flat import expression as fx


def by_vectors(
    definitions: Mapping[str, fx.FlatExpression], written: Callable[[fx.FlatExpression], str]
) -> list[tuple[str, ...]]:
    """Name and value of each; `d: b - a` or `d: {x, y, z}` for `d[1]`, `d[2]` and `d[3]` if it is shorter than these
    with an index."""
    arrays: dict[str, list[str]] = {}
    for name in definitions:
        arrays.setdefault(_array(name) or name, []).append(name)
    return [row for array, names in arrays.items() for row in _rows(array, names, definitions, written)]


def _array(name: str) -> str:
    """`a` of `a[3]` and `a[3]` of `a[3,1]`; "" of what has no index at its end."""
    if not name.endswith("]"):
        return ""
    own, bracket, indices = name[:-1].rpartition("[")
    before, comma, _ = indices.rpartition(",")
    return f"{own}{bracket}{before}]" if comma else own


def _rows(
    array: str,
    names: list[str],
    definitions: Mapping[str, fx.FlatExpression],
    written: Callable[[fx.FlatExpression], str],
) -> list[tuple[str, ...]]:
    elements: list[tuple[str, ...]] = [(name, written(definitions[name])) for name in names]
    inner = [f"{array[:-1]},{number}]" if array.endswith("]") else "" for number in range(1, len(names) + 1)]
    if names not in (inner, [f"{array}[{number}]" for number in range(1, len(names) + 1)]):
        return elements
    vector = (array, condensed_vector([definitions[name] for name in names]))
    return [vector] if _length([vector]) < _length(rolled(elements)) else elements


def _length(rows: list[tuple[str, ...]]) -> int:
    return sum(len(cell) for row in rows for cell in row)
