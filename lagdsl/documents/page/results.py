"""A page of rows from a file, as `lag run -o` writes them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from lagdsl.documents.page.head import head_of
from lagdsl.documents.page.runs import Run, page_of_runs
from lagdsl.documents.plot.picture.recording import Prepared, parameters_of, prepare, recording_of
from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.foundation.columns.csv_file import in_si_units
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.diagnostics.suggest import did_you_mean, listing
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.source import SourceFile
from lagdsl.foundation.units.parse import parse_unit
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.aliases import results_names
from lagdsl.motion.analysis.point import Point
from lagdsl.motion.signals.table_io import Tables, read_inputs
from lagdsl.motion.signals.trajectory import Column, Trajectory
from lagdsl.motion.simulate.table import heads_of

_MOST_ROWS = 4000
_NEEDED = {"coordinate": "coordinates", "rate": "rates", "state": "states", "discrete": "discrete variables"}


def results_page(
    flat: FlatModel, path: Path, wishes: Wishes, *, source: SourceFile | None = None, sink: Sink | None = None
) -> str:
    """The page of recorded rows: nothing is integrated. `wishes.parameters` are those of the run.

    Columns of the file are found by name, in any unit of their quantity; outputs that it holds are shown as they stand
    there, all others are computed from the state of the row. Raises ValueError for a file that is none of this model,
    CompilationFailed for one that cannot be read.
    """
    own = Sink() if sink is None else sink
    tables = read_inputs(path, own)
    if tables is None:
        own.raise_if_errors()
        raise ValueError(f"{path.name} holds no rows")
    prepared = prepare(flat)
    known = results_names(prepared.own)
    tables = {known.get(name, name): table for name, table in tables.items()}
    times, values = _checked(prepared.own, tables, path.name)
    if len(times) > _MOST_ROWS:  # thinned evenly; the last row stays
        kept = np.unique(np.linspace(0, len(times) - 1, _MOST_ROWS).round().astype(int))
        times, values = times[kept], {name: each[kept] for name, each in values.items()}
    p = parameters_of(prepared.engine.layout, Wishes(parameters=wishes.parameters))
    events = np.unique(times[1:][np.diff(times) == 0.0]).tolist()  # times that stand in two rows: before and after one
    made = recording_of(prepared, _points(prepared, times, values, p), "file", events)
    motion = _as_recorded(prepared, made.motion, values)
    said = f"Recorded in {path.name}; nothing is integrated here."
    if flat.inputs:
        said += " Inputs are not in the file: loads that read them have their default values."
    head = head_of(replace(made, motion=motion, ended=said), Wishes(parameters=wishes.parameters), source)
    run = Run(label=path.name, motion=motion, span=made.span, said=said)
    return page_of_runs(flat, head, [run])


def _checked(flat: FlatModel, tables: Tables, file: str) -> tuple[Floats, dict[str, Floats]]:
    """Times, and columns in SI units by name. Raises ValueError."""
    heads = {name: (unit, kind) for name, unit, kind, _ in heads_of(flat)}
    for name in tables:
        if name not in heads:
            hint = did_you_mean(name, heads, f"{flat.name} has {listing(name, list(heads)[1:])}")
            raise ValueError(f"{file}: {flat.name} has no column `{name}`; {hint}")
    for name, (_, kind) in heads.items():
        if kind in _NEEDED and name not in tables:
            raise ValueError(f"{file} has no column `{name}`: a row needs all {_NEEDED[kind]} of {flat.name}")
    values = {}
    for name, table in tables.items():
        if table.unit and parse_unit(table.unit).dimension != parse_unit(heads[name][0]).dimension:
            raise ValueError(f"{file}: `{name}` is in {heads[name][0]}, the file has it in {table.unit}")
        values[name] = np.array(in_si_units(list(table.values), table.unit))
    return np.array(next(iter(tables.values())).times, dtype=np.float64), values


def _points(prepared: Prepared, times: Floats, values: Mapping[str, Floats], p: Floats) -> list[Point]:
    heads, count = heads_of(prepared.own), len(prepared.engine.layout.discretes)
    q, qd, z, known = (
        np.array([values[name] for name, _, k, _ in heads if k == kind]).reshape(-1, len(times)).T for kind in _NEEDED
    )
    t = float(times[0])
    u = prepared.engine.evaluate("start", t, p)[3]
    w = np.tile(prepared.engine.evaluate("discrete_start", t, p)[0] if count else np.zeros(0), (len(times), 1))
    w[:, : known.shape[1]] = known
    rows = zip(times.tolist(), q, qd, z, w, strict=True)
    return [Point(t=t, q=q, qd=qd, z=z, u=u, w=w, p=p) for t, q, qd, z, w in rows]


def _as_recorded(prepared: Prepared, motion: Trajectory, values: Mapping[str, Floats]) -> Trajectory:
    """With the outputs of the file in place of computed ones. Outputs that it lacks are left open where a row does not
    determine them, with inputs and with relations that have a memory."""
    own = {output.name for output in prepared.own.outputs}
    open_ = bool(prepared.own.inputs) or len(prepared.engine.layout.discretes) > len(prepared.own.events.discretes)

    def recorded(column: Column) -> Column:
        if column.name not in own:
            return column
        if column.name in values:
            return replace(column, values=values[column.name])
        return replace(column, values=np.full(len(motion), np.nan)) if open_ else column

    return replace(motion, columns=tuple(map(recorded, motion.columns)))
