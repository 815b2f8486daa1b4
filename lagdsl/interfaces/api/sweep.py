"""Sweeps from Python: names and values to the plan of the runs."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.foundation.diagnostics import Sink
from lagdsl.interfaces.api.inputs.axes import input_axes
from lagdsl.interfaces.api.inputs.runs import GivenOfRuns
from lagdsl.interfaces.api.names import keys_of, number, spread
from lagdsl.interfaces.api.texts import require_units
from lagdsl.language.flat.admissible import require_value
from lagdsl.language.flat.model import FlatModel, Parameter
from lagdsl.language.settings.aliases import by_own_names
from lagdsl.language.settings.target import Target, targets
from lagdsl.motion.pipeline import Compilation
from lagdsl.motion.sweep.plan import Axis, Plan
from lagdsl.motion.sweep.run import Options, SweptModel
from lagdsl.motion.sweep.sweep import Work, options_of, sweep
from lagdsl.motion.sweep.values import axis, axis_of

if TYPE_CHECKING:
    import xarray

    from lagdsl.documents.plot.picture.wishes import Wishes


def run_sweep(
    compilation: Compilation,
    values: Mapping[str, ArrayLike],
    samples: Mapping[str, ArrayLike],
    *,
    engine: EngineName,
    stop: float | None,
    interval: float | None,
    tolerance: float | None,
    inputs: GivenOfRuns,
    solver: str,
    columns: Sequence[str] | None,
    output: Path | None,
    resume: bool,
    jobs: int | None,
    scheduler: str | None,
    progress: Callable[[float], None] | None,
) -> xarray.Dataset:
    """See `Model.sweep`."""
    flat, program = compilation.flat, compilation.program
    known = targets(flat, ("parameter", "start"))
    values, samples = by_own_names(flat, values), by_own_names(flat, samples)
    single, many = _axes(values, known)
    drawn = known | targets(flat, ("input",))
    given = input_axes(flat, inputs)
    plan = Plan(
        axes=(*many, *given.many),
        samples=tuple(_axis(target, numbers, drawn=True) for target, numbers in _elements(samples, drawn)),
        fixed=(*single, *given.fixed),
    )
    end, step = options_of(flat, stop=stop, interval=interval)
    options = Options(
        stop=end,
        interval=step,
        tolerance=tolerance,
        solver=solver,
        engine=engine,
        inputs=given.shared,
        columns=None if columns is None else tuple(columns),
    )
    work = Work(jobs=jobs, scheduler=scheduler, output=output, resume=resume)
    return sweep(plan, [{}], [SweptModel(flat=flat, program=program)], options, work, progress)


def _axes(values: Mapping[str, ArrayLike], known: Mapping[str, Target]) -> tuple[list[Axis], list[Axis]]:
    """Axes with one value, and axes with many. Raises UnknownName and ValueError."""
    single: list[Axis] = []
    many: list[Axis] = []
    sink = Sink()
    for target, value in _elements(values, known):
        axis = axis_of(target, value, sink) if isinstance(value, str) else _axis(target, np.atleast_1d(value))
        (single if np.ndim(value) == 0 and len(axis.values) == 1 else many).append(axis)
    require_units(sink)
    return single, many


def _elements(values: Mapping[str, ArrayLike], known: Mapping[str, Target]) -> Iterator[tuple[Target, ArrayLike]]:
    """Every value with what it is for. An array by its name has one value for each element."""
    for name, value in values.items():
        keys = keys_of("parameter or start value", name, known)
        if len(keys) == 1:
            yield known[keys[0]], value
            continue
        for key, single in spread("parameter or start value", name, value, known):
            yield known[key], single


def _axis(target: Target, values: ArrayLike, *, drawn: bool = False) -> Axis:
    """Raises ValueError; drawn values that a parameter may not have fail as runs, not here."""
    array = np.asarray(values, dtype=object)
    if array.ndim != 1:
        raise ValueError(f"the values of `{target.name}` must be a number, a text or a sequence of numbers")
    numbers = tuple(number(target, each) for each in array.tolist())
    if isinstance(target.quantity, Parameter) and not drawn:
        for value in numbers:
            require_value(target.quantity, value)
    return axis(target, numbers)


def settings_of(flat: FlatModel, data: xarray.Dataset) -> list[tuple[str, Wishes]]:
    """Labels and values of every run of a dataset that `run_sweep` made of this model, or of a part of it. Raises
    ValueError, also where runs have tables of their own, which no dataset holds."""
    from lagdsl.documents.plot.picture.wishes import Wishes
    from lagdsl.motion.sweep.dataset import STATUS, TABLES

    if data.attrs.get("model") != flat.name:
        raise ValueError(f"the sweep is of `{data.attrs.get('model')}`, not of `{flat.name}`")
    status = next(v for v in data.data_vars.values() if v.attrs.get("long_name") == STATUS)
    for name, coordinate in data.coords.items():
        if coordinate.attrs.get("long_name") == TABLES:
            raise ValueError(
                f"the dataset has no tables of `{name}`: show one run with `inputs`, or use lag sweep --page"
            )
    known = targets(flat, ("parameter", "start", "input"))
    names = [str(name) for name in data.coords if str(name) in known]
    values = {name: np.broadcast_to(_aligned(data, name, status), status.shape).ravel().tolist() for name in names}
    varied = [name for name in names if len(set(values[name])) > 1]
    found: list[tuple[str, Wishes]] = []
    for k in range(status.size):
        own = {name: values[name][k] for name in names}
        label = ", ".join(_told(known[name], own[name]) for name in varied)
        parameters = {known[name].key: value for name, value in own.items() if known[name].kind == "parameter"}
        start = {known[name].key: value for name, value in own.items() if known[name].kind == "start"}
        inputs = {name: value for name, value in own.items() if known[name].kind == "input"}
        found.append((label or f"run {k + 1}", Wishes(parameters=parameters, start=start, inputs=inputs)))
    return found


def _told(target: Target, value: float) -> str:
    return f"{target.name} = {target.display(value):.6g} {target.display.unit}".rstrip()


def _aligned(data: xarray.Dataset, name: str, status: xarray.DataArray) -> ArrayLike:
    """Values of a coordinate along the axes of the runs."""
    coordinate = data.coords[name]
    shape = [data.sizes[dim] if dim in coordinate.dims else 1 for dim in status.dims]
    return np.reshape(coordinate.values, shape)
