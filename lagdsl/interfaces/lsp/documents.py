"""The texts that are open, and those beside them in the folders of the workspace."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from lsprotocol import types as lsp

from lagdsl.foundation.diagnostics import Diagnostic, Sink
from lagdsl.interfaces.lsp.deep import Depth
from lagdsl.interfaces.lsp.findings import Memory
from lagdsl.interfaces.lsp.positions import name_of_uri
from lagdsl.interfaces.lsp.snapshot import Snapshot
from lagdsl.language.semantics.classes.library import read_source

_MOST_FILES = 2000  # of the folders of a workspace


class Document:
    """One open text: its last version, and the last findings, which may be of an earlier one."""

    def __init__(self, uri: str, text: str, version: int) -> None:
        self.uri = uri
        self.snapshot = Snapshot(name_of_uri(uri), text, version)
        self.checked: Snapshot | None = None  # the last one whose findings are told
        self.found: tuple[Diagnostic, ...] = ()
        self.whole: str | None = None  # the last text that was understood
        self.memory = Memory()
        self.depth: Depth | None = None
        self.depth_of: Snapshot | None = None

    def change(self, text: str, version: int) -> None:
        self.snapshot = Snapshot(self.snapshot.file.name, text, version)

    def refresh(self) -> None:
        """Look at the same text anew: a file that it needs has changed."""
        self.memory = Memory()
        self.snapshot = Snapshot(self.snapshot.file.name, self.snapshot.text, self.snapshot.version)

    def with_values(self) -> Snapshot:
        """The last version; where its models are not known yet, with the flat models of the last one that has them."""
        if not self.snapshot.flats and self.checked is not None:
            self.snapshot.flats.update(self.checked.flats)
        return self.snapshot


class Documents:
    """Open texts by their addresses."""

    def __init__(self) -> None:
        self.open: dict[str, Document] = {}
        self.folders: list[Path] = []
        self._read: dict[Path, tuple[tuple[int, int], Snapshot]] = {}

    def held(self) -> dict[str, str]:
        """The last texts that were understood, by the paths of their files: what a key breaks is told there alone."""
        documents = list(self.open.values())
        return {each.snapshot.file.name: each.whole for each in documents if each.whole is not None}

    def naming(self, document: Document) -> list[Document]:
        """Other open texts with the name of this file, or of a folder around it: those that may import it."""
        path = Path(document.snapshot.file.name)
        names = (path.stem, *(folder.name for folder in path.parents if (folder / "package.lag").is_file()))
        word = re.compile(rf"\b(?:{'|'.join(map(re.escape, names))})\b")
        others = [each for each in list(self.open.values()) if each is not document]
        return [each for each in others if word.search(each.snapshot.text)]

    def of(self, identifier: lsp.TextDocumentIdentifier) -> Document | None:
        return self.open.get(identifier.uri)

    def texts(self, containing: str = "") -> Iterator[Snapshot]:
        """The open texts and the other files of the workspace that hold `containing`."""
        names = set()
        for document in list(self.open.values()):
            names.add(document.snapshot.file.name)
            yield document.snapshot
        for path in self._files():
            if str(path) not in names:
                snapshot = self._snapshot(path)
                if snapshot is not None and containing in snapshot.text:
                    yield snapshot

    def _files(self) -> Iterator[Path]:
        """The files of the workspace's folders, and those beside open texts."""
        own = [each.snapshot.file.folder for each in self.open.values() if each.uri.startswith("file:")]
        seen: set[Path] = set()
        for folder, pattern in [*((f, "**/*.lag") for f in self.folders), *((f, "*.lag") for f in own)]:
            for path in sorted(folder.glob(pattern)) if folder.is_dir() else ():
                if path not in seen and len(seen) < _MOST_FILES:
                    seen.add(path)
                    yield path

    def _snapshot(self, path: Path) -> Snapshot | None:
        """A file that is not open, parsed again only when it has changed."""
        try:
            status = path.stat()
        except OSError:
            return None
        state = status.st_mtime_ns, status.st_size
        known = self._read.get(path)
        if known is None or known[0] != state:
            source = read_source(path, Sink())
            if source is None:
                return None
            known = self._read[path] = state, Snapshot(str(path), source.text, 0)
        return known[1]
