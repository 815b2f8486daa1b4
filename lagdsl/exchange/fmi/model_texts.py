"""The texts that a model was read from: its own, and those of packages that do not come with the compiler."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path

from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.flat.quantity import Item

_OURS = "Lag/"
_PACKAGE = "package.lag"


def model_texts(flat: FlatModel, source: SourceFile) -> dict[str, str]:
    """By path: the model, and beside it the packages of which something stands in it, where an import finds them."""
    path = Path(source.name)
    texts = {path.name if path.suffix == ".lag" else "model.lag": source.text}
    for file in files_of(flat):
        if file is not source and file.name != source.name and not file.name.startswith(_OURS):
            texts |= _packages(Path(file.name))
            texts[_inside(Path(file.name))] = file.text
    return texts


def files_of(flat: FlatModel) -> list[SourceFile]:
    """The files that contributed to the flat model, in its order."""
    parts = [getattr(flat, each.name) for each in fields(flat)]
    items = [item for part in parts if isinstance(part, tuple) for item in part if isinstance(item, Item)]
    return list({id(span.file): span.file for item in items for span in item.spans}.values())


def _inside(file: Path) -> str:
    """The path of a file in the folder that holds its outermost package."""
    return file.relative_to(_root(file)).as_posix()


def _root(file: Path) -> Path:
    """The nearest folder around it that is no package."""
    return next(folder for folder in file.parents if not (folder / _PACKAGE).is_file())


def _packages(file: Path) -> dict[str, str]:
    """Texts of the package files around a file, outermost first."""
    root = _root(file)
    around = [folder / _PACKAGE for folder in reversed(file.parents) if root in folder.parents]
    return {_inside(each): each.read_text(encoding="utf-8") for each in around}
