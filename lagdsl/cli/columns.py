"""Columns of numbers in files: results as CSV or Parquet, inputs from CSV."""

from __future__ import annotations

import csv
from itertools import pairwise
from pathlib import Path

import click
import numpy as np
from numpy.typing import NDArray

from lagdsl.cli.output import whole_file
from lagdsl.simulate.trajectory import Trajectory

Floats = NDArray[np.float64]


def write_columns(trajectory: Trajectory, path: Path) -> None:
    """CSV, or Parquet where the name ends in `.parquet`; the file appears whole."""
    with whole_file(path) as draft:
        if path.suffix == ".parquet":
            _write_parquet(trajectory, draft)
        else:
            _write_csv(trajectory, draft)


def require_parquet(path: Path | None) -> None:
    """Fail early where a Parquet file is asked for and its library is missing."""
    if path is None or path.suffix != ".parquet":
        return
    from importlib.util import find_spec

    if find_spec("pyarrow") is None:
        raise click.UsageError("Parquet files need pyarrow: pip install 'lagdsl[table]', or write a .csv")


def _write_csv(trajectory: Trajectory, path: Path) -> None:
    """Header and rows; numbers in their shortest form that reads back as the same float."""
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(trajectory.names)
        writer.writerows(zip(*(column.values.tolist() for column in trajectory.columns), strict=True))


def _write_parquet(trajectory: Trajectory, path: Path) -> None:
    import pyarrow
    import pyarrow.parquet

    fields = [pyarrow.field(c.name, pyarrow.float64(), metadata={"unit": c.unit}) for c in trajectory.columns]
    table = pyarrow.table([c.values for c in trajectory.columns], schema=pyarrow.schema(fields))
    pyarrow.parquet.write_table(table, path)


def read_inputs(path: Path) -> dict[str, tuple[list[float], list[float]]]:
    """Signals by name from a CSV file whose first column is `time`."""
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            rows = [row for row in csv.reader(file) if row]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise click.UsageError(f"cannot read {path}: {reason}") from error
    if not rows or rows[0][0].strip() != "time" or len(rows[0]) < 2:
        raise click.UsageError(f"{path}: the first line must name the columns: time and one for each input")
    header = [name.strip() for name in rows[0]]
    numbers = [_numbers(path, line, row, len(header)) for line, row in enumerate(rows[1:], 2)]
    if len(numbers) < 2:
        raise click.UsageError(f"{path}: at least two rows of numbers are needed")
    times = [row[0] for row in numbers]
    for line, (before, after) in enumerate(pairwise(times), 3):
        if after < before:
            raise click.UsageError(f"{path}:{line}: time must not run backwards")
    return {name: (times, [row[index] for row in numbers]) for index, name in enumerate(header) if index}


def _numbers(path: Path, line: int, row: list[str], width: int) -> list[float]:
    if len(row) != width:
        raise click.UsageError(f"{path}:{line}: {len(row)} entries, the header has {width}")
    try:
        numbers = [float(entry) for entry in row]
    except ValueError as error:
        raise click.UsageError(f"{path}:{line}: {error}") from error
    if not np.all(np.isfinite(numbers)):
        raise click.UsageError(f"{path}:{line}: entries must be finite numbers")
    return numbers
