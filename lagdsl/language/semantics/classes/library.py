"""Reads model texts from files; those of libraries once per process."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from lagdsl.foundation.diagnostics import Diagnostic, Label, Sink
from lagdsl.foundation.diagnostics.suggest import nearest
from lagdsl.foundation.source import SourceFile, Span
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.limits import MAX_CHARACTERS
from lagdsl.language.syntax.parser import parse

_MAX_BYTES = 4 * MAX_CHARACTERS  # a character of UTF-8 takes at most four


def read_source(path: Path, sink: Sink) -> SourceFile | None:
    """The text of a file, its line ends normalised to `\\n` and a byte order mark removed.

    Reports to `sink` and returns None if the file is no model text: an invalid name, a directory, no permission, too
    large (no more than the limit is read), not UTF-8, the character NUL.
    """
    return _read(path, str(path), sink)


def _read(path: Path, name: str, sink: Sink) -> SourceFile | None:
    content = _content(path, name, sink)
    if content is None:
        return None
    if len(content) > _MAX_BYTES:
        sink.report("E0130", None, name=name, limit=MAX_CHARACTERS)
        return None
    try:
        text = content.decode("utf-8")
    except UnicodeDecodeError as fault:
        sink.report("E0131", None, name=name, position=fault.start)
        return None
    if "\0" in text:
        sink.report("E0136", None, name=name, position=text.index("\0"))
        return None
    return SourceFile(name, text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n"))


def _content(path: Path, name: str, sink: Sink) -> bytes | None:
    """At most one byte more than the limit, so that a device without end is no danger."""
    try:
        if path.is_dir():
            sink.report("E0132", None, name=name)
            return None
        with path.open("rb") as file:
            return file.read(_MAX_BYTES + 1)
    except FileNotFoundError:
        sink.report("E0133", None, name=name, help=_nearest_file(path))
    except (OSError, ValueError) as fault:  # ValueError: a name that no file can have
        reason = fault.strerror if isinstance(fault, OSError) and fault.strerror else str(fault)
        sink.report("E0134", None, name=name, reason=reason)
    return None


def _nearest_file(path: Path) -> str | None:
    """Help that proposes the file of the same folder with the most similar name."""
    try:
        stems = {file.stem for file in path.parent.iterdir() if file.suffix == ".lag" and file.is_file()}
    except OSError:
        return None
    meant = path.stem if path.stem in stems else nearest(path.stem, stems)
    return f"did you mean `{path.with_name(meant + '.lag')}`?" if meant else None


# Trees by path, with time and size of the file when it was read and what was found in it.
_TREES: dict[tuple[str, str], tuple[tuple[int, int], nodes.Unit | None, tuple[Diagnostic, ...]]] = {}


_HELD: dict[str, str] = {}


def hold(texts: Mapping[str, str]) -> None:
    """Read the files at these paths as an editor holds them, all others as they were saved."""
    for path in _HELD.keys() - texts.keys():
        _HELD.pop(path, None)
    _HELD.update(texts)


def item_of(
    sink: Sink, path: Path, shown: str, name: tuple[str, ...], is_folder: bool, span: Span | None
) -> tuple[nodes.Unit, nodes.Item] | None:
    """The file `path` of a library and the class, function or type of the full name `name` that it must hold alone.

    None after errors: those of the file itself, E0253 where it holds something else, E0254 where it is of another
    package. `span` is the place that needs it.
    """
    unit, found = _tree(path, shown)
    because = () if span is None else (Label(span, f"needs `{'.'.join(name)}`"),)
    for diagnostic in found:
        sink.add(replace(diagnostic, labels=(*diagnostic.labels, *because)))
    if unit is None:
        return None
    items = [item for item in unit.items if not isinstance(item, nodes.Import)]
    wrong = next((item for item in items if not _is_named(item, name[-1], is_folder)), None)
    if wrong is not None or len(items) != 1:
        place = item_head(wrong or items[-1]) if items else unit.span
        sink.report("E0253", place, *because, file=shown, name=name[-1], what="package" if is_folder else "class")
        return None
    around = unit.within.parts if unit.within is not None else ()
    if around != name[:-1]:
        place = unit.within.span if unit.within is not None else item_head(items[0])
        sink.report("E0254", place, *because, file=shown, expected=_within(name[:-1]))
        return None
    return unit, items[0]


def _tree(path: Path, shown: str) -> tuple[nodes.Unit | None, tuple[Diagnostic, ...]]:
    """The tree of a library file, parsed again only when the file has changed, and what was found in it."""
    held = _HELD.get(str(path))
    try:
        status = path.stat()
        state = (status.st_mtime_ns, status.st_size) if held is None else (hash(held), -1)
    except OSError:
        state = (0, 0)
    known = _TREES.get((str(path), shown))
    if known is None or known[0] != state:
        sink = Sink()
        file = _read(path, shown, sink) if held is None else SourceFile(shown, held)
        unit = parse(file, sink) if file is not None else None
        known = _TREES[str(path), shown] = (state, unit, sink.diagnostics)
    return known[1], known[2]


def _is_named(item: nodes.Item, name: str, package: bool) -> bool:
    if package:
        return isinstance(item, nodes.Class) and item.kind == "package" and item.name == name
    named = (nodes.Class, nodes.ShortClass, nodes.TypeDefinition, nodes.Function)
    return isinstance(item, named) and item.name == name


def item_head(item: nodes.Item) -> Span:
    """The name of a class; else the first line of an item."""
    if isinstance(item, nodes.Class):
        return item.name_span
    length = len(item.span.text.partition("\n")[0])
    return Span(item.span.file, item.span.start, item.span.start + length)


def _within(parts: tuple[str, ...]) -> str:
    return f"must begin with `within {'.'.join(parts)};`" if parts else "is of the top level: no `within`"
