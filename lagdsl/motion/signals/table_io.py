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

from lagdsl.foundation.columns.csv_file import (
    TRUTHS,
    cell_span,
    head_of,
    in_si_units,
    line_span,
    numbered_rows,
    numbers_of_row,
    read_file,
)
from lagdsl.foundation.diagnostics import Label, Sink
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile
from lagdsl.foundation.source.whole_file import whole_file
from lagdsl.foundation.units.dimension import TIME
from lagdsl.foundation.units.naming import describe
from lagdsl.foundation.units.parse import UnknownUnit, counts_otherwise, parse_unit
from lagdsl.language.flat.model import FlatModel, Input
from lagdsl.motion.signals.hold import Hold
from lagdsl.motion.signals.inputs import Signal
from lagdsl.motion.signals.parquet import write_columns
from lagdsl.motion.signals.trajectory import Trajectory


@record()
class Table:
    """A column of a file over its times [s], in the unit of its header; without one in SI units. `words` is the first
    cell that is `true` or `false`: its place, text and line."""

    times: list[float]
    values: list[float]
    unit: str = ""
    words: tuple[Label, str, int] | None = None


Tables: TypeAlias = dict[str, Table]  # by name of the input
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


def write_table(trajectory: Trajectory, path: Path, sink: Sink | None = None, *, units: bool = False) -> None:
    """Write all columns in SI units to `path`: Parquet if it ends so, else CSV, with `units` in its header. E0825,
    E0826 and E0828 where that cannot be done; without a sink these raise CompilationFailed."""
    own = Sink() if sink is None else sink
    if has_writer(path, own):
        parquet = path.suffix.lower() == _PARQUET
        _write(path, own, partial(_write_parquet, trajectory) if parquet else partial(_write_csv, trajectory, units))
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


def _write_csv(trajectory: Trajectory, units: bool, draft: Path) -> None:
    draft.write_text(csv_text(trajectory, units=units), encoding="utf-8", newline="")


def _write_events(trajectory: Trajectory, draft: Path) -> None:
    draft.write_text(events_text(trajectory), encoding="utf-8", newline="")


def csv_text(trajectory: Trajectory, *, units: bool = False) -> str:
    """Header, on request with units, and rows; every number in the shortest form that reads back as the same float."""
    header = [with_unit(column.name, column.unit) if units else column.name for column in trajectory.columns]
    return _csv(header, zip(*(column.values.tolist() for column in trajectory.columns), strict=True))


def with_unit(name: str, unit: str) -> str:
    """`theta [rad]`; the name alone of what has no unit."""
    return name if unit in ("", "1") else f"{name} [{unit}]"


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
    columns = {column.name: column.values for column in trajectory.columns}
    write_columns(columns, {column.name: column.unit for column in trajectory.columns}, trajectory.model, draft)


# ---- reading ---------------------------------------------------------------------------------------------------------


def read_inputs(path: Path, sink: Sink, *, way: str | None = None) -> Tables | None:
    """Columns of a CSV file that has a column `time`; every fault is reported with its line (E0820 to E0824, E0827,
    E0829). `way` is what helps where there is no such file."""
    file = read_file(path, sink, way=way)
    return None if file is None else parse_inputs(file, sink)


def parse_inputs(file: SourceFile, sink: Sink) -> Tables | None:
    """The same for a text."""
    before = len(sink.diagnostics)
    numbered = numbered_rows(file)
    heads = [head_of(cell) for cell in numbered[0][1]] if numbered else []
    names = [name for name, _ in heads]
    first = numbered[0][0] if numbered else None
    _check_names(file, first, names, sink)
    _check_units(file, first, heads, sink)
    if len(sink.diagnostics) > before:
        return None
    rows = [numbers_of_row(file, line, cells, names, sink) for line, cells in numbered[1:]]
    if len(rows) < 2:
        sink.report("E0827", None, file=file.name, found=len(rows))
    if len(sink.diagnostics) > before:
        return None
    table = np.array(rows)
    times = table[:, names.index("time")]
    backward = np.flatnonzero(np.diff(times) < 0.0)
    if len(backward):
        line = numbered[int(backward[0]) + 2][0]
        sink.report("E0822", line_span(file, line), line=line)
        return None
    seconds = in_si_units(times.tolist(), dict(heads)["time"])
    words = [_words(file, numbered[1:], i) for i in range(len(heads))]
    return {
        name: Table(seconds, table[:, i].tolist(), unit, words[i])
        for i, (name, unit) in enumerate(heads)
        if name != "time"
    }


def in_si(tables: Tables, flat: FlatModel, sink: Sink, *, hold: bool = False) -> dict[str, Signal]:
    """The tables as inputs of this model; with `hold` they keep their values between the rows. E0878 for a unit that is
    none of the input, E0823 for truths in the column of a number."""
    inputs = {item.name: item for item in flat.inputs}
    found: dict[str, Signal] = {}
    for name, table in tables.items():
        why = _misfit(table.unit, inputs[name]) if table.unit and name in inputs else ""
        if why:
            sink.report("E0878", None, name=name, unit=table.unit, why=why)
        if table.words and name in inputs and inputs[name].base != "Boolean":
            place, text, line = table.words
            sink.report("E0823", place, text=text, line=line, column=name)
        values = in_si_units(table.values, table.unit)
        found[name] = Hold(table.times, values) if hold else (table.times, values)
    return found


def _misfit(unit: str, item: Input) -> str:
    """Why the values of an input cannot be in `unit`, or nothing."""
    definition = parse_unit(unit)
    if definition.dimension != item.dimension:
        return f"`{item.name}` is {describe(item.dimension)} [{item.unit}]"
    if definition.shift != 0 and item.type_name == "TemperatureDifference":
        return f"`{item.name}` is a difference of temperatures; give it in K"
    return counts_otherwise(unit, item.unit)


def _words(file: SourceFile, rows: list[tuple[int, list[str]]], index: int) -> tuple[Label, str, int] | None:
    for line, cells in rows:
        text = cells[index].strip()
        if text.lower() in TRUTHS:
            return Label(cell_span(file, line, cells, index)), text, line
    return None


def _check_names(file: SourceFile, line: int | None, names: list[str], sink: Sink) -> None:
    span = None if line is None else line_span(file, line)
    if "time" not in names:
        sink.report("E0821", span, file=file.name, column="`time`")
    elif len(names) == 1:
        sink.report("E0821", span, file=file.name, column="of an input")
    for name in dict.fromkeys(names):
        if names.count(name) > 1:
            sink.report("E0829", span, file=file.name, column=name)


def _check_units(file: SourceFile, line: int | None, heads: list[tuple[str, str]], sink: Sink) -> None:
    """E0878 for what is no unit, and for a time that is none."""
    for name, unit in heads:
        try:
            why = "that is no time" if name == "time" and unit and parse_unit(unit).dimension != TIME else ""
            parse_unit(unit)
        except UnknownUnit as error:
            why = str(error)
        if why and line is not None:
            sink.report("E0878", line_span(file, line), name=name, unit=unit, why=why)
