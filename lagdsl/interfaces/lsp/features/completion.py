"""Completion: names in scope, members after a dot, units after a number, modifiers, statements."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from lsprotocol import types as lsp

from lagdsl.foundation.units.vocabulary import UNITS
from lagdsl.interfaces.lsp.features.arguments import arguments_at, shapes_at
from lagdsl.interfaces.lsp.features.cursor import Cursor, cursor_at
from lagdsl.interfaces.lsp.features.hover import head_of
from lagdsl.interfaces.lsp.features.symbols import symbol_kind
from lagdsl.interfaces.lsp.names.classes import ClassNames, of_entry
from lagdsl.interfaces.lsp.names.declarations import Declaration
from lagdsl.interfaces.lsp.snapshot import Snapshot
from lagdsl.interfaces.lsp.snippets import SNIPPETS
from lagdsl.language.manual.component_page import component_page
from lagdsl.language.manual.library import UnknownClass, matching
from lagdsl.language.manual.words import ATTRIBUTES, FUNCTIONS, VARIABLES, constant_text, statement_of, type_text
from lagdsl.language.semantics.operators.frictions import MEMBER
from lagdsl.language.semantics.operators.geometry import AXES, FRAME_MEMBERS, METHODS
from lagdsl.language.semantics.scope.imports import root_of
from lagdsl.language.semantics.scope.prelude import CONSTANTS, TYPES
from lagdsl.language.semantics.scope.scope import ClassSymbol, Entry, Scope, lookup, reachable
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.stack import statement_words


def completion(snapshot: Snapshot, offset: int) -> lsp.CompletionList:
    """Texts that fit at `offset`; the library's classes are described when an item is resolved."""
    cursor = cursor_at(snapshot.text, offset)
    return lsp.CompletionList(is_incomplete=False, items=list(_items(snapshot, offset, cursor)))


def _items(snapshot: Snapshot, offset: int, cursor: Cursor) -> Iterator[lsp.CompletionItem]:
    names = snapshot.class_at(offset)
    scope = names.scope if names is not None else snapshot.scope
    given = arguments_at(cursor) if cursor.want in ("modifier", "expression") else ()
    if given:
        yield from (_attribute(name) for name in given)
        return
    match cursor.want:
        case "nothing":
            pass
        case "unit":
            yield from (_item(unit, lsp.CompletionItemKind.Unit) for unit in UNITS)
        case "package":
            yield from _of_package(_package(scope, cursor.path) if scope is not None else None, scope, cursor.path)
        case "member":
            yield from _of_value(cursor.called) if cursor.called else _members(snapshot, names, scope, cursor.path)
        case "modifier":
            yield from _modifiers(snapshot, names, scope, cursor)
        case "type":
            yield from _types(scope)
        case "statement":
            yield from _statements()
            yield from _types(scope)
            yield from _names(names, scope)
        case "expression" if shapes := shapes_at(cursor):
            yield from (_item(name, lsp.CompletionItemKind.EnumMember) for name in shapes)
        case "expression":
            yield from _names(names, scope)
            yield from _language()
            yield from _types(scope) if _declares(cursor) else ()


def _declares(cursor: Cursor) -> bool:
    return cursor.statement[:1] in (("redeclare",), ("extends",))


def _item(name: str, kind: lsp.CompletionItemKind, detail: str | None = None) -> lsp.CompletionItem:
    return lsp.CompletionItem(name, kind=kind, detail=detail)


def _of(found: Declaration) -> lsp.CompletionItem:
    kind = lsp.CompletionItemKind[symbol_kind(found).name] if symbol_kind(found).name in _SHARED else _VARIABLE
    documentation = lsp.MarkupContent(lsp.MarkupKind.Markdown, found.doc) if found.doc else None
    return lsp.CompletionItem(found.name, kind=kind, detail=head_of(found), documentation=documentation)


_VARIABLE = lsp.CompletionItemKind.Variable
_SHARED = {kind.name for kind in lsp.CompletionItemKind}


def _names(names: ClassNames | None, scope: Scope | None) -> Iterator[lsp.CompletionItem]:
    if names is not None:
        yield from (_of(each) for each in names.members.values())


def _language() -> Iterator[lsp.CompletionItem]:
    yield from (_item(name, lsp.CompletionItemKind.Function) for name in FUNCTIONS)
    yield from (_item(name, lsp.CompletionItemKind.Constant, constant_text(name)) for name in CONSTANTS)
    yield from (_item(name, _VARIABLE, text) for name, text in VARIABLES.items())
    yield from (_item(name, lsp.CompletionItemKind.Keyword) for name in ("if", "true", "false", "not"))


def _statements() -> Iterator[lsp.CompletionItem]:
    for word in sorted(statement_words()):
        said = statement_of(word)
        item = _item(word, lsp.CompletionItemKind.Keyword, said[1] if said is not None else None)
        if word in SNIPPETS:
            item.kind = lsp.CompletionItemKind.Snippet
            item.insert_text, item.insert_text_format = SNIPPETS[word], lsp.InsertTextFormat.Snippet
        yield item


def _types(scope: Scope | None) -> Iterator[lsp.CompletionItem]:
    yield from (_item(name, lsp.CompletionItemKind.TypeParameter, type_text(name)) for name in TYPES)
    if scope is None:
        return
    seen: set[str] = set()
    for step in scope.chain():
        for name, entry in step.entries.items():
            found = of_entry(name, entry)
            if found is not None and name not in seen and found.kind not in ("constant", "structural parameter"):
                seen.add(name)
                yield _of(found)
    for name in reachable(scope):
        if name not in seen:
            seen.add(name)
            yield _item(name, lsp.CompletionItemKind.Class)


