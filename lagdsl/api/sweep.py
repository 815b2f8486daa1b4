"""Sweeps from Python: names and values to the plan of the runs."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.api.names import known
from lagdsl.flat.admissible import require_value
from lagdsl.pipeline import Compilation
from lagdsl.runtime.engines.engine import EngineName
from lagdsl.signals.inputs import Signal
from lagdsl.sweep.plan import Axis, Plan, Target
from lagdsl.sweep.run import Options, SweptModel
from lagdsl.sweep.sweep import Work, options_of, sweep
from lagdsl.units.naming import rate_text

if TYPE_CHECKING:
    import xarray


def run_sweep(
    compilation: Compilation,
    values: Mapping[str, ArrayLike],
    samples: Mapping[str, ArrayLike],
    *,
    engine: EngineName,
    stop: float | None,
    interval: float | None,
    tolerance: float | None,
    inputs: Mapping[str, Signal],
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
    units = _units(compilation)
    single = {name: value for name, value in values.items() if np.ndim(value) == 0}
    many = {name: value for name, value in values.items() if name not in single}
    plan = Plan(
        axes=tuple(_axis(compilation, units, name, value) for name, value in many.items()),
        samples=tuple(_axis(compilation, units, name, value, drawn=True) for name, value in samples.items()),
        fixed=tuple(_axis(compilation, units, name, np.ravel(value)) for name, value in single.items()),
    )
    end, step = options_of(flat, stop=stop, interval=interval)
    options = Options(
        stop=end,
        interval=step,
        tolerance=tolerance,
        solver=solver,
        engine=engine,
        inputs=dict(inputs),
        columns=None if columns is None else tuple(columns),
    )
    work = Work(jobs=jobs, scheduler=scheduler, output=output, resume=resume)
    return sweep(plan, [{}], [SweptModel(flat=flat, program=program)], options, work, progress)


def _units(compilation: Compilation) -> dict[str, str]:
    """Names that can be set, with their SI units."""
    flat = compilation.flat
    units = {slot.name: slot.unit for slot in compilation.program.layout.parameters}
    units |= {f"{item.name}.start": item.unit for item in (*flat.coordinates, *flat.states)}
    units |= {f"der({c.name}).start": rate_text(c.dimension, c.unit) for c in flat.coordinates}
    return {name: "" if unit == "1" else unit for name, unit in units.items()}


def _axis(
    compilation: Compilation, units: Mapping[str, str], name: str, values: ArrayLike, *, drawn: bool = False
) -> Axis:
    """Raises KeyError and ValueError; drawn values that a parameter may not have fail as runs, not here."""
    numbers = np.asarray(values, dtype=np.float64)
    if numbers.ndim != 1:
        raise ValueError(f"the values of `{name}` must be a number or a sequence of numbers")
    known("parameter or start value", dict.fromkeys([name], 0.0), list(units))
    for parameter in compilation.flat.parameters:
        if parameter.name == name and not drawn:
            for value in numbers.tolist():
                require_value(parameter, value)
    key = name.removesuffix(".start")
    target: Target = "start" if key != name else "parameter"
    return Axis(name=name, key=key, target=target, unit=units[name], values=tuple(numbers.tolist()))
