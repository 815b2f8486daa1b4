"""Renaming: every text that names the declaration, changed; refused where the models would not be the same."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from lagdsl.foundation.diagnostics import Severity
from lagdsl.foundation.resources import library_folder
from lagdsl.foundation.source import Span
from lagdsl.interfaces.lsp.features.references import references
from lagdsl.interfaces.lsp.findings import findings
from lagdsl.interfaces.lsp.names.declarations import Declaration
from lagdsl.interfaces.lsp.snapshot import Snapshot
from lagdsl.language.semantics.scope.prelude import CONSTANTS, TYPES
from lagdsl.language.syntax.vocabulary import vocabulary

_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


class Refused(ValueError):  # noqa: N818 named after what it says
    """The name cannot be changed so; the text says why."""


def check_renamable(wanted: Declaration) -> None:
    """Raises Refused for what the library declares."""
    path = library_folder() / wanted.span.file.name
    if path.is_relative_to(library_folder()) and path.is_file():
        raise Refused(f"`{wanted.name}` is declared in the library")


def rename(snapshots: Sequence[Snapshot], wanted: Declaration, name: str) -> dict[Snapshot, list[Span]]:
    """The places to change in each text. Raises Refused."""
    check_renamable(wanted)
    if not _NAME.fullmatch(name):
        raise Refused(f"`{name}` is no name: names are letters, digits and `_`")
    if name in vocabulary().words or name in ("time", "world"):
        raise Refused(f"`{name}` is a word of the language")
    if wanted.kind not in ("loop variable", "argument") and (name in TYPES or name in CONSTANTS):
        raise Refused(f"`{name}` is a word of the language")
    changes = {each: spans for each in snapshots if (spans := references([each], wanted))}
    for snapshot, spans in changes.items():
        if snapshot.file.name == wanted.span.file.name:
            _check(snapshot, spans, wanted, name)
    return changes


def _check(snapshot: Snapshot, spans: list[Span], wanted: Declaration, name: str) -> None:
    """The text after the change names the declaration at the same places and has no new errors."""
    after = Snapshot(snapshot.file.name, changed(snapshot.text, spans, name), snapshot.version)
    shift = len(name) - len(wanted.name)
    expected = [span.start + k * shift for k, span in enumerate(sorted(spans, key=lambda span: span.start))]
    others = {each.span.start for each in snapshot.occurrences if each.span.text == name}
    found = [each.span.start for each in after.occurrences if each.span.text == name]
    moved = {start + shift * sum(span.start < start for span in spans) for start in others}
    if sorted(found) != sorted({*expected, *moved}) or _resolved(after, found, expected) is None:
        raise Refused(f"`{name}` has another meaning where `{wanted.name}` stands")
    before, then = _errors(snapshot), _errors(after)
    if then > before:
        raise Refused(f"with the name `{name}` the model has errors")


def _resolved(after: Snapshot, found: Iterable[int], expected: list[int]) -> object | None:
    """The one declaration that the changed places mean, and no other place; None where there is not one."""
    meant: dict[int, object] = {}
    for each in after.occurrences:
        if each.span.start in found and each.declaration is not None:
            meant[each.span.start] = each.declaration.place
    places = {meant.get(start) for start in expected}
    if len(places) != 1 or None in places:
        return None
    (place,) = places
    return place if {start for start, other in meant.items() if other == place} == set(expected) else None


def _errors(snapshot: Snapshot) -> int:
    return sum(each.severity is Severity.ERROR for each in findings(snapshot))


def changed(text: str, spans: Iterable[Span], name: str) -> str:
    """The text with `name` at the places."""
    for span in sorted(spans, key=lambda span: span.start, reverse=True):
        text = text[: span.start] + name + text[span.end :]
    return text
