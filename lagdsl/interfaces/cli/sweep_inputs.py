"""`--input` of `lag sweep`: values, ranges and lists by name, tables in files, and patterns of files."""

from __future__ import annotations

from glob import glob, has_magic
from pathlib import Path
from typing import TYPE_CHECKING

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import record
from lagdsl.interfaces.cli.inputs import Inputs, inputs_or_leave
from lagdsl.interfaces.cli.model_file import Format
from lagdsl.interfaces.cli.options import InputOptions
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.failure import SettingError
from lagdsl.motion.signals.inputs import Signal

if TYPE_CHECKING:
    from lagdsl.motion.sweep.plan import Axis


@record()
class SweptInputs:
    """`shared` are the tables that all runs have, `values` texts of values, ranges, lists and distributions by name;
    each of `patterns` has its files with their tables."""

    shared: Inputs
    values: dict[str, str]
    patterns: list[dict[Path, Inputs]]

    @property
    def names(self) -> list[str]:
        """All inputs that are given."""
        tables = [next(iter(files.values())).tables for files in self.patterns]
        return [*self.shared.tables, *self.values, *(name for each in tables for name in each)]

    def of(self, flat: FlatModel, sink: Sink, style: Format) -> tuple[dict[str, Signal], list[Axis]]:
        """Tables of all runs, and an axis for each pattern; leaves with status 1 where units do not fit."""
        from lagdsl.motion.sweep.values import axis_of_tables, labels_of

        axes = []
        for place, files in enumerate(self.patterns, 1):
            tables = [each.of(flat, sink, style) for each in files.values()]
            name = "input" if len(self.patterns) == 1 else f"input[{place}]"
            axes.append(axis_of_tables(name, labels_of(list(files)), tables))
        return self.shared.of(flat, sink, style), axes


def swept_inputs_or_leave(options: InputOptions, style: Format) -> SweptInputs:
    """Leaves with status 2 where a file cannot be read. Raises SettingError for a pattern that no file matches, for
    files of a pattern that have not the same inputs, and for an input that is given twice."""
    patterns = [text for text in options.given if _is_pattern(text)]
    alone = InputOptions(given=tuple(t for t in options.given if t not in patterns), held=options.held)
    given = inputs_or_leave(alone, style)
    found: list[dict[Path, Inputs]] = []
    names = [*given.tables, *given.values]
    for pattern in patterns:
        files = {path: _file(path, options.held, style) for path in _matching(pattern)}
        own = _common_names(pattern, files)
        twice = [name for name in own if name in names]
        if twice:
            raise SettingError(f"--input {pattern}: `{twice[0]}` is given twice")
        names += own
        found.append(files)
    return SweptInputs(Inputs(given.tables, {}, options.held), given.values, found)


def _is_pattern(text: str) -> bool:
    """A file may be called like a pattern; a value has an equals sign."""
    try:
        return "=" not in text and has_magic(text) and not Path(text).exists()
    except (OSError, ValueError):  # no file has such a name: it is too long, or holds a zero
        return False


def _matching(pattern: str) -> list[Path]:
    matching = sorted(glob(pattern, recursive=True))  # noqa: PTH207  `Path.glob` takes no absolute pattern
    found = [path for path in map(Path, matching) if path.is_file()]
    if not found:
        raise SettingError(f"--input {pattern}: no file matches this pattern")
    return found


def _file(path: Path, held: bool, style: Format) -> Inputs:
    return inputs_or_leave(InputOptions(given=(str(path),), held=held), style)


def _common_names(pattern: str, files: dict[Path, Inputs]) -> list[str]:
    """The inputs that every file has."""
    first = next(iter(files))
    names = list(files[first].tables)
    for path, each in files.items():
        other = [name for name in (*names, *each.tables) if (name in each.tables) != (name in names)]
        if other:
            has, lacks = (first, path) if other[0] in names else (path, first)
            raise SettingError(
                f"--input {pattern}: {has} has a column `{other[0]}`, {lacks} has none; all files need the same columns"
            )
    return names