def _package(scope: Scope, path: tuple[str, ...]) -> Scope | None:
    """The names of the package that a path means."""
    if not path:
        return None
    entry: Entry | None = root_of(scope).find(path[0], None) or lookup(scope, path[0])
    for part in path[1:]:
        entry = entry.inner.find(part) if isinstance(entry, ClassSymbol) and entry.inner is not None else None
    return entry.inner if isinstance(entry, ClassSymbol) else None


def _of_package(package: Scope | None, scope: Scope | None, path: tuple[str, ...]) -> Iterator[lsp.CompletionItem]:
    if package is not None:
        full = ".".join(path)
        for name in package.names():
            item = _item(name, lsp.CompletionItemKind.Class if name[:1].isupper() else _VARIABLE)
            item.data = f"{full}.{name}"
            yield item
    elif scope is not None and not path:
        yield from (_item(name, lsp.CompletionItemKind.Module) for name in root_of(scope).names())


def _members(
    snapshot: Snapshot, names: ClassNames | None, scope: Scope | None, path: tuple[str, ...]
) -> Iterator[lsp.CompletionItem]:
    found = names.members.get(path[0]) if names is not None else None
    if found is None and path[0] != "world":
        yield from _of_package(_package(scope, path) if scope is not None else None, None, path)
        return
    for part in path[1:]:
        inner = snapshot.classes.members_of_type(found) if found is not None else None
        found = inner.members.get(part) if inner is not None else None
    inside = snapshot.classes.members_of_type(found) if found is not None else None
    if inside is not None:
        yield from (_of(each) for each in inside.members.values() if not each.protected)
    elif path == ("world",) or (found is not None and found.kind == "frame"):
        yield from _of_frame()
    elif found is not None and isinstance(found.node, nodes.Contact):
        if any(option.name == MEMBER for option in found.node.options):
            yield _item(MEMBER, lsp.CompletionItemKind.Field)
    elif path[-1] in FRAME_MEMBERS or (found is not None and found.kind == "point"):
        yield from (_item(name, lsp.CompletionItemKind.Field) for name in AXES)


_VECTORS = ("at", "point", "vec")
"""Methods of frames that give vectors; the others give frames."""


def _of_value(called: str) -> Iterator[lsp.CompletionItem]:
    """Members of the value of a function."""
    if called == "reaction":
        yield from (_item(name, lsp.CompletionItemKind.Field) for name in ("force", "torque"))
    elif called in METHODS and called not in _VECTORS:
        yield from _of_frame()
    elif called in _VECTORS:
        yield from (_item(name, lsp.CompletionItemKind.Field) for name in AXES)


def _of_frame() -> Iterator[lsp.CompletionItem]:
    yield from (_item(name, lsp.CompletionItemKind.Field) for name in FRAME_MEMBERS)
    yield from (_item(name, lsp.CompletionItemKind.Method) for name in METHODS)


def _modifiers(
    snapshot: Snapshot, names: ClassNames | None, scope: Scope | None, cursor: Cursor
) -> Iterator[lsp.CompletionItem]:
    """Members of the class of what is declared, or of a member of it; attributes of a quantity."""
    type_path = _type_path(cursor.statement)
    entry: Entry | None = lookup(scope, type_path[0]) if scope is not None and type_path else None
    for part in type_path[1:]:
        entry = entry.inner.find(part) if isinstance(entry, ClassSymbol) and entry.inner is not None else None
    inside = snapshot.classes.names(entry) if isinstance(entry, ClassSymbol) and entry.inner is None else None
    for bracket in cursor.brackets[1:]:
        found = inside.members.get(bracket.before[-1]) if inside is not None and bracket.before else None
        inside = snapshot.classes.members_of_type(found) if found is not None else None
    if inside is not None:
        yield from (_set(each) for each in _modifiable(inside.members.values()))
    else:
        yield from (_attribute(name, text) for name, text in ATTRIBUTES.items())


def _attribute(name: str, text: str | None = None) -> lsp.CompletionItem:
    item = _item(name, lsp.CompletionItemKind.Property, text)
    item.insert_text = name if name in ("der", "omega", "experiment", "page") else f"{name} = "
    return item


def _type_path(statement: tuple[str, ...]) -> tuple[str, ...]:
    """The dotted type of a declaration, from the texts of its tokens."""
    found: list[str] = []
    for text in statement:
        if text[:1].isupper() or (found and found[-1] == "."):
            if found and found[-1] != ".":
                break
            found.append(text)
        elif text == "." and found:
            found.append(text)
        elif found:
            break
    return tuple(text for text in found if text != ".")


def _modifiable(found: Iterable[Declaration]) -> Iterator[Declaration]:
    for each in found:
        if not each.protected and isinstance(each.node, nodes.Component | nodes.Coordinate | nodes.Geometry):
            yield each


def _set(found: Declaration) -> lsp.CompletionItem:
    item = _of(found)
    item.insert_text = f"{found.name}(" if found.kind == "coordinate" else f"{found.name} = "
    return item


def resolve(item: lsp.CompletionItem) -> lsp.CompletionItem:
    """The item with the manual's page of its class: parameters, ports, equations."""
    if isinstance(item.data, str) and item.documentation is None:
        try:
            page = component_page(matching(item.data)[0])
        except UnknownClass:
            return item
        text = page.partition("## Text")[0].partition("## Equations")[0]
        item.documentation = lsp.MarkupContent(lsp.MarkupKind.Markdown, text.strip())
    return item
