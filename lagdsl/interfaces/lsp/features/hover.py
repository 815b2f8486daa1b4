"""Hovers: the declaration of a name with its value, or what the manual says of a word."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TypeAlias

from lsprotocol import types as lsp

from lagdsl.foundation.source import Span
from lagdsl.interfaces.lsp.deep import Depth
from lagdsl.interfaces.lsp.names.declarations import Declaration
from lagdsl.interfaces.lsp.names.occurrences import Occurrence
from lagdsl.interfaces.lsp.positions import range_of
from lagdsl.interfaces.lsp.snapshot import Snapshot
from lagdsl.language.flat.display import quantity_text
from lagdsl.language.flat.expression import Number
from lagdsl.language.flat.expression_text import flat_expression_text
from lagdsl.language.flat.model import Coordinate, Definition, FlatModel, Input, Output, Parameter, State
from lagdsl.language.manual.words import (
    ATTRIBUTES,
    VARIABLES,
    arguments_of,
    constant_text,
    keyword_text,
    paragraph_on,
    type_text,
    unit_text,
)
from lagdsl.language.settings.aliases import own_name
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.tokens import unit_of
from lagdsl.language.syntax.vocabulary import pattern

_WORD = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_PATH_BEFORE = re.compile(r"(?:[A-Za-z_]\w*(?:\[[0-9, ]*\])?\.)+$")
_LONGEST = 300

Item: TypeAlias = Parameter | Coordinate | State | Input | Output | Definition


def hover(snapshot: Snapshot, offset: int, depth: Depth | None) -> lsp.Hover | None:
    """Markdown for the word at `offset`."""
    found = snapshot.occurrence_at(offset)
    if found is not None and found.declaration is not None:
        text = _declared(snapshot, found, found.declaration, depth)
        return _hover("\n\n".join(text), found.span)
    unit = _unit_at(snapshot, offset) if found is None else None
    if unit is not None and (text_of_unit := unit_text(unit.text)) is not None:
        return _hover(text_of_unit, unit)
    word = found.span if found is not None else _word_at(snapshot, offset)
    if word is None:
        return None
    said = _of_language(word.text, found.role if found is not None else "keyword")
    return None if said is None else _hover(said, word)


def _hover(text: str, span: Span) -> lsp.Hover:
    return lsp.Hover(lsp.MarkupContent(lsp.MarkupKind.Markdown, text), range_of(span))


def _word_at(snapshot: Snapshot, offset: int) -> Span | None:
    line = snapshot.file.line_number(offset)
    start = snapshot.file.line_starts[line - 1]
    for match in _WORD.finditer(snapshot.file.line(line)):
        if start + match.start() <= offset <= start + match.end():
            return Span(snapshot.file, start + match.start(), start + match.end())
    return None


def _unit_at(snapshot: Snapshot, offset: int) -> Span | None:
    """The unit behind a number, without the number."""
    line = snapshot.file.line_number(offset)
    start, text = snapshot.file.line_starts[line - 1], snapshot.file.line(line)
    for match in pattern("QUANTITY").finditer(text):
        unit = start + match.start() + len(match[0].rstrip()) - len(unit_of(match[0]))
        if unit <= offset <= start + match.end():
            return Span(snapshot.file, unit, start + match.end())
    return None


def _of_language(word: str, role: str) -> str | None:
    if role == "attribute" and word in ATTRIBUTES:
        return f"attribute `{word}`: {ATTRIBUTES[word]}"
    if role == "function":
        return paragraph_on(word) or _counted(word)
    if (text := type_text(word)) is not None:
        return f"type `{word}`: {text}"
    if (text := constant_text(word)) is not None:
        return text
    if word in VARIABLES:
        return f"`{word}`: {VARIABLES[word]}"
    return keyword_text(word)


def _counted(word: str) -> str | None:
    """A function that the manual names without an example."""
    found = arguments_of(word)
    if found is None:
        return None
    least, most = found
    number = str(least) if least == most else f"{least} to {most}"
    return f"function `{word}` of {number} {'argument' if number == '1' else 'arguments'}"


# ---- declarations ----------------------------------------------------------------------------------------------------


def _declared(snapshot: Snapshot, found: Occurrence, declaration: Declaration, depth: Depth | None) -> Iterator[str]:
    yield f"```lag\n{head_of(declaration)}\n```"
    if declaration.doc:
        yield declaration.doc
    name = _qualified(snapshot, found, declaration)
    own = name
    for flat in snapshot.flats.values():
        told = list(_values(flat, name))
        yield from told
        if told:
            own = own_name(flat, name)
            break
    equation = depth.equations.get(own) if depth is not None else None
    if equation is not None:
        yield f"equation of motion: `{equation}`"


def head_of(declaration: Declaration) -> str:
    """The declaration on one line: prefixes, type, name, modifiers and value."""
    node, declarator = declaration.node, declaration.declarator
    if isinstance(node, nodes.Component) and declarator is not None:
        words = (*node.prefixes, node.type_name.span.text, _plain(declarator))
    elif isinstance(node, nodes.Coordinate) and declarator is not None:
        words = ("coordinate", node.type_name.span.text, _plain(declarator))
    elif isinstance(node, nodes.Geometry) and declarator is not None:
        words = (node.keyword, _plain(declarator))
    elif isinstance(node, nodes.Class):
        words = (*node.prefixes, node.kind, node.name)
    elif declarator is not None:
        words = (declaration.kind, _plain(declarator))
    else:
        words = (node.span.text.rstrip(";"),)
    text = " ".join(" ".join(words).split())
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]} …"


def _plain(declarator: nodes.Declarator) -> str:
    """The declarator without its doc string."""
    end = max(
        [declarator.name_span.end, declarator.span.start]
        + [each.span.end for each in (declarator.value, declarator.condition) if each is not None]
    )
    text = declarator.span.text
    if declarator.value is None and declarator.condition is None:
        return text if declarator.doc is None else text[: text.rfind('"', 0, text.rfind('"'))].rstrip()
    return declarator.span.file.text[declarator.span.start : end]


def _qualified(snapshot: Snapshot, found: Occurrence, declaration: Declaration) -> str:
    """The name in the flat model: with the components before it, as they are written."""
    before = _PATH_BEFORE.search(snapshot.text, max(found.span.start - 200, 0), found.span.start)
    return f"{before[0] if before is not None else ''}{declaration.name}"


def _values(flat: FlatModel, name: str) -> Iterator[str]:
    """Value, start or definition of the name, of each element where it is an array of few."""
    items: list[Item] = [*flat.parameters, *flat.coordinates, *flat.states, *flat.inputs, *flat.outputs]
    items += [each for each in flat.named if isinstance(each, Definition)]
    items += flat.observed
    merged = {alias.name: alias.of for alias in flat.aliases if _is_of(alias.name, name)}
    yield from (f"`{other}` is `{own}`: `connect` makes them one coordinate" for other, own in merged.items())
    own_names = set(merged.values())
    several = [each for each in items if _is_of(each.name, name) or each.name in own_names]
    lines = [line for each in several[:6] if (line := _line(each)) is not None]
    if lines:
        yield "  \n".join(lines)


def _is_of(element: str, name: str) -> bool:
    """True for the name itself and for elements of the array `name`."""
    return element == name or element.startswith(f"{name}[")


def _line(item: Item) -> str | None:
    unit = f" [{item.unit}]" if item.unit != "1" else ""
    match item:
        case Parameter():
            text = item.text if item.text is not None else quantity_text(item.value, item)
            return f"`{item.name} = {text}`"
        case Coordinate() | State():
            start = item.start
            shown = quantity_text(start.value, item) if isinstance(start, Number) else flat_expression_text(start)
            return f"`{item.name}`{unit}, starts at `{shown}`"
        case Input():
            return f"`{item.name}`{unit}, given from outside"
        case Output() | Definition():
            text = flat_expression_text(item.value)
            return f"`{item.name} = {text if len(text) <= _LONGEST else text[:_LONGEST] + ' …'}`{unit}"
