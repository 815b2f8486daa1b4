"""A CSV file as a header with units and rows of cells; faults are told with their places."""

from __future__ import annotations

import csv
import re
from pathlib import Path

import numpy as np

from lagdsl.foundation.diagnostics import Label, Sink
from lagdsl.foundation.source import SourceFile, Span
from lagdsl.foundation.units.parse import parse_unit

_MOST_BYTES = 200_000_000
TRUTHS = {"true": 1.0, "false": 0.0}
_WITH_UNIT = re.compile(r"(.*\S)\s+\[([^\[\]]+)\]")


def read_file(path: Path, sink: Sink, *, span: Span | None = None, way: str | None = None) -> SourceFile | None:
    """The text at `path`; E0820 at `span` where it cannot be read, with `way` as its help."""
    try:
        with path.open("rb") as file:
            content = file.read(_MOST_BYTES + 1)  # a device without end is no danger
        if len(content) > _MOST_BYTES:
            raise OSError(0, f"larger than {_MOST_BYTES // 1_000_000} MB")
        text = content.decode("utf-8-sig")
    except (OSError, ValueError) as error:  # ValueError: a name that no file can have
        reason = error.strerror if isinstance(error, OSError) else "not UTF-8 text"
        sink.report("E0820", span, file=path, reason=reason, help=way)
        return None
    return SourceFile(str(path), text.replace("\r\n", "\n").replace("\r", "\n"))


def numbered_rows(file: SourceFile) -> list[tuple[int, list[str]]]:
    """Lines that are not empty as their number and cells; the first one is the header."""
    return [(n, _cells(line)) for n, line in enumerate(file.text.split("\n"), 1) if line.strip()]


def head_of(cell: str) -> tuple[str, str]:
    """Name and unit of `tau [N.m]`; `tau[1]` is a name."""
    found = _WITH_UNIT.fullmatch(cell.strip())
    return (found[1], found[2].strip()) if found else (cell.strip(), "")


def in_si_units(values: list[float], unit: str) -> list[float]:
    """From `unit` to SI."""
    if not unit:
        return values
    definition = parse_unit(unit)
    converted: list[float] = (np.array(values) * definition.factor + definition.offset).tolist()
    return converted


def _cells(line: str) -> list[str]:
    """Cells of one line as they stand; quotes, which may hide a comma as in `"u[1,2]"`, are taken off."""
    if '"' not in line:
        return line.split(",")
    cells: list[str] = next(csv.reader([line], skipinitialspace=True))
    return cells


def numbers_of_row(file: SourceFile, line: int, cells: list[str], names: list[str], sink: Sink) -> list[float]:
    """Numbers of one line; the faults of the file's first lines are all reported, each once."""
    if not _is_whole(file, line, cells, names, sink):
        return [np.nan] * len(names)
    return [_reported(file, line, cells, names, index, sink) for index in range(len(names))]


def numbers_of_column(
    file: SourceFile, rows: list[tuple[int, list[str]]], names: list[str], index: int, sink: Sink
) -> list[float]:
    """Numbers of one column; other columns may hold anything. E0823, E0824."""
    numbers = []
    for line, cells in rows:
        if not _is_whole(file, line, cells, names, sink):
            return []
        if cells[index].strip().lower() in TRUTHS:
            _report_cell(file, line, cells, names, index, sink)
        numbers.append(_reported(file, line, cells, names, index, sink))
    return numbers


def _is_whole(file: SourceFile, line: int, cells: list[str], names: list[str], sink: Sink) -> bool:
    if len(cells) == len(names):
        return True
    sink.report("E0824", line_span(file, line), line=line, found=len(cells), expected=len(names))
    return False


def _reported(file: SourceFile, line: int, cells: list[str], names: list[str], index: int, sink: Sink) -> float:
    number = _number(cells[index])
    if number is None:
        _report_cell(file, line, cells, names, index, sink)
        return np.nan
    return number


def _report_cell(file: SourceFile, line: int, cells: list[str], names: list[str], index: int, sink: Sink) -> None:
    place = Label(cell_span(file, line, cells, index))
    sink.report("E0823", place, text=cells[index].strip()[:40], line=line, column=names[index])


def cell_span(file: SourceFile, line: int, cells: list[str], index: int) -> Span:
    """An empty cell is shown by the comma before it, a cell of a line with quotes by the whole line."""
    if ",".join(cells) != file.line(line):
        return line_span(file, line)
    start = file.line_starts[line - 1] + sum(len(cell) + 1 for cell in cells[:index])
    return Span(file, start if cells[index] else max(start - 1, 0), start + len(cells[index]))


def _number(cell: str) -> float | None:
    truth = TRUTHS.get(cell.strip().lower())
    if truth is not None:
        return truth
    try:
        number = float(cell)
    except ValueError:
        return None
    return number if np.isfinite(number) and "_" not in cell else None


def line_span(file: SourceFile, line: int) -> Span:
    start = file.line_starts[line - 1]
    return Span(file, start, start + max(len(file.line(line)), 1))
