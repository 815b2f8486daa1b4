"""Tables in files: results as CSV or Parquet, inputs from CSV. A file appears whole or not at all."""

from __future__ import annotations

import csv
import os
import tempfile
from collections.abc import Callable
from io import StringIO
from pathlib import Path
from typing import TypeAlias

import numpy as np

from lagdsl.diagnostics import Label, Sink
from lagdsl.simulate.trajectory import Trajectory
from lagdsl.source import SourceFile, Span

# (times, values) by name of the input.
Tables: TypeAlias = dict[str, tuple[list[float], list[float]]]
_LARGEST_INPUT = 200_000_000


def write_table(trajectory: Trajectory, path: Path, sink: Sink | None = None) -> None:
    """Write all columns in SI units to `path`: Parquet if it ends so, else CSV. E0825 and E0826 where that cannot be
    done; without a sink these raise CompilationFailed."""
    own = Sink() if sink is None else sink
    try:
        _atomically(path, lambda draft: _write(trajectory, path.suffix == ".parquet", draft))
    except ModuleNotFoundError as missing:
        own.report("E0825", None, what=f"writing `{path.name}`", package=missing.name or "pyarrow")
    except OSError as error:
        own.report("E0826", None, file=path, reason=error.strerror or str(error))
    if sink is None:
        own.raise_if_errors()


def _write(trajectory: Trajectory, parquet: bool, draft: Path) -> None:
    if parquet:
        _write_parquet(trajectory, draft)
    else:
        draft.write_text(csv_text(trajectory), encoding="utf-8", newline="")


def csv_text(trajectory: Trajectory) -> str:
    """Header and rows; every number in the shortest form that reads back as the same float."""
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(trajectory.names)
    writer.writerows(zip(*(column.values.tolist() for column in trajectory.columns), strict=True))
    return text.getvalue()


def _write_parquet(trajectory: Trajectory, draft: Path) -> None:
    import pyarrow
    import pyarrow.parquet

    fields = [pyarrow.field(c.name, pyarrow.float64(), metadata={"unit": c.unit}) for c in trajectory.columns]
    table = pyarrow.table([column.values for column in trajectory.columns], schema=pyarrow.schema(fields))
    pyarrow.parquet.write_table(table, draft)


def _atomically(path: Path, write: Callable[[Path], None]) -> None:
    """Write beside the file and put the result in its place; nothing is left behind if that fails."""
    handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    os.close(handle)
    draft = Path(name)
    try:
        write(draft)
        draft.chmod(0o666 & ~_umask())
        draft.replace(path)
    finally:
        draft.unlink(missing_ok=True)


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


# ---- reading
# ---------------------------------------------------------------------------------------------------------


def read_inputs(path: Path, sink: Sink) -> Tables | None:
    """Columns of a CSV file that has a column `time`; every fault is reported with its line (E0820 to E0824,
    E0827)."""
    try:
        if path.stat().st_size > _LARGEST_INPUT:
            raise OSError(0, f"larger than {_LARGEST_INPUT // 1_000_000} MB")
        text = path.read_text(encoding="utf-8-sig")
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "not UTF-8 text"
        sink.report("E0820", None, file=path, reason=reason)
        return None
    return parse_inputs(SourceFile(str(path), text.replace("\r\n", "\n").replace("\r", "\n")), sink)


def parse_inputs(file: SourceFile, sink: Sink) -> Tables | None:
    """The same for a text."""
    before = len(sink.diagnostics)
    numbered = [(n, file.line(n).split(",")) for n in range(1, len(file.line_starts) + 1) if file.line(n).strip()]
    names = [cell.strip().strip('"') for cell in numbered[0][1]] if numbered else []
    if "time" not in names:
        span = _line_span(file, numbered[0][0]) if numbered else None
        sink.report("E0821", span, file=file.name, column="time")
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


def _row(file: SourceFile, line: int, cells: list[str], names: list[str], sink: Sink) -> list[float]:
    """Numbers of one line; the faults of the file's first lines are all reported, each once."""
    if len(cells) != len(names):
        sink.report("E0824", _line_span(file, line), line=line, found=len(cells), expected=len(names))
        return [np.nan] * len(names)
    numbers = []
    offset = file.line_starts[line - 1]
    for name, cell in zip(names, cells, strict=True):
        number = _number(cell)
        if number is None:
            # An empty cell is shown by the comma before it.
            span = Label(Span(file, offset if cell else max(offset - 1, 0), offset + len(cell)))
            sink.report("E0823", span, text=cell.strip()[:40], line=line, column=name)
        numbers.append(np.nan if number is None else number)
        offset += len(cell) + 1
    return numbers


def _number(cell: str) -> float | None:
    try:
        number = float(cell.strip().strip('"'))
    except ValueError:
        return None
    return number if np.isfinite(number) else None


def _line_span(file: SourceFile, line: int) -> Span:
    start = file.line_starts[line - 1]
    return Span(file, start, start + max(len(file.line(line)), 1))
