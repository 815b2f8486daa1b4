"""Measured runs: columns over time, or times of events, from files or arrays."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from lagdsl.foundation.columns.csv_file import head_of, in_si_units, numbered_rows, numbers_of_row, read_file
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.diagnostics.suggest import did_you_mean, listing
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.foundation.units.dimension import TIME, Dimension
from lagdsl.foundation.units.naming import describe
from lagdsl.foundation.units.parse import UnknownUnit, counts_otherwise, parse_unit
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.signals.hold import Hold
from lagdsl.motion.signals.inputs import Signal
from lagdsl.motion.signals.table_io import parse_inputs
from lagdsl.motion.simulate.table import called_heads

_TIME = "time"


@record(kw_only=True)
class Series:
    """Values that were measured at `times` [s], in SI units of the column `name`; of an event the times themselves,
    one after the other, and `times` are then those."""

    name: str
    times: Floats
    values: Floats
    event: bool = False


@record(kw_only=True)
class Measured:
    """One run: what was measured, and the tables of inputs that were recorded with it."""

    name: str
    series: tuple[Series, ...]
    inputs: Mapping[str, Signal]


@record(kw_only=True)
class Reading:
    """Meaning of columns: `renamed` has names of the model by names of columns, None for those that are left
    out. With `hold` inputs keep their values between the rows."""

    flat: FlatModel
    renamed: Mapping[str, str | None]
    sink: Sink
    hold: bool = False

    def run(self, name: str, data: Any) -> Measured:
        """From a path, or from columns by name that are arrays in SI units. Faults go to the sink."""
        columns = self._file(Path(data)) if isinstance(data, (str, Path)) else _arrays(name, data)
        return self._measured(name, columns)

    def _file(self, path: Path) -> dict[str, tuple[Floats, str]]:
        file = read_file(path, self.sink)
        if file is None:
            return {}
        numbered = numbered_rows(file)
        heads = [head_of(cell) for cell in numbered[0][1]] if numbered else []
        if _TIME in dict(heads):
            tables = parse_inputs(file, self.sink) or {}
            found = {column: (np.array(table.values), table.unit) for column, table in tables.items()}
            first = next(iter(tables.values()), None)
            return {} if first is None else {_TIME: (np.array(first.times), ""), **found}
        names = [column for column, _ in heads]
        rows = [numbers_of_row(file, line, cells, names, self.sink) for line, cells in numbered[1:]]
        if not rows or self.sink.has_errors:
            self.sink.report("E0827", None, file=file.name, found=len(rows))
            return {}
        return {column: (np.array(rows)[:, k], unit) for k, (column, unit) in enumerate(heads)}

    def _measured(self, name: str, columns: Mapping[str, tuple[Floats, str]]) -> Measured:
        series: list[Series] = []
        inputs: dict[str, Signal] = {}
        events = events_of(self.flat)
        heads = called_heads(self.flat)
        items = {item.name: item for item in self.flat.inputs}
        times = columns[_TIME][0] if _TIME in columns else None
        for column, (values, unit) in columns.items():
            meant = self.renamed.get(column, column)
            if column == _TIME or meant is None:
                continue
            if times is None and meant in events:
                seconds = self._in_si(column, values, unit or "s", TIME, "s")
                series.append(Series(name=meant, times=seconds, values=seconds, event=True))
            elif times is not None and meant in items:
                item = items[meant]
                found = self._in_si(column, values, unit, item.dimension, item.unit)
                table = (times.tolist(), found.tolist())
                inputs[meant] = Hold(*table) if self.hold else table
            elif times is not None and meant in heads and meant != _TIME:
                own = heads[meant][1]
                found = self._in_si(column, values, unit, parse_unit(own).dimension, own)
                series.append(Series(name=meant, times=times, values=found))
            else:
                self._report_unknown(name, column, meant, times is None, [*events] if times is None else [*heads])
        if columns and not series and not self.sink.has_errors:
            self.sink.report("E1102", None, run=name)
        return Measured(name=name, series=tuple(series), inputs=inputs)

    def _in_si(self, column: str, values: Floats, unit: str, dimension: Dimension, own: str) -> Floats:
        """E0878 for a unit of another quantity."""
        if not unit:
            return values
        try:
            definition = parse_unit(unit)
            why = counts_otherwise(unit, own)
            if definition.dimension != dimension:
                why = f"the model has {describe(dimension)} [{own}]"
        except UnknownUnit as error:
            why = str(error)
        if why:
            self.sink.report("E0878", None, name=column, unit=unit, why=why)
            return values
        return np.array(in_si_units(values.tolist(), unit))

    def _report_unknown(self, run: str, column: str, meant: str, instants: bool, known: Sequence[str]) -> None:
        names = [each for each in known if each != _TIME]
        what = "contacts and relations" if instants else "columns"
        help = did_you_mean(meant, names, f"{what} of the model: {listing(meant, names)}")
        self.sink.report("E1101", None, help=help, run=run, name=meant)


def _arrays(name: str, data: Any) -> dict[str, tuple[Floats, str]]:
    """Columns by name, such as those of a data frame. Raises ValueError."""
    try:
        found = {str(column): np.array(data[column], dtype=np.float64) for column in data}
    except (TypeError, ValueError, KeyError) as error:
        raise ValueError(f"the data of `{name}` are columns of numbers by name, or the path of a file") from error
    if _TIME in found:
        lengths = {column: len(values) for column, values in found.items() if values.ndim == 1}
        if len(lengths) < len(found) or len(set(lengths.values())) != 1:
            raise ValueError(f"the columns of `{name}` must have as many numbers as `time`: {lengths}")
        if not np.all(np.diff(found[_TIME]) >= 0.0):
            raise ValueError(f"the times of `{name}` must not decrease")
    for column, values in found.items():
        if not np.isfinite(values).all():
            raise ValueError(f"`{column}` of `{name}` has values that are no numbers: leave those rows out")
    return {column: (values, "") for column, values in found.items()}


def events_of(flat: FlatModel) -> dict[str, None]:
    """Names of what happens at instants that depend on the motion."""
    contacts = [item.name for item in flat.events.contacts]
    frictions = [item.name for item in flat.events.frictions]
    return dict.fromkeys([*contacts, *frictions, *(item.name for item in flat.events.relations)])
