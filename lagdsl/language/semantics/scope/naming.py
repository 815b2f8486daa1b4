"""Words for values in diagnostics, and names of elements in the flat model."""

from __future__ import annotations

import re

from lagdsl.foundation.diagnostics import Edit
from lagdsl.foundation.source import Span
from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.foundation.units.naming import describe, unit_text
from lagdsl.language.semantics.scope.values import (
    NUMERIC,
    AnyDimension,
    Array,
    Component,
    FrameValue,
    Poison,
    Reaction,
    Scalar,
    Text,
    Value,
    Vector,
)
from lagdsl.language.syntax import nodes


def an(noun: str) -> str:
    return f"an {noun}" if noun[:1].lower() in "aeiou" else f"a {noun}"


def quantity(dimension: AnyDimension) -> str:
    """`a length [m]`, `a number`, `a quantity in N.m3`."""
    shown = dimension if dimension is not None else DIMENSIONLESS
    words = describe(shown)
    return words if shown.is_dimensionless or words.startswith("a quantity in") else f"{words} [{unit_text(shown)}]"


def kind_of(value: Value) -> str:
    """Kind of a value, with its unit: `a scalar [m]`, `an array of 3 [rad]`, `a frame`."""
    match value:
        case Scalar(kind=kind) if kind not in NUMERIC:
            return an(kind)
        case Scalar():
            return f"a scalar{_bracket(value.dimension)}"
        case Vector():
            return f"a vector{_bracket(value.dimension)}"
        case Array():
            size = " by ".join(str(extent) for extent in value.shape)
            return f"an array of {size}{_bracket(value.dimension)}"
        case FrameValue():
            return "a frame"
        case Text():
            return "a String"
        case Reaction():
            return "a reaction: read its `.force` or `.torque`"
        case Component():
            return "a component"
        case Poison():
            return "nothing"


def _bracket(dimension: AnyDimension) -> str:
    return "" if dimension is None or dimension.is_dimensionless else f" [{unit_text(dimension)}]"


def braces(text: str) -> str:
    """Help for components that stand in other brackets than braces."""
    inside = text[1:-1].replace(";", ",").strip()
    short = inside.isprintable() and len(inside) <= 60
    return f"components stand in braces: `{{{inside}}}`" if short else "components stand in braces: `{a, b}`"


def row_in_braces(node: nodes.Node) -> str | None:
    """Help for `[x, y]` and `[x; y]`: one row or one column is an array of numbers in braces."""
    if not isinstance(node, nodes.Matrix) or (len(node.rows) > 1 and any(len(row) > 1 for row in node.rows)):
        return None
    return braces(node.span.text)


def element_name(name: str, indices: tuple[int, ...]) -> str:
    """`q[2,1]`; the name itself for a scalar."""
    return f"{name}[{','.join(str(index) for index in indices)}]" if indices else name


def name_span(argument: nodes.Named) -> Span:
    """The name in `name = value`."""
    return Span(argument.span.file, argument.span.start, argument.span.start + len(argument.name))


def without_each(span: Span) -> Edit | None:
    """The change that takes the word `each` from the beginning of a modifier."""
    word = re.match(r"each\s+", span.text)
    return None if word is None else Edit(Span(span.file, span.start, span.start + word.end()), "")


def each_help(text: str) -> str | None:
    """Help for a value whose `each` counts for the array around and not for the one inside; None for one without."""
    if not text.startswith("each "):
        return None
    return f"`each` counts for one array; the one inside needs its own: `each name({text})`"


def arguments_text(count: int | str) -> str:
    """`1 argument`, `2 to 4 arguments`."""
    return f"{count} argument" if str(count) == "1" else f"{count} arguments"
