"""Many motions of one model as arrays."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, KeysView, Mapping, Sequence
from dataclasses import field
from importlib.util import find_spec
from itertools import repeat
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lagdsl.engines.backends.python.support.names import real_numbers
from lagdsl.engines.runtime.engines.cores import cores
from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.foundation.diagnostics import refused
from lagdsl.foundation.diagnostics.suggest import did_you_mean, listing
from lagdsl.foundation.diagnostics.unknown import unknown_among
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.foundation.source.whole_file import whole_file
from lagdsl.interfaces.api.inputs.runs import InputsOfRuns
from lagdsl.interfaces.api.names import keys_of, number
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.aliases import results_names
from lagdsl.language.settings.arrays import family
from lagdsl.language.settings.target import Kind, Target, targets
from lagdsl.motion.pipeline import Compilation
from lagdsl.motion.signals.inputs import Signal
from lagdsl.motion.signals.parquet import attributes, require_parquet, write_columns
from lagdsl.motion.simulate.derivatives import check_differentiable
from lagdsl.motion.sweep.dataset import Collected, collect, dataset_of_runs, free_name, require_room
from lagdsl.motion.sweep.plan import Task, require_few
from lagdsl.motion.sweep.run import Options, Outcome, SweptModel
from lagdsl.motion.sweep.sweep import options_of, times_of, width_of
from lagdsl.motion.sweep.threads import in_threads

if TYPE_CHECKING:
    import pandas as pd
    import xarray

    from lagdsl.engines.runtime.engines.broadcast import BatchEngine

_Value = TypeVar("_Value")


@record(kw_only=True)
class Motions:
    """Runs that share the times of their rows: `motions["theta"]` has the shape (runs, rows), SI units.

    `time` (rows,) and `ended` (runs,) [s]; `failures` says by the number of a run why it failed. Rows after the end of
    a run are nan. `aliases` are other names of columns, with the name that each stands for. `settings` (runs,) are the
    values that were set, by the names that a sweep gives them: `l`, `theta.start`. `units` has those of all columns and
    settings. `derivatives` (runs, rows, tangents) are those of the columns by what `tangents` names.
    """

    model: str
    time: Floats
    columns: dict[str, Floats]
    units: dict[str, str]
    ended: Floats
    failures: dict[int, str]
    aliases: dict[str, str]
    settings: dict[str, Floats]
    tangents: tuple[str, ...] = ()
    derivatives: dict[str, Floats] = field(default_factory=dict)

    def __len__(self) -> int:
        return len(self.ended)

    def __iter__(self) -> Iterator[str]:
        """The names of the columns, so that `dict(motions)` holds them all."""
        return iter(self.columns)

    def keys(self) -> KeysView[str]:
        return self.columns.keys()

    def __contains__(self, name: object) -> bool:
        return name in self.columns or (isinstance(name, str) and bool(family(name, self.columns)))

    def __getitem__(self, name: str) -> Floats:
        """Values (..., rows) of the column, or (..., rows, elements) of the array `name`; KeyError with known names."""
        if name in self.columns:
            return self.columns[name]
        others = {other: own for other, own in self.aliases.items() if own in self.columns}
        if name in others:
            return self.columns[others[name]]
        elements = family(name, [*self.columns, *others])
        if elements:
            return np.stack([self[each] for each in elements], axis=-1)
        if not self.columns and self.failures:
            raise KeyError(
                f"no column `{name}`: every run failed, the first one because {self.failures[min(self.failures)]}"
            )
        hint = did_you_mean(str(name), self.columns, f"there are {listing(str(name), self.columns)}")
        raise KeyError(f"no column `{name}`; {hint}")

    def derivative(self, of: str, by: str) -> Floats:
        """Of the column `of` at a fixed time by a quantity that `tangents` named, (runs, rows), SI units. Raises
        UnknownName, and CallRefused (E0884) where nobody asked for derivatives."""
        if not self.tangents:
            raise refused("E0884", text='a call of `simulate_many` with `tangents`, such as `tangents=["m"]`')
        own = self.aliases.get(of, of)
        if own not in self.columns:
            raise unknown_among("column", of, [*self.columns, *self.aliases])
        if by not in self.tangents:
            raise unknown_among("quantity of `tangents`", by, list(self.tangents))
        missing = np.full((*self.columns[own].shape, len(self.tangents)), np.nan)
        return self.derivatives.get(own, missing)[:, :, self.tangents.index(by)]

    @property
    def names(self) -> list[str]:
        return list(self.columns)

    def to_xarray(self) -> xarray.Dataset:
        """Columns over `run` and `time`, with `status`, `message` and `ended` of each run as `Model.sweep` has them.
        Settings are coordinates of the runs; units are attributes. Needs the extra `sweep`."""
        require_package("xarray", "labelled datasets")
        runs = range(len(self))
        found = Collected(
            columns=self.columns,
            units=self.units,
            status=["failed" if k in self.failures else "ok" for k in runs],
            message=[self.failures.get(k, "") for k in runs],
            ended=self.ended,
        )
        return dataset_of_runs(found, self.time, self.settings, self.units, model=self.model)

    def to_dataframe(self) -> pd.DataFrame:
        """A row for every run and time: `run`, the settings, `time`, the columns; `attrs["units"]` has the SI unit of
        each. Needs the extra `table`."""
        require_package("pandas", "data frames")
        import pandas as pd

        frame = pd.DataFrame(self._table())
        frame.attrs = attributes(self.model, self._units())
        return frame

    def to_parquet(self, path: Path | str) -> None:
        """Write the rows of `to_dataframe` to `path`; the metadata have the units of the columns, which pandas reads
        into `attrs["units"]`. Needs the extra `table`. Raises OSError."""
        require_parquet()
        with whole_file(Path(path)) as draft:
            write_columns(self._table(), self._units(), self.model, draft)

    def _table(self) -> dict[str, NDArray[Any]]:
        rows = len(self.time)
        settings = {name: np.repeat(values, rows) for name, values in self.settings.items()}
        columns = {name: values.ravel() for name, values in self.columns.items()}
        run, time = (free_name(name, {*settings, *columns}) for name in ("run", "time"))
        return {
            run: np.repeat(np.arange(len(self)), rows),
            **settings,
            time: np.tile(self.time, len(self)),
            **columns,
        }

    def _units(self) -> dict[str, str]:
        return {free_name("time", {*self.settings, *self.columns}): "s", **self.units}


def require_package(package: str, what: str) -> None:
    """Raises ModuleNotFoundError where a package is missing."""
    if find_spec(package) is None:
        raise ModuleNotFoundError(f"{what} need {package}: pip install {package}")


def simulate_many(
    compilation: Compilation,
    parameters: Mapping[str, ArrayLike],
    start: Mapping[str, ArrayLike],
    *,
    engine: EngineName,
    prepared: list[BatchEngine],
    stop: float | None,
    interval: float | None,
    tolerance: float | None,
    inputs: InputsOfRuns,
    solver: str,
    columns: Sequence[str] | None,
    tangents: tuple[str, ...],
    threads: int | None,
    progress: Callable[[float], None] | None,
) -> Motions:
    """See `Model.simulate_many`; names of parameters and starts are known. `prepared` are engines of earlier calls."""
    if tangents:
        check_differentiable(compilation.flat, compilation.program.layout, tangents)
    end, step = options_of(compilation.flat, stop=stop, interval=interval)
    options = Options(
        stop=end,
        interval=step,
        tolerance=tolerance,
        solver=solver,
        engine=engine,
        inputs=inputs.shared,
        columns=None if columns is None else tuple(columns),
        tangents=tangents,
    )
    subjects = [SweptModel(flat=compilation.flat, program=compilation.program, engines=prepared)]
    times = times_of(subjects, options)
    count, (chosen, starts) = _runs({name: len(each) for name, each in inputs.own.items()}, parameters, start)
    require_few(count)
    require_room(count, len(times), width_of(subjects, options) * (1 + len(tangents)), None)
    tasks = (
        Task(
            index=k,
            swept=0,
            parameters=dict(zip(chosen, p, strict=True)),
            start=dict(zip(starts, x, strict=True)),
            inputs=dict(zip(inputs.own, u, strict=True)),
        )
        for k, p, x, u in zip(
            range(count), *(_by_run(each, count) for each in (chosen, starts, inputs.own)), strict=True
        )
    )
    outcomes: list[Outcome] = []
    asked = cores() if threads is None else threads
    for outcome in in_threads(subjects, options, tasks, count, 1 if inputs.calls_python else asked):
        outcomes.append(outcome)
        if progress is not None:
            progress(len(outcomes) / count)
    found = collect(count, len(times), outcomes)
    settings, units = _settings(compilation.flat, count, chosen, starts, inputs)
    return Motions(
        model=compilation.flat.name,
        time=times,
        columns=found.columns,
        units=found.units | units,
        ended=found.ended,
        failures={k: found.message[k] for k in range(count) if found.status[k] != "ok"},
        aliases=results_names(compilation.flat),
        settings=settings,
        tangents=tangents,
        derivatives=found.derivatives,
    )


def _by_run(values: Mapping[str, Sequence[_Value]], runs: int) -> Iterable[tuple[_Value, ...]]:
    """The values of each run, in the order of their names."""
    return zip(*values.values(), strict=True) if values else repeat((), runs)


def _settings(
    flat: FlatModel,
    runs: int,
    parameters: dict[str, list[float]],
    starts: dict[str, list[float]],
    inputs: InputsOfRuns,
) -> tuple[dict[str, Floats], dict[str, str]]:
    """Settings of every run and their units, by the names that a sweep gives them; of inputs those that are numbers
    in every run."""
    signals: dict[str, list[Signal]] = {name: [signal] * runs for name, signal in inputs.shared.items()} | inputs.own
    numbers = {name: [float(s) for s in each if isinstance(s, (int, float))] for name, each in signals.items()}
    given: dict[Kind, dict[str, list[float]]] = {"parameter": parameters, "start": starts, "input": numbers}
    values = {target: given[target.kind].get(target.key, []) for target in targets(flat, tuple(given)).values()}
    known = {target.name: (np.array(each), target.unit) for target, each in values.items() if len(each) == runs}
    return {name: each for name, (each, _) in known.items()}, {name: unit for name, (_, unit) in known.items()}


def values_of_runs(
    what: str, given: Mapping[str, ArrayLike] | None, targets: Mapping[str, Target]
) -> dict[str, ArrayLike]:
    """Values and sequences of values by the names of the model, in SI units; an array by its name has its elements on
    the last axis. Raises UnknownName and ValueError for what does not fit."""
    found: dict[str, ArrayLike] = {}
    for name, value in (given or {}).items():
        keys = keys_of(what, name, targets)
        if len(keys) == 1:
            found[keys[0]] = _in_si(targets[keys[0]], value)
            continue
        elements = np.asarray(value, dtype=object)
        if elements.ndim == 0 or elements.shape[-1] != len(keys):
            raise ValueError(f"`{name}` has {len(keys)} elements: its values need the shape (..., {len(keys)})")
        found |= {key: _in_si(targets[key], elements[..., i]) for i, key in enumerate(keys)}
    return found


def _in_si(target: Target, value: ArrayLike) -> ArrayLike:
    known = np.asarray(value) if isinstance(value, np.ndarray) else None
    if known is not None and known.dtype.kind in "fiu" and np.all(np.isfinite(known)):
        return known.astype(np.float64)
    array = np.asarray(value, dtype=object)
    return np.reshape([number(target, each) for each in array.ravel().tolist()], array.shape)


def _runs(inputs: dict[str, int], *given: Mapping[str, ArrayLike]) -> tuple[int, list[dict[str, list[float]]]]:
    """The number of runs, and each value in every one of them; of `inputs` the numbers of signals are told. Raises
    ValueError for sequences that do not fit."""
    arrays = [{name: real_numbers(name, values) for name, values in each.items()} for each in given]
    lengths = inputs | {name: len(values) for each in arrays for name, values in each.items() if values.ndim == 1}
    for each in arrays:
        for name, values in each.items():
            if values.ndim > 1:
                raise ValueError(f"the values of `{name}` must be a number or a sequence of numbers")
    if len(set(lengths.values())) != 1:
        told = ", ".join(f"`{name}` has {length}" for name, length in lengths.items()) or "there is none"
        raise ValueError(f"values that differ from run to run must be sequences of one length; {told}")
    (count,) = set(lengths.values())
    return count, [{name: np.broadcast_to(values, count).tolist() for name, values in each.items()} for each in arrays]
