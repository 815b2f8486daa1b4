"""Tables in files: results as CSV or Parquet, inputs from CSV. A file appears whole or not at all."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterable
from functools import partial
from importlib.util import find_spec
from io import StringIO
from pathlib import Path
from typing import TypeAlias

import numpy as np

from lagdsl.diagnostics import Label, Sink
from lagdsl.signals.trajectory import Trajectory
from lagdsl.source import SourceFile, Span
from lagdsl.source.whole_file import whole_file

# (times, values) by name of the input.
Tables: TypeAlias = dict[str, tuple[list[float], list[float]]]
_LARGEST_INPUT = 200_000_000
_PARQUET = ".parquet"


def has_writer(path: Path, sink: Sink) -> bool:
    """True if tables can be written in the form that the ending of `path` asks for; it is worth asking before a long
    run. E0825: Parquet needs pyarrow. E0828: neither `.csv` nor `.parquet`; without an ending, as devices are, it is
    CSV."""
    ending = path.suffix.lower()
    if ending == _PARQUET and find_spec("pyarrow") is None:
        sink.report("E0825", None, what=f"writing `{path.name}`", package="pyarrow")
        return False
    if ending not in ("", ".csv", _PARQUET):
        sink.report("E0828", None, file=path.name)
        return False
    return True


def write_table(trajectory: Trajectory, path: Path, sink: Sink | None = None) -> None:
    """Write all columns in SI units to `path`: Parquet if it ends so, else CSV. E0825, E0826 and E0828 where that
    cannot be done; without a sink these raise CompilationFailed."""
    own = Sink() if sink is None else sink
    if has_writer(path, own):
        form = _write_parquet if path.suffix.lower() == _PARQUET else _write_csv
        _write(path, own, partial(form, trajectory))
    if sink is None:
        own.raise_if_errors()


def write_events(trajectory: Trajectory, path: Path, sink: Sink) -> None:
    """Write what happened to `path` as CSV: time [s], kind, name. E0826 where that cannot be done."""
    _write(path, sink, partial(_write_events, trajectory))


def _write(path: Path, sink: Sink, write: Callable[[Path], object]) -> None:
    """`write` to a draft that becomes the file; E0826 where that cannot be done."""
    try:
        with whole_file(path) as draft:
            write(draft)
    except BrokenPipeError:  # the reader has gone, which is no fault of the table
        raise
    except OSError as error:
        sink.report("E0826", None, file=path, reason=error.strerror or str(error))


def _write_csv(trajectory: Trajectory, draft: Path) -> None:
    draft.write_text(csv_text(trajectory), encoding="utf-8", newline="")


def _write_events(trajectory: Trajectory, draft: Path) -> None:
    draft.write_text(events_text(trajectory), encoding="utf-8", newline="")


def csv_text(trajectory: Trajectory) -> str:
    """Header and rows; every number in the shortest form that reads back as the same float."""
    return _csv(trajectory.names, zip(*(column.values.tolist() for column in trajectory.columns), strict=True))


def events_text(trajectory: Trajectory) -> str:
    """The same of the events."""
    return _csv(("time", "kind", "name"), ((event.time, event.kind, event.name) for event in trajectory.events))


def _csv(header: Iterable[str], rows: Iterable[Iterable[object]]) -> str:
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(header)
    writer.writerows(rows)
    return text.getvalue()


def _write_parquet(trajectory: Trajectory, draft: Path) -> None:
    import pyarrow
    import pyarrow.parquet

    fields = [pyarrow.field(c.name, pyarrow.float64(), metadata={"unit": c.unit}) for c in trajectory.columns]
    table = pyarrow.table([column.values for column in trajectory.columns], schema=pyarrow.schema(fields))
    pyarrow.parquet.write_table(table, draft)


# ---- reading ---------------------------------------------------------------------------------------------------------


def read_inputs(path: Path, sink: Sink) -> Tables | None:
    """Columns of a CSV file that has a column `time`; every fault is reported with its line (E0820 to E0824, E0827,
    E0829)."""
    try:
        with path.open("rb") as file:
            content = file.read(_LARGEST_INPUT + 1)  # a device without end is no danger
        if len(content) > _LARGEST_INPUT:
            raise OSError(0, f"larger than {_LARGEST_INPUT // 1_000_000} MB")
        text = content.decode("utf-8-sig")
    except (OSError, ValueError) as error:  # ValueError: a name that no file can have
        reason = error.strerror if isinstance(error, OSError) else "not UTF-8 text"
        sink.report("E0820", None, file=path, reason=reason)
        return None
    return parse_inputs(SourceFile(str(path), text.replace("\r\n", "\n").replace("\r", "\n")), sink)


def parse_inputs(file: SourceFile, sink: Sink) -> Tables | None:
    """The same for a text."""
    before = len(sink.diagnostics)
    numbered = [(n, _cells(line)) for n, line in enumerate(file.text.split("\n"), 1) if line.strip()]
    names = [cell.strip() for cell in numbered[0][1]] if numbered else []
    _check_names(file, numbered[0][0] if numbered else None, names, sink)
    if len(sink.diagnostics) > before:
        return None
    rows = [_row(file, line, cells, names, sink) for line, cells in numbered[1:]]
    if len(rows) < 2:
        sink.report("E0827", None, file=file.name, found=len(rows))
    if len(sink.diagnostics) > before:
        return None
    table = np.array(rows)
    times = table[:, names.index("time")]
    backward = np.flatnonzero(np.diff(times) < 0.0)
    if len(backward):
        line = numbered[int(backward[0]) + 2][0]
        sink.report("E0822", _line_span(file, line), line=line)
        return None
    return {name: (times.tolist(), table[:, i].tolist()) for i, name in enumerate(names) if name != "time"}


def _check_names(file: SourceFile, line: int | None, names: list[str], sink: Sink) -> None:
    span = None if line is None else _line_span(file, line)
    if "time" not in names:
        sink.report("E0821", span, file=file.name, column="`time`")
    elif len(names) == 1:
        sink.report("E0821", span, file=file.name, column="of an input")
    for name in dict.fromkeys(names):
        if names.count(name) > 1:
            sink.report("E0829", span, file=file.name, column=name)


def _cells(line: str) -> list[str]:
    """Cells of one line as they stand; quotes, which may hide a comma as in `"u[1,2]"`, are taken off."""
    if '"' not in line:
        return line.split(",")
    cells: list[str] = next(csv.reader([line], skipinitialspace=True))
    return cells


def _row(file: SourceFile, line: int, cells: list[str], names: list[str], sink: Sink) -> list[float]:
    """Numbers of one line; the faults of the file's first lines are all reported, each once."""
    if len(cells) != len(names):
        sink.report("E0824", _line_span(file, line), line=line, found=len(cells), expected=len(names))
        return [np.nan] * len(names)
    numbers = [_number(cell) for cell in cells]
    for index, number in enumerate(numbers):
        if number is None:
            place = Label(_cell_span(file, line, cells, index))
            sink.report("E0823", place, text=cells[index].strip()[:40], line=line, column=names[index])
    return [np.nan if number is None else number for number in numbers]


def _cell_span(file: SourceFile, line: int, cells: list[str], index: int) -> Span:
    """An empty cell is shown by the comma before it, a cell of a line with quotes by the whole line."""
    if ",".join(cells) != file.line(line):
        return _line_span(file, line)
    start = file.line_starts[line - 1] + sum(len(cell) + 1 for cell in cells[:index])
    return Span(file, start if cells[index] else max(start - 1, 0), start + len(cells[index]))


def _number(cell: str) -> float | None:
    try:
        number = float(cell)
    except ValueError:
        return None
    return number if np.isfinite(number) and "_" not in cell else None


def _line_span(file: SourceFile, line: int) -> Span:
    start = file.line_starts[line - 1]
    return Span(file, start, start + max(len(file.line(line)), 1))
