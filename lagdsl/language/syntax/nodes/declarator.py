"""The syntax tree: names, modifiers, declarators."""

from __future__ import annotations

from dataclasses import field
from typing import TypeAlias

from lagdsl.foundation.record import record
from lagdsl.foundation.source import Span
from lagdsl.language.syntax.nodes.expression import Expression, Node, Subscript


@record(kw_only=True)
class Name(Node):
    """Dotted name: `Lag.Planar.Revolute`."""

    parts: tuple[str, ...]


@record(kw_only=True)
class Modifier(Node):
    """`each final name[dims](nested) = value`; also `der(start = 2)` as name `der` with nested modifiers."""

    prefixes: tuple[str, ...]
    name: Name
    subscripts: tuple[Subscript, ...]
    modifiers: tuple[AnyModifier, ...]
    value: Expression | None


@record(kw_only=True)
class RedeclareComponent(Node):
    type_name: Name
    name: str
    subscripts: tuple[Subscript, ...]
    modifiers: tuple[AnyModifier, ...]


@record(kw_only=True)
class RedeclareClass(Node):
    kind: str
    name: str
    type_name: Name
    modifiers: tuple[AnyModifier, ...]


AnyModifier: TypeAlias = "Modifier | RedeclareComponent | RedeclareClass"


@record(kw_only=True)
class Declarator(Node):
    """`name[dims](modifiers) = value if condition "doc"`; `name_span` covers the identifier."""

    name: str
    name_span: Span = field(compare=False, repr=False)
    subscripts: tuple[Subscript, ...] = ()
    modifiers: tuple[AnyModifier, ...] = ()
    value: Expression | None = None
    condition: Expression | None = None
    doc: str | None = None
