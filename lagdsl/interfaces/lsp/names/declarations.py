"""Declarations of names, with the places where they stand."""

from __future__ import annotations

import re
from dataclasses import field
from typing import TypeAlias

from lagdsl.foundation.record import record
from lagdsl.foundation.source import Span
from lagdsl.language.semantics.scope.scope import ClassSymbol, Labelled, Scope
from lagdsl.language.syntax import nodes

_WORD = re.compile(r'"(?:[^"\\]|\\.)*"|//[^\n]*|/\*.*?\*/|[A-Za-z_][A-Za-z0-9_]*', re.DOTALL)

LABELLED = (
    nodes.Energy,
    nodes.Load,
    nodes.Constraint,
    nodes.Contact,
    nodes.Friction,
    nodes.RigidBody,
    nodes.Invariant,
)
Named: TypeAlias = (
    nodes.Class | nodes.ShortClass | nodes.TypeDefinition | nodes.Function | nodes.FunctionParameter | nodes.Iterator
)


@record()
class Declaration:
    """One name. `kind` is its keyword or prefix; `node` the item that declares it, with its `declarator` if it has one;
    `scope` is where the names of the item are looked up; `symbol` the class, for a class; `protected`: not seen from
    outside. Two are the same if they stand at the same place."""

    name: str
    kind: str
    span: Span = field(compare=False)
    node: nodes.Node = field(compare=False, repr=False)
    declarator: nodes.Declarator | None = field(default=None, compare=False, repr=False)
    scope: Scope | None = field(default=None, compare=False, repr=False)
    symbol: ClassSymbol | None = field(default=None, compare=False, repr=False)
    protected: bool = field(default=False, compare=False)

    @property
    def place(self) -> tuple[str, int]:
        """Key of a declaration, the same each time its file is read."""
        return self.span.file.name, self.span.start

    @property
    def doc(self) -> str | None:
        if self.declarator is not None:
            return self.declarator.doc or _shared_doc(self.node)
        return getattr(self.node, "doc", None)


def _shared_doc(node: nodes.Node) -> str | None:
    """The doc string at the end of a statement of several names."""
    declarators = getattr(node, "declarators", ())
    return declarators[-1].doc if declarators else None


def words_of(span: Span, start: int | None = None) -> list[Span]:
    """The names and words in a text, strings and comments left out."""
    begin = span.start if start is None else start
    found = _WORD.finditer(span.file.text, begin, span.end)
    return [Span(span.file, *match.span()) for match in found if match[0][0] not in '"/']


def parts_of(name: nodes.Name) -> list[Span]:
    """The places of the parts of a dotted name."""
    return words_of(name.span)


def name_span(node: Named | Labelled) -> Span:
    """The place of the name that an item declares, or of its label."""
    if isinstance(node, nodes.Class):
        return node.name_span
    if isinstance(node, nodes.FunctionParameter):
        return words_of(node.span, node.type_name.span.end)[0]
    words = words_of(node.span)
    if isinstance(node, nodes.Iterator):
        return words[0]
    if isinstance(node, nodes.ShortClass):
        return words[[word.text for word in words].index(node.kind) + 1]
    return words[1]


def kind_of(item: nodes.Component | nodes.Coordinate | nodes.Geometry) -> str:
    """`parameter`, `coordinate`, `point` ...; `variable` without a prefix."""
    match item:
        case nodes.Coordinate():
            return "coordinate"
        case nodes.Geometry():
            return item.keyword
        case nodes.Component(prefixes=prefixes):
            told = [prefix for prefix in prefixes if prefix in _KINDS]
            return "structural parameter" if "structural" in told else told[-1] if told else "variable"


_KINDS = ("constant", "structural", "parameter", "input", "output", "state", "discrete", "flow")
