"""Changes of the end of a motion with parameters and start values."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from lagdsl.engines.runtime.engines.broadcast import BatchEngine
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.diagnostics.unknown import unknown_among
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.display import Display
from lagdsl.language.settings.arrays import family, names_in
from lagdsl.motion.fit.data import Series
from lagdsl.motion.fit.derivatives import derivatives_of_runs
from lagdsl.motion.fit.fit import RunGiven, parameters_of, values_of
from lagdsl.motion.fit.rollout import Derivatives, Rollout
from lagdsl.motion.fit.unknowns import found_targets, limits_of, unknown_of
from lagdsl.motion.pipeline import Compilation
from lagdsl.motion.simulate.simulate import check_options
from lagdsl.motion.simulate.table import called_heads

_PERCENT = 0.01


@record(kw_only=True)
class Sensitivity:
    """`derivatives` (of, by) of columns at `time` [s] by parameters and starts, SI units. `values` (by,) are those of
    the motion, `ends` (of,) its columns there, `displays` their units. `steady` (by,) is False where the order of
    events changes near the value: derivatives there are those of no smooth function."""

    model: str
    of: tuple[str, ...]
    by: tuple[str, ...]
    time: float
    values: Floats
    ends: Floats
    derivatives: Floats
    displays: tuple[Display, ...]
    steady: tuple[bool, ...]

    @property
    def effects(self) -> Floats:
        """Changes (of, by) by one percent of each value, SI units; zero where the value is zero."""
        return self.derivatives * (_PERCENT * np.abs(self.values))

    def __str__(self) -> str:
        lines = [f"{self.model}: changes at {self.time:g} s by one percent of a value"]
        for row, (name, shown) in enumerate(zip(self.of, self.displays, strict=True)):
            end = f"{shown(float(self.ends[row])):.6g} {shown.unit}".rstrip()
            lines.append(f"  {name} = {end}")
            effects = self.effects[row] * shown.scale
            width = max(len(each) for each in self.by)
            for k in np.argsort(-np.abs(effects), kind="stable").tolist():
                told = f"{effects[k]:+.4g} {shown.unit}".rstrip()
                if self.values[k] == 0.0:
                    told = f"{self.derivatives[row, k] * shown.scale:+.4g} {shown.unit} per SI unit: its value is zero"
                told += "" if self.steady[k] else "  (the order of events changes near its value)"
                lines.append(f"    {self.by[k]:<{width}}  {told}")
        return "\n".join(lines)

    __repr__ = __str__


def sensitivity(
    compilation: Compilation,
    engine: BatchEngine,
    run: RunGiven,
    names: tuple[Sequence[str] | str, Sequence[str] | str],
    options: tuple[float | None, float | None, str],
    sink: Sink,
    *,
    derivatives: Derivatives | None = None,
) -> Sensitivity:
    """Of the columns, by the parameters and starts `names`, for the motion of `run`; `options` are its stop time, its
    tolerance and its solver.

    Raises CompilationFailed for names that the model does not have and where there is no motion, SimulationFailed.
    """
    flat = compilation.flat
    of, by = (names_in(each) if isinstance(each, str) else list(each) for each in names)
    columns = _columns(compilation, of)
    known = values_of(flat, engine, [run])[0]
    unknowns = [unknown_of(t, known[t.name], *limits_of(t), sink) for t in found_targets(flat, by)]
    stop, tolerance, solver = options
    first = flat.experiment.start_time
    last = flat.experiment.stop_time if stop is None else stop
    relative = flat.experiment.tolerance if tolerance is None else tolerance
    check_options(first, last, relative, solver)
    heads = called_heads(flat)
    end = np.array([last])
    rollout = Rollout(
        name=flat.name,
        flat=flat,
        engine=engine,
        program=compilation.program,
        p=parameters_of(engine, run),
        start=run.start,
        inputs=run.inputs,
        unknowns=tuple(unknowns),
        series=tuple(Series(name=name, times=end, values=end) for name in columns),
        times=np.array([first, last]),
        tolerance=relative,
        solver=solver,
    )
    x = np.array([unknown.value for unknown in unknowns])
    found = (derivatives or derivatives_of_runs())(rollout, x, exact=True)
    return Sensitivity(
        model=flat.name,
        of=tuple(columns),
        by=tuple(unknown.label for unknown in unknowns),
        time=float(found.motion.time[-1]),
        values=x,
        ends=found.values,
        derivatives=found.jacobian,
        displays=tuple(heads[name][3] for name in columns),
        steady=found.steady,
    )


def _columns(compilation: Compilation, names: Sequence[str]) -> list[str]:
    """Names of columns, arrays as their elements. Raises UnknownName."""
    heads = [name for name in called_heads(compilation.flat) if name != "time"]
    found: dict[str, None] = {}
    for name in names:
        elements = [name] if name in heads else family(name, heads)
        if not elements:
            raise unknown_among("column", name, heads)
        found |= dict.fromkeys(elements)
    return list(found)
