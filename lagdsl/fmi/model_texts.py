"""The texts that a model was read from: its own, and those of packages that do not come with the compiler."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path, PurePosixPath

from lagdsl.flat.model import FlatModel
from lagdsl.flat.quantity import Item
from lagdsl.source import SourceFile

_OURS = "Lag/"
_PACKAGE = "package.lag"


def model_texts(flat: FlatModel, source: SourceFile) -> dict[str, str]:
    """By paths that lie to each other as the files do: the model, the packages that it needs beside it."""
    path = Path(source.name)
    texts = {path.name if path.suffix == ".lag" else "model.lag": source.text}
    for file in _files(flat):
        if file is not source and file.name != source.name and not file.name.startswith(_OURS):
            inside = PurePosixPath(*(part for part in Path(file.name).parts if part not in ("/", "..")))
            texts |= _packages(path.parent, inside)
            texts[str(inside)] = file.text
    return texts


def _files(flat: FlatModel) -> list[SourceFile]:
    """Those of which something stands in the flat model, in its order."""
    parts = [getattr(flat, each.name) for each in fields(flat)]
    items = [item for part in parts if isinstance(part, tuple) for item in part if isinstance(item, Item)]
    return list({id(span.file): span.file for item in items for span in item.spans}.values())


def _packages(folder: Path, inside: PurePosixPath) -> dict[str, str]:
    """The files `package.lag` around a file of a package that lies in this folder."""
    found = {}
    for parent in reversed(inside.parents[:-1]):
        file = folder / parent / _PACKAGE
        if file.is_file():
            found[str(parent / _PACKAGE)] = file.read_text(encoding="utf-8")
    return found
