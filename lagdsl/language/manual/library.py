"""Classes of the component library by name, with the classes that they extend."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.diagnostics.suggest import nearest
from lagdsl.foundation.record import record
from lagdsl.foundation.resources import library_folder
from lagdsl.language.semantics.classes.library import read_source
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.parser import parse


class UnknownClass(LookupError):  # noqa: N818 named after what it says
    """The library has no class of this name; `suggestion` is the nearest name or None."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.name = name
        short = {full.rpartition(".")[2] for full in class_names()}
        self.suggestion = nearest(name.rpartition(".")[2], short)

    def __str__(self) -> str:
        text = f"the library has no class `{self.name}`"
        return text if self.suggestion is None else f"{text}; did you mean `{self.suggestion}`?"


@record()
class LibraryClass:
    """A class with its full name, `Lag.Electrical.DCMotor`."""

    name: str
    node: nodes.Class | nodes.ShortClass

    @property
    def package(self) -> str:
        return self.name.rpartition(".")[0]


def class_names() -> tuple[str, ...]:
    """Full names of all classes, packages of constants and types aside, by the alphabet."""
    root = library_folder()
    files = sorted(path for path in root.rglob("*.lag") if path.name != "package.lag")
    return tuple(".".join(path.relative_to(root).with_suffix("").parts) for path in files)


def package_names() -> tuple[str, ...]:
    """Full names of the packages that hold classes, by the alphabet."""
    return tuple(sorted({name.rpartition(".")[0] for name in class_names()}))


def matching(name: str) -> tuple[str, ...]:
    """Full names that end with `name`: `Revolute` fits two. Raises UnknownClass where none does."""
    found = tuple(full for full in class_names() if f".{full}".endswith(f".{name}"))
    if not found:
        raise UnknownClass(name)
    return found


def classes_on(topic: str) -> tuple[str, ...]:
    """Full names of the classes that have the word `topic` in their name or their text."""
    word = re.compile(rf"\b{re.escape(topic)}\b", re.IGNORECASE)
    return tuple(
        full
        for full in class_names()
        if topic.lower() in full.rpartition(".")[2].lower() or word.search(library_class(full).node.doc or "")
    )


@cache
def library_class(name: str) -> LibraryClass:
    """The class of the full name `name`."""
    item = _item(library_folder().joinpath(*name.split(".")).with_suffix(".lag"))
    assert isinstance(item, nodes.Class | nodes.ShortClass), name
    return LibraryClass(name, item)


def package_title(name: str) -> str:
    """The doc string of the package `name`."""
    item = _item(library_folder().joinpath(*name.split("."), "package.lag"))
    assert isinstance(item, nodes.Class), name
    return item.doc or ""


def lineage(found: LibraryClass) -> Iterator[tuple[LibraryClass, tuple[nodes.AnyModifier, ...]]]:
    """The class behind the ones that it extends, the most basic one first, each with the modifiers it gets."""
    match found.node:
        case nodes.ShortClass(base=base, modifiers=modifiers):
            yield from _bases(found, base, modifiers)
        case nodes.Class(items=items):
            for item in items:
                if isinstance(item, nodes.Extends):
                    yield from _bases(found, item.base, item.modifiers)
    yield found, ()


def _bases(
    found: LibraryClass, base: nodes.Name, modifiers: tuple[nodes.AnyModifier, ...]
) -> Iterator[tuple[LibraryClass, tuple[nodes.AnyModifier, ...]]]:
    for ancestor, inner in lineage(library_class(_full_name(found, base))):
        yield ancestor, (*inner, *modifiers)


def _full_name(found: LibraryClass, name: nodes.Name) -> str:
    """The name of a base as the library has it: of the same package, or in full."""
    written = ".".join(name.parts)
    return written if written.startswith("Lag.") else f"{found.package}.{written}"


def _item(path: Path) -> nodes.Item:
    """The only class of a file of the library, which parses."""
    sink = Sink()
    source = read_source(path, sink)
    unit = None if source is None else parse(source, sink)
    assert unit is not None, sink.diagnostics
    return unit.items[-1]
