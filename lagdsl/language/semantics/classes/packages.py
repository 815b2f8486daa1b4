"""Packages that are folders: a name is known by its file, the file is read when the name is first asked for.

`Lag.Planar.Revolute` is the class in `Lag/Planar/Revolute.lag`, which begins with `within Lag.Planar;`. The doc of a
folder, its constants, types, functions and small classes stand in its `package.lag`. Top-level packages and classes
lie beside the file, in the folders of LAGPATH or in the installed library.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from dataclasses import field
from pathlib import Path
from typing import TypeAlias

from lagdsl.foundation import resources
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import mutable_record, record
from lagdsl.foundation.source import SourceFile, Span
from lagdsl.language.semantics.classes.library import item_of
from lagdsl.language.semantics.scope import prelude
from lagdsl.language.semantics.scope.scope import ClassSymbol, Entry, FunctionSymbol, Outside, Scope, TypeSymbol
from lagdsl.language.semantics.scope.values import POISON
from lagdsl.language.syntax import nodes

_PACKAGE_FILE = "package.lag"
Fill: TypeAlias = Callable[[Scope, nodes.Class], None]


@record()
class Place:
    """A folder that holds top-level packages; `words` say where it is, `shown` is how its files are called."""

    folder: Path
    words: str
    shown: str


@mutable_record()
class Folder:
    """The classes and packages in the files of one folder; `within` is empty where they are top-level ones."""

    library: Library
    place: Place
    within: tuple[str, ...]
    scope: Scope
    listing: dict[str, bool] | None = None
    known: dict[str, Entry | None] = field(default_factory=dict)

    def find(self, name: str, span: Span | None) -> Entry | None:
        if name not in self.known:
            is_folder = self.list().get(name)
            self.known[name] = None  # what asks for itself while it is read is not there yet
            self.known[name] = None if is_folder is None else self._read(name, is_folder, span)
        return self.known[name]

    def names(self) -> Iterator[str]:
        yield from self.list()

    def list(self) -> dict[str, bool]:
        """The names in their order, with whether they are folders; a file goes before a folder of the same name."""
        if self.listing is None:
            self.listing = {}
            for name in _sorted_names(self.place.folder):
                stem, dot, end = name.partition(".")
                if not dot and (self.place.folder / stem / _PACKAGE_FILE).is_file():
                    self.listing.setdefault(stem, True)
                elif end == "lag" and stem != "package":
                    self.listing[stem] = False
        return self.listing

    def searched(self, name: str) -> str:
        """The files searched here, in words."""
        if (self.place.folder / name).is_dir():
            return f"the folder `{name}` in {self.place.words} is not a package: it has no `{_PACKAGE_FILE}`"
        return f"looked for `{name}.lag` and `{name}/{_PACKAGE_FILE}` in {self.place.words}"

    def _read(self, name: str, is_folder: bool, span: Span | None) -> Entry:
        path = self.place.folder / (f"{name}/{_PACKAGE_FILE}" if is_folder else f"{name}.lag")
        shown = _joined(self.place.shown, str(path.relative_to(self.place.folder)))
        found = item_of(self.library.sink, path, shown, (*self.within, name), is_folder, span)
        if found is None:
            return POISON
        unit, item = found
        around = Scope("file", "this file", self.scope, self.scope.prefix)
        self.library.imports(around, unit.items)
        if isinstance(item, nodes.Function):
            return FunctionSymbol(item, around)
        if isinstance(item, nodes.TypeDefinition):
            return TypeSymbol(item, around)
        assert isinstance(item, nodes.Class | nodes.ShortClass), item
        symbol = ClassSymbol(item, around)
        around.entries[name] = symbol
        self.known[name] = symbol  # packages may import one another: it is known before it is filled
        if isinstance(item, nodes.Class) and item.kind == "package":
            symbol.inner = Scope(
                "file", f"package `{'.'.join((*self.within, name))}`", around, f"{around.prefix}{name}."
            )
            if is_folder:
                inside = Place(path.parent, self.place.words, _joined(self.place.shown, name))
                symbol.inner.outside.files = Folder(self.library, inside, (*self.within, name), symbol.inner)
            self.library.fill(symbol.inner, item)
        return symbol


@mutable_record()
class Roots:
    """The top-level names of several folders: the first that has a name wins."""

    folders: tuple[Folder, ...]

    def find(self, name: str, span: Span | None) -> Entry | None:
        for folder in self.folders:
            found = folder.find(name, span)
            if found is not None:
                return found
        return None

    def names(self) -> Iterator[str]:
        for folder in self.folders:
            yield from folder.names()

    def places(self, name: str) -> tuple[str, ...]:
        return tuple(folder.searched(name) for folder in self.folders)


@mutable_record()
class FileRoot:
    """Top-level names for the imports of a file: its own classes, then what lies elsewhere."""

    scope: Scope
    roots: Roots

    def find(self, name: str, span: Span | None) -> Entry | None:
        return self.scope.entries.get(name) or self.roots.find(name, span)

    def names(self) -> Iterator[str]:
        yield from self.scope.entries
        yield from self.roots.names()

    def places(self, name: str) -> tuple[str, ...]:
        return ("looked for in this file", *self.roots.places(name))


@mutable_record()
class Packages:
    """The packages among top-level names: they are known without an import, unless the language has the name."""

    roots: Roots

    def find(self, name: str, span: Span | None) -> Entry | None:
        if name in prelude.TYPES or name in prelude.CONSTANTS:
            return None
        entry = self.roots.find(name, span)
        return entry if isinstance(entry, ClassSymbol) and entry.inner is not None else None

    def names(self) -> Iterator[str]:
        yield from self.roots.names()


class Library:
    """Packages that one flattening has read from files.

    `fill` declares the contents of a package in its scope, `imports` the imports among items.
    """

    def __init__(self, sink: Sink, fill: Fill, imports: Callable[[Scope, Iterable[nodes.Item]], None]) -> None:
        self.sink = sink
        self.fill = fill
        self.imports = imports
        self.tops: dict[Path, Folder] = {}
        self.installed: tuple[Folder, ...] = ()
        self.installed = tuple(self.top(place) for place in _installed())

    def top(self, place: Place) -> Folder:
        """The folder as one of top-level packages, which know one another and what is installed."""
        folder = self.tops.get(place.folder)
        if folder is None:
            folder = self.tops[place.folder] = Folder(self, place, (), Scope("file", "the library"))
            folder.scope.outside.root = roots = self.roots(folder)
            folder.scope.outside.files = Packages(roots)
        return folder

    def roots(self, own: Folder | None) -> Roots:
        """Folders in which a top-level name is looked up: that of the file first, then the installed library."""
        first = () if own is None else (own,)
        return Roots((*first, *(folder for folder in self.installed if folder is not own)))

    def place(self, scope: Scope, unit: nodes.Unit) -> None:
        """Set what lies around the scope of a file: the package it is `within`, then what is installed.

        E0255 where that package is neither that of the folders around the file nor installed.
        """
        if unit.within is None:
            roots = self.roots(None)
            scope.parent = Scope("file", "the library", outside=Outside(files=Packages(roots)))
            own = beside(unit.span.file)
            scope.outside.root = FileRoot(scope, self.roots(self.top(own) if own is not None else None))
            return
        parts = unit.within.parts
        own = beside(unit.span.file, len(parts))
        entry: Entry | None = None
        for roots in (self.roots(self.top(own) if own is not None else None), self.roots(None)):
            entry = roots.find(parts[0], unit.within.span)
            for part in parts[1:]:
                entry = entry.inner.find(part) if isinstance(entry, ClassSymbol) and entry.inner is not None else None
            if isinstance(entry, ClassSymbol) and entry.inner is not None:
                break
        if isinstance(entry, ClassSymbol) and entry.inner is not None:
            scope.parent, scope.prefix = entry.inner, entry.inner.prefix
        else:
            if entry is None:
                self.sink.report("E0255", unit.within.span, name=".".join(parts))
            library = Outside(files=Packages(self.roots(None)), root=self.roots(None))
            scope.parent = Scope("file", "the library", outside=library)


def _installed() -> tuple[Place, ...]:
    """The folders of LAGPATH in their order, then the library that comes with the compiler."""
    listed = [folder for folder in os.environ.get("LAGPATH", "").split(os.pathsep) if folder]
    own = Place(resources.library_folder(), "the library", "")
    return (*(Place(Path(folder), f"`{folder}` (LAGPATH)", folder) for folder in listed), own)


def beside(file: SourceFile, above: int = 0) -> Place | None:
    """The folder of a file, or the one that many folders above it; None for a text that is no file."""
    if file.name.startswith("<"):
        return None
    folder = file.folder
    for _ in range(above):
        folder = folder / ".." if folder.name in ("", "..") else folder.parent
    return Place(folder, "the folder of the file", str(folder))


def _sorted_names(folder: Path) -> list[str]:
    try:
        return sorted(path.name for path in folder.iterdir())
    except OSError:
        return []


def _joined(folder: str, name: str) -> str:
    return name if folder in ("", ".") else f"{folder}/{name}"
