"""A model whose parameters are found from measured motions."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

from lagdsl.foundation.diagnostics import Sink
from lagdsl.interfaces.api.inputs.values import signals_of
from lagdsl.interfaces.api.names import Value, known
from lagdsl.interfaces.api.stepped import Stepped
from lagdsl.interfaces.api.watch import watched

if TYPE_CHECKING:
    from lagdsl.interfaces.api.fit import Fit
    from lagdsl.motion.fit.fit import RunGiven
    from lagdsl.motion.fit.search import Loss
    from lagdsl.motion.fit.sensitivity import Sensitivity
    from lagdsl.motion.fit.unknowns import Free
    from lagdsl.motion.signals.inputs import Signal

# A path, columns by name, several paths, or by the name of each run its settings.
Data: TypeAlias = "Path | str | Sequence[Path | str] | Mapping[str, Any]"
_SETTINGS = ("data", "parameters", "start", "inputs")


class Estimation(Stepped):
    """A model that is compared with data."""

    def fit(
        self,
        data: Data,
        free: Free | None = None,
        *,
        sigma: Mapping[str, float | str] | None = None,
        own: Sequence[str] = (),
        columns: Mapping[str, str | None] | None = None,
        hold: bool = False,
        parameters: Mapping[str, Value] | None = None,
        start: Mapping[str, Value] | None = None,
        inputs: Mapping[str, Signal | str] | Path | str | None = None,
        stop: float | None = None,
        tolerance: float | None = None,
        solver: str = "auto",
        loss: Loss = "linear",
        starts: int = 1,
        segments: int = 1,
        seed: int = 0,
        confidence: float = 0.95,
        progress: Callable[[float], None] | None = None,
        sink: Sink | None = None,
    ) -> Fit:
        """Parameters and start values `free` for which the motions are nearest to `data`: `.values`, `.intervals`,
        `.covariance`, `.series` with residuals, `.hidden`, `.notes`; `print` it.

        `data` is a CSV file, a mapping of columns such as a data frame, a sequence of files, or a mapping of runs: by
        name `{"data": ..., "parameters": {...}, "start": {...}, "inputs": {...}}`, where the name is the file if there
        is no "data". Columns have the names of those of `simulate` beside `time`, units in their heads; columns of
        inputs become the inputs of the run. Data without `time` have times of events by the name of the contact.
        `columns` gives other columns the names of the model, or None to leave them out; with `hold` inputs
        keep their values between the rows of the data.

        `free` are names as for `sweep`, `theta.start`, with bounds or None, or names alone; left out, those that the
        text frees. Unknowns of `own` are found for each run. `sigma` are standard deviations, numbers or texts with
        units; those that are missing follow from the residuals. `loss` is one of SciPy's: linear, soft_l1, huber,
        cauchy, arctan. With `starts` above one, so many starts between the bounds are compared. `segments` cuts every
        run for a search by multiple shooting, for motions that are chaotic or unstable. The rest is as for
        `simulate`; the motions end with the data, or with `stop`.

        Raises CompilationFailed for data and names that do not fit, and where no motion exists to begin with;
        ValueError for other arguments.
        """
        from lagdsl.interfaces.api.fit import Fit
        from lagdsl.motion.fit.fit import Method, fit

        method = Method(
            free=free,
            own=own,
            sigma=sigma or {},
            renamed=columns or {},
            hold=hold,
            stop=stop,
            tolerance=tolerance,
            solver=solver,
            loss=loss,
            starts=starts,
            segments=segments,
            seed=seed,
            confidence=confidence,
        )
        shared = {"parameters": parameters or {}, "start": start or {}, "inputs": inputs}
        runs = [self._run_given(name, given, shared) for name, given in _runs(data).items()]
        found = fit(
            self._compilation,
            self._engine,
            runs,
            method,
            Sink() if sink is None else sink,
            progress=watched(progress, "fit"),
        )
        return Fit.of(found, self._compilation.flat, self._source)

    def _run_given(self, name: str, given: Mapping[str, Any], shared: Mapping[str, Any]) -> RunGiven:
        from lagdsl.motion.fit.fit import RunGiven

        for key in given:
            if key not in _SETTINGS:
                raise ValueError(f"a run has {', '.join(_SETTINGS)}, not `{key}`")
        parameters = {**shared["parameters"], **given.get("parameters", {})}
        self._parameter_vector(parameters)
        flat = self._compilation.flat
        return RunGiven(
            name=name,
            data=given.get("data", name),
            parameters=known("parameter", parameters, self._named("parameter")),
            start=self._start_values({**shared["start"], **given.get("start", {})}),
            inputs={**signals_of(flat, shared["inputs"]), **signals_of(flat, given.get("inputs"))},
        )

    def sensitivity(
        self,
        of: Sequence[str] | str,
        by: Sequence[str] | str,
        *,
        parameters: Mapping[str, Value] | None = None,
        start: Mapping[str, Value] | None = None,
        inputs: Mapping[str, Signal | str] | Path | str | None = None,
        stop: float | None = None,
        tolerance: float | None = None,
        solver: str = "auto",
        sink: Sink | None = None,
    ) -> Sensitivity:
        """Changes of the columns `of` at the end of the motion with the parameters and start values `by`:
        `.derivatives` (of, by) in SI units, and `.effects`, the change by one percent of a value. `print` it: the
        strongest come first.

        The rest is as for `simulate`. Raises as `simulate`.
        """
        from lagdsl.motion.fit.sensitivity import sensitivity

        given = {"data": {}, "parameters": parameters or {}, "start": start or {}, "inputs": inputs}
        run = self._run_given(self.name, given, {"parameters": {}, "start": {}, "inputs": None})
        own = Sink() if sink is None else sink
        options = (stop, tolerance, solver)
        return sensitivity(self._compilation, self._engine, run, (of, by), options, own)


def _runs(data: Any) -> dict[str, Mapping[str, Any]]:
    """Settings of each run by its name."""
    if isinstance(data, (str, Path)):
        return _runs([data])
    if hasattr(data, "keys"):
        values = {str(name): data[name] for name in data}
        if values and all(each is None or isinstance(each, Mapping) for each in values.values()):
            return {name: each or {} for name, each in values.items()}
        return {"data": {"data": data}}
    paths = [Path(each) for each in data]
    names = [path.name for path in paths]
    named = names if len(set(names)) == len(names) else list(map(str, paths))
    return {name: {"data": path} for name, path in zip(named, paths, strict=True)}
