"""docs/reference/library.md lists every class of the library; LAGDSL_UPDATE=1 rewrites the list."""

from __future__ import annotations

import os
from pathlib import Path

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.resources import library_folder
from lagdsl.language.semantics.classes.library import read_source
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.parser import parse

HEAD = "Generated from the doc comments by `make update`.\n"


def item(path: Path) -> nodes.Item:
    sink = Sink()
    source = read_source(path, sink)
    assert source is not None
    unit = parse(source, sink)
    assert unit is not None, sink.diagnostics
    return unit.items[-1]


def cell(text: str | None) -> str:
    return (text or "").replace("|", "\\|")


def row(found: nodes.Item) -> str:
    match found:
        case nodes.ShortClass():
            return f"| `{found.name}` | {cell(found.doc)}{'; ' if found.doc else ''}as `{'.'.join(found.base.parts)}` |"
        case nodes.Component(declarators=(declarator,), type_name=kind):
            return f"| `{declarator.name}` | {'.'.join(kind.parts)}: {cell(declarator.doc)} |"
        case nodes.TypeDefinition(base=nodes.Name(parts=parts)):
            return f"| `{found.name}` | {'.'.join(parts)} {cell(attributes(found))} |"
        case nodes.Class():
            title = " ".join((*found.prefixes, found.kind))
            return f"| `{found.name}` | {cell(found.doc)}{'' if title in ('model', 'block') else f' ({title})'} |"
        case _:
            return f"| `{getattr(found, 'name', '')}` | {cell(getattr(found, 'doc', None))} |"


def attributes(found: nodes.TypeDefinition) -> str:
    texts = [modifier.span.text for modifier in found.modifiers]
    return f"({', '.join(texts)})" + (f": {found.doc}" if found.doc else "")


def listed() -> str:
    lines: list[str] = []
    for folder in sorted(path.parent for path in (library_folder() / "Lag").glob("*/package.lag")):
        package = item(folder / "package.lag")
        assert isinstance(package, nodes.Class)
        files = [item(path) for path in sorted(folder.glob("*.lag")) if path.name != "package.lag"]
        inside = [inner for inner in package.items if not isinstance(inner, nodes.Import | nodes.Annotation)]
        lines += ["", f"### Lag.{package.name}", "", f"{package.doc}.", "", "| name | what it is |", "|---|---|"]
        lines += [row(found) for found in (*inside, *files)]
    return "\n".join(lines) + "\n"


def test_the_page_lists_every_class(root: Path) -> None:
    page = root / "docs" / "reference" / "library.md"
    head = page.read_text(encoding="utf-8").partition(HEAD)[0] + HEAD
    if os.environ.get("LAGDSL_UPDATE"):
        page.write_text(head + listed(), encoding="utf-8")
    assert page.read_text(encoding="utf-8") == head + listed()
