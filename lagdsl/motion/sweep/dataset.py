"""The outcomes of a sweep as one labelled dataset, and that in a file."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.foundation.source.whole_file import whole_file
from lagdsl.foundation.version import __version__
from lagdsl.motion.signals.parquet import require_parquet, write_frame
from lagdsl.motion.signals.table_io import with_unit
from lagdsl.motion.sweep.plan import Axis, Plan
from lagdsl.motion.sweep.run import Outcome

if TYPE_CHECKING:
    import xarray

STATUS, MESSAGE, TABLES = "status of the run", "why it failed", "tables of inputs"
ENDINGS = (".nc", ".parquet", ".csv")
_LARGEST_VARIABLE = 2**31 - 4  # bytes, of the classic format, which SciPy writes


def dataset(plan: Plan, times: Floats, outcomes: Iterable[Outcome], *, model: str) -> xarray.Dataset:
    """Every column over the axes of the plan, `sample` and `time`; `status`, `message` and `ended` [s] of every run.

    Quantities that the plan set are coordinates, with their units. Rows after the end of a run that failed, and columns
    that a model lacks, are nan. A name that the model has itself ends in `_`.
    """
    found = collect(plan.runs, len(times), outcomes)
    taken = {*found.columns, *(axis.name for axis in (*plan.axes, *plan.samples, *plan.fixed))}
    sample = free_name("sample", taken)
    dims = (*(axis.name for axis in plan.axes), *((sample,) if plan.samples else ()))
    coordinates: dict[str, Any] = {axis.name: _coordinate(axis, (axis.name,)) for axis in plan.axes}
    coordinates |= {axis.name: _coordinate(axis, (sample,)) for axis in plan.samples}
    coordinates |= {axis.name: _coordinate(axis, ()) for axis in plan.fixed}
    if plan.samples:
        coordinates[sample] = ((sample,), np.arange(plan.shape[-1]))
    return _labelled(found, times, dict(zip(dims, plan.shape, strict=True)), coordinates, model)


def dataset_of_runs(
    found: Collected, times: Floats, settings: Mapping[str, Floats], units: Mapping[str, str], *, model: str
) -> xarray.Dataset:
    """The same over `run` and `time`; `settings` (runs,) are coordinates of the runs."""
    run = free_name("run", {*found.columns, *settings})
    coordinates: dict[str, Any] = {name: ((run,), each, {"units": units[name]}) for name, each in settings.items()}
    coordinates[run] = ((run,), np.arange(len(found.ended)))
    return _labelled(found, times, {run: len(found.ended)}, coordinates, model)


def _labelled(
    found: Collected, times: Floats, sizes: dict[str, int], coordinates: dict[str, Any], model: str
) -> xarray.Dataset:
    """Every column over the dimensions of `sizes` and the time."""
    import xarray

    taken = {*found.columns, *coordinates}
    time, dims, shape = free_name("time", taken), tuple(sizes), tuple(sizes.values())
    data: dict[str, Any] = {
        name: ((*dims, time), values.reshape(*shape, len(times)), {"units": found.units[name]})
        for name, values in found.columns.items()
    }
    data[free_name("status", taken)] = (dims, np.array(found.status).reshape(shape), {"long_name": STATUS})
    data[free_name("message", taken)] = (dims, np.array(found.message).reshape(shape), {"long_name": MESSAGE})
    data[free_name("ended", taken)] = (dims, found.ended.reshape(shape), {"units": "s", "long_name": "end of the run"})
    every = {**coordinates, time: ((time,), times, {"units": "s"})}
    return xarray.Dataset(data, every, {"model": model, "lagdsl": __version__})


def about_runs(data: xarray.Dataset, long_name: str) -> list[str]:
    """STATUS or MESSAGE of all runs, the last axis fastest."""
    (found,) = (v for v in data.data_vars.values() if v.attrs.get("long_name") == long_name)
    return [str(text) for text in found.values.ravel()]


def require_writer(path: Path) -> None:
    """Raise ValueError for an ending that is none of ENDINGS, ModuleNotFoundError where a package is missing."""
    if path.suffix.lower() not in ENDINGS:
        raise ValueError(f"{path.name}: sweeps are written as {', '.join(ENDINGS)}")
    if path.suffix.lower() == ".parquet":
        require_parquet()


def require_room(runs: int, rows: int, columns: int, path: Path | None) -> None:
    """Raise ValueError for a dataset of 8-byte numbers that this machine, or the file format, cannot hold."""
    column = 8 * runs * rows
    memory = _memory()
    if memory is not None and columns * column > memory:
        raise ValueError(
            f"the results would take {columns * column / 1e9:.3g} GB, this machine has {memory / 1e9:.3g} GB: "
            "ask for fewer runs, fewer rows or fewer columns"
        )
    if path is not None and path.suffix.lower() == ".nc" and column > _LARGEST_VARIABLE:
        raise ValueError(
            f"{path.name}: a column would take {column / 1e9:.3g} GB, NetCDF holds {_LARGEST_VARIABLE / 1e9:.3g} GB: "
            "ask for fewer runs or rows, or for .parquet"
        )


def write(data: xarray.Dataset, path: Path, *, units: bool = False) -> None:
    """NetCDF with all dimensions, or a table with a row for every run and time; `units` asks for names of columns as in
    `theta [rad]` in CSV. Raises OSError."""
    with whole_file(path) as draft:
        if path.suffix.lower() == ".nc":
            data.to_netcdf(draft)
            return
        table = data.to_dataframe().reset_index()
        known = {str(name): str(each.attrs["units"]) for name, each in data.variables.items() if "units" in each.attrs}
        if path.suffix.lower() == ".parquet":
            write_frame(table, known, str(data.attrs["model"]), draft)
            return
        if units:
            table = table.rename(columns={name: with_unit(name, unit) for name, unit in known.items()})
        table.to_csv(draft, index=False, lineterminator="\n")


def _memory() -> int | None:
    """Bytes of memory of this machine; None where the system does not tell."""
    try:
        return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, ValueError, OSError):
        return None


@record(kw_only=True)
class Collected:
    """Columns (runs, rows) and their units by name; status, message and end of every run. `derivatives` (runs, rows,
    tangents) by the name of the column, where they are asked for."""

    columns: dict[str, Floats]
    units: dict[str, str]
    status: list[str]
    message: list[str]
    ended: Floats
    derivatives: dict[str, Floats] = field(default_factory=dict)


def collect(runs: int, rows: int, outcomes: Iterable[Outcome]) -> Collected:
    """Results of all runs; missing values are nan."""
    columns: dict[str, Floats] = {}
    units: dict[str, str] = {}
    derivatives: dict[str, Floats] = {}
    tables: dict[tuple[str, ...], Floats] = {}  # columns that come together, in one array
    status, message, ended = ["missing"] * runs, [""] * runs, np.full(runs, np.nan)
    for outcome in outcomes:
        status[outcome.index], message[outcome.index] = outcome.status, outcome.message
        ended[outcome.index] = outcome.ended
        names, at = outcome.names, (outcome.index, slice(len(outcome.values)))
        if names not in tables and columns.keys().isdisjoint(names):
            tables[names] = np.full((len(names), runs, rows), np.nan)
            columns |= zip(names, tables[names], strict=True)
            units |= zip(names, outcome.units, strict=True)
        if names in tables:
            tables[names][:, *at] = outcome.values.T
        else:
            for i, name in enumerate(names):
                if name not in columns:
                    columns[name], units[name] = np.full((runs, rows), np.nan), outcome.units[i]
                columns[name][at] = outcome.values[:, i]
        if outcome.derivatives is not None:
            for i, name in enumerate(names):
                if name not in derivatives:
                    derivatives[name] = np.full((runs, rows, outcome.derivatives.shape[1]), np.nan)
                derivatives[name][at] = outcome.derivatives[:, :, i]
    return Collected(columns=columns, units=units, status=status, message=message, ended=ended, derivatives=derivatives)


def _coordinate(axis: Axis, dims: tuple[str, ...]) -> tuple[tuple[str, ...], Any, dict[str, str]]:
    """Without dimensions the single value."""
    about = {"long_name": TABLES} if axis.labels else {"units": axis.unit}
    values = axis.labels or axis.values
    return dims, np.array(values if dims else values[0]), about


def free_name(name: str, taken: set[str]) -> str:
    """`name`, or `name_` where it is taken."""
    return free_name(f"{name}_", taken) if name in taken else name
