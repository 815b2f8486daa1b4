"""The compiled model: what `lagdsl.compile` returns."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Self, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lagdsl.engines.backends.python.sizes import argument_names, motion_sizes
from lagdsl.engines.backends.python.support.values import Entries, State, given_once
from lagdsl.engines.runtime.engines.broadcast import differentiating, solving
from lagdsl.foundation.diagnostics import Sink
from lagdsl.interfaces.api.by_name import calls_of_terms
from lagdsl.interfaces.api.functions.motions_as_functions import MotionsAsFunctions
from lagdsl.interfaces.api.inputs.values import signals_of
from lagdsl.interfaces.api.names import Given, Value, entries, known, listed
from lagdsl.interfaces.api.one_state import calls_at_one_state
from lagdsl.interfaces.api.unknowns import with_starts
from lagdsl.interfaces.api.watch import watched
from lagdsl.language.settings.aliases import by_own_names

if TYPE_CHECKING:
    import xarray

    from lagdsl.engines.runtime.engines.broadcast import BatchEngine
    from lagdsl.foundation.source import SourceFile
    from lagdsl.interfaces.api.inputs.runs import GivenOfRuns
    from lagdsl.interfaces.api.motions import Motions
    from lagdsl.interfaces.api.trajectory import Trajectory
    from lagdsl.motion.pipeline import Compilation
    from lagdsl.motion.signals.inputs import Signal
    from lagdsl.motion.simulate.control import Control
    from lagdsl.motion.simulate.failure import SimulationFailed
    from lagdsl.motion.simulate.initialize import InitialState

Floats = NDArray[np.float64]
# Inputs at one time: signals by name, those of a file, or whole vectors.
Inputs: TypeAlias = "Mapping[str, Signal | str] | Path | str | ArrayLike | None"


class Model(MotionsAsFunctions):
    """Equations of motion of one model, as functions of state and parameters, in SI units.

    Every function takes the time `t`, coordinates `q` and rates `qd` and, by keyword, first-order states `z`, inputs
    `u`, discretes `w` and parameters `p`; what is left out are the initial values and defaults of the
    model, for `w` with relations as they stand. A parameter that is found with the start has its guess there:
    `initial_state().p` are the values that were found.

    Without q the state is that with which a motion begins, `initial_state`: `start`, `parameters` and `inputs` are then
    those of `simulate`, `model.mass_matrix(start={"theta": "30 deg"}, parameters={"m": "2 kg"})`, at the start time or
    at `t`.

    Leading axes broadcast: `t` of shape (...), `q` of shape (..., nq). One state goes to C at once; `out` is an array
    of float64 for the result, of its shape and in one piece. `inputs` and `parameters` are other names of `u` and `p`.
    Names and order of the entries stand in `coordinates`, `states`, `inputs`, `parameters`, `outputs` and
    `constraints`.
    """

    def __init__(self, compilation: Compilation, engine: BatchEngine, source: SourceFile | None = None) -> None:
        program = compilation.program
        super().__init__(
            compilation,
            self._choosing(engine.evaluate_many),
            solving(program, engine),
            differentiating(program, engine),
            motion_sizes(program),
            program.layout.defaults,
            argument_names(program),
        )
        self._compilation = compilation
        self._engine = engine
        self._source = source
        self._crowd = engine.crowd()
        self._prepared: list[BatchEngine] = []
        self._calls = calls_at_one_state(engine, self._row_factors) | calls_of_terms()

    def __getstate__(self) -> tuple[object, ...]:
        """The flat model and the engine by name, from which another process compiles the same model."""
        return self._compilation.flat, self._compilation.route, self._engine.name, self._source

    def __setstate__(self, state: Any) -> None:
        from lagdsl.engines.runtime.engines.selection import engine_of
        from lagdsl.motion.pipeline import compile_flat

        flat, route, engine, source = state
        compilation = compile_flat(flat, Sink(), route)
        assert compilation is not None, "this model compiled before"
        self.__init__(compilation, engine_of(compilation.program, engine), source)  # type: ignore[misc]

    # ---- many states -------------------------------------------------------------------------------------------------

    def batch(
        self,
        t: ArrayLike,
        q: Entries,
        qd: Entries,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
        *,
        threads: int | None = None,
        inputs: Entries | None = None,
        parameters: Entries | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """Accelerations qdd (..., nq) of many states and parameter sets: `forward_dynamics` for a crowd.

        All arguments broadcast over their leading axes. `threads` is the number of cores to use; left out, one, and all
        where the work takes longer than threads take to start. The results are those of `forward_dynamics`, whatever
        the number of threads; `out` is an array for them. Raises ValueError for shapes that do not fit and
        SingularSystem for the first state whose accelerations are not determined.
        """
        u = u if inputs is None else given_once("u", u, "inputs", inputs)
        p = p if parameters is None else given_once("p", p, "parameters", parameters)
        if threads is not None and threads < 1:
            raise ValueError(f"threads must be at least 1, not {threads}")
        found = self._crowd(threads, t, q, qd, (z, u, w, p), out)
        if found is not None:
            return found
        state = self._state(t, q, qd, z, u, w, p)
        return self._engine.solve_batch(threads, *state, out=out)[0]

    # ---- motion ------------------------------------------------------------------------------------------------------

    def _made_of(self, compilation: Compilation) -> Self:
        return type(self)(compilation, self._engine_of(compilation.program), self._source)

    @with_starts
    def initial_state(
        self,
        *,
        parameters: Mapping[str, Value] | None = None,
        start: Mapping[str, Value] | None = None,
        inputs: Mapping[str, Signal | str] | Path | str | None = None,
    ) -> InitialState:
        """The consistent state to start from: `.q .qd .z` in SI units and `.moved`, which tells what was adjusted.

        `start` overrides start values by name, `theta` or `der(theta)`; of `inputs` the values at the start count.
        Raises CompilationFailed where there is none.
        """
        return self._initial(None, start, inputs, parameters)[0]

    def _initial(
        self, t: float | None, start: Mapping[str, Value] | None, inputs: Inputs, parameters: Given
    ) -> tuple[InitialState, Floats | None]:
        """At time t, left out at the start time, with u (nu,); None where no inputs are given."""
        from lagdsl.motion.simulate.initialize import initial_state

        flat, p = self._compilation.flat, self._parameter_vector(parameters)
        time = flat.experiment.start_time if t is None else t
        u = None if inputs is None else self._inputs_then(inputs, time, p)
        return initial_state(flat, self._engine, p, t0=time, u=u, start=self._start_values(start)), u

    def _inputs_then(self, inputs: Inputs, t: float, p: Floats) -> Floats:
        """u (nu,) at time t: those that are given, and the model's."""
        from lagdsl.interfaces.api.inputs.values import inputs_at
        from lagdsl.motion.simulate.placed import start_values

        if inputs is not None and not isinstance(inputs, (Mapping, Path, str)):
            return np.array(list(entries("u", inputs, self._named("input")).values()))
        given = inputs_at(self._compilation.flat, inputs, t)
        own = zip(self.inputs, start_values(self._engine, t, p)[1].tolist(), strict=True)
        return np.array([given.get(name, value) for name, value in own])

    def _started(self, t: ArrayLike | None, start: Mapping[str, Value], u: Any, p: Any) -> State:
        if t is not None and np.ndim(t):
            raise ValueError("one state has one time: without q, t is a number")
        own = self._of_starts(start)
        initial, inputs = own._initial(None if t is None else float(t), start, u, p)  # type: ignore[arg-type]
        q, qd = (
            np.array([values[name] for name in self.coordinates])
            for values in (dict(zip(own.coordinates, each.tolist(), strict=True)) for each in (initial.q, initial.qd))
        )
        return initial.t, q, qd, initial.z, inputs, None, initial.p

    @with_starts
    def simulate(
        self,
        *,
        stop: float | None = None,
        interval: float | None = None,
        times: ArrayLike | None = None,
        tolerance: float | None = None,
        parameters: Mapping[str, Value] | None = None,
        start: Mapping[str, Value] | None = None,
        inputs: Mapping[str, Signal | str] | Path | str | None = None,
        solver: str = "auto",
        step: float | None = None,
        control: Control | Sequence[Control] = (),
        tangents: Sequence[str] | str = (),
        progress: Callable[[float], None] | None = None,
        sink: Sink | None = None,
    ) -> Trajectory:
        """The motion from the initial state, a row every `interval` and two at each event, which `.events` lists; the
        model's experiment says what is left out. With `times`, which increase from the start time on, the rows are
        there and the last one is the end.

        `inputs` are constants, functions of time or pairs (times, values), by name, or the path of a CSV file with a
        column `time` and one for each input. `solver`: auto, dop853, radau, or rk4, leapfrog, ros2 in steps of the
        length `step`. Controllers, `lagdsl.control("2 ms", f)`, set inputs on the way. `tangents` are parameters,
        starts (`theta.start`) and inputs by which `motion.derivative("theta", "l")` tells derivatives. `progress` is
        called with the part of the time that is done; warnings go to `sink`. Raises CompilationFailed before the first
        step, SimulationFailed with the motion so far after it; KeyError, ValueError.
        """
        simulate, failed, trajectory_of = _simulator()
        controllers = control if isinstance(control, Sequence) else [control]
        end = stop if times is None else float(np.max(times))
        own = partial(self._page, stop=end, tolerance=tolerance, parameters=parameters, start=start, inputs=inputs)
        page = None if controllers else own
        try:
            motion = simulate(
                self._engine,
                self._compilation.flat,
                stop=stop,
                interval=interval,
                times=None if times is None else np.array(times, dtype=np.float64),
                tolerance=tolerance,
                p=self._parameter_vector(parameters),
                inputs=signals_of(self._compilation.flat, inputs),
                start=self._start_values(start),
                solver=solver,
                step=step,
                control=controllers,
                tangents=listed(tangents),
                read=self._input_value,
                progress=watched(progress, "simulation"),
                sink=sink,
            )
        except failed as failure:
            failure.trajectory = trajectory_of(failure.trajectory, page)
            raise
        return trajectory_of(motion, page)

    @with_starts
    def simulate_many(
        self,
        *,
        parameters: Mapping[str, ArrayLike] | None = None,
        start: Mapping[str, ArrayLike] | None = None,
        stop: float | None = None,
        interval: float | None = None,
        tolerance: float | None = None,
        inputs: GivenOfRuns = None,
        solver: str = "auto",
        columns: Sequence[str] | None = None,
        tangents: Sequence[str] | str = (),
        threads: int | None = None,
        progress: Callable[[float], None] | None = None,
    ) -> Motions:
        """Many motions at once, on all cores: run k has entry k of every sequence among the values.

        `motions["theta"]` is (runs, rows), the rows those of `simulate` at `motions.time`; without islands to the bit.
        `motions.failures` says why which run failed; its rows after that are nan. Names, values and `tangents` are
        those of `simulate`, values numbers or sequences of one length. Entries of inputs are signals of any form; a
        pair of columns of numbers is one table. A sequence of mappings or of files has all inputs of each run.
        `columns` are the names to keep, `threads` the cores to use. Raises KeyError, ValueError for what does not fit.
        """
        from lagdsl.interfaces.api.inputs.runs import inputs_of_runs
        from lagdsl.interfaces.api.motions import simulate_many, values_of_runs

        if threads is not None and threads < 1:
            raise ValueError(f"threads must be at least 1, not {threads}")
        return simulate_many(
            self._compilation,
            values_of_runs("parameter", parameters, self._named("parameter")),
            values_of_runs("start value", by_own_names(self._compilation.flat, start or {}), self._named("start")),
            engine=self._engine.name,
            prepared=self._prepared,
            stop=stop,
            interval=interval,
            tolerance=tolerance,
            inputs=inputs_of_runs(self._compilation.flat, inputs),
            solver=solver,
            columns=columns,
            tangents=tuple(listed(tangents)),
            threads=threads,
            progress=watched(progress, "simulations"),
        )

    def sweep(
        self,
        values: Mapping[str, ArrayLike],
        *,
        samples: Mapping[str, ArrayLike] | None = None,
        stop: float | None = None,
        interval: float | None = None,
        tolerance: float | None = None,
        inputs: GivenOfRuns = None,
        solver: str = "auto",
        columns: Sequence[str] | None = None,
        output: Path | str | None = None,
        resume: bool = False,
        jobs: int | None = None,
        scheduler: str | None = None,
        progress: Callable[[float], None] | None = None,
    ) -> xarray.Dataset:
        """Motions for every combination of `values` and `inputs`, each for all `samples`, as one labelled dataset.

        Names are those of parameters and, for starts, `theta.start` or `der(theta).start`; values are numbers or
        sequences of them, in SI units. Inputs are those of `simulate`, a sequence of numbers or of signals for an axis,
        or a sequence of files for the axis `input`. `samples`, of inputs too, are drawn by the caller: entry k of all
        of them belongs to sample k.
        Every column has an axis for each sequence, `sample` and `time`; `status`, `message` and `ended` tell how each
        run went: a run that fails ends no sweep. With `output` (.nc, .parquet, .csv) finished runs are kept on disk,
        and `resume` goes on after an interruption. `jobs` is the number of threads (default: the cores), `scheduler`
        the address of a Dask cluster to use instead. The rest is as for `simulate`.

        Raises KeyError and ValueError for arguments that do not fit, OSError for a file that cannot be written,
        ModuleNotFoundError without the extra `sweep`.
        """
        from lagdsl.interfaces.api.sweep import run_sweep

        return run_sweep(
            self._compilation,
            values,
            samples or {},
            engine=self._engine.name,
            stop=stop,
            interval=interval,
            tolerance=tolerance,
            inputs=inputs,
            solver=solver,
            columns=columns,
            output=None if output is None else Path(output),
            resume=resume,
            jobs=jobs,
            scheduler=scheduler,
            progress=watched(progress, "sweep"),
        )

    # ---- other tools -------------------------------------------------------------------------------------------------

    def export_fmu(
        self,
        path: Path | str,
        *,
        fmi: int = 2,
        kind: Literal["me", "cs", "both"] = "both",
        platforms: Sequence[str] = (),
        parameters: Mapping[str, Value] | None = None,
        start: Mapping[str, Value] | None = None,
        outputs: Sequence[str] = (),
        hide: Sequence[str] = (),
        scalar: bool = False,
        clocks: bool = False,
        author: str | None = None,
        license: str | None = None,
        model_version: str | None = None,
        with_source: bool = False,
        progress: Callable[[float], None] | None = None,
        sink: Sink | None = None,
    ) -> None:
        """Write the model to `path` as an FMU of FMI 2.0 or 3.0, checked and run once before it appears.

        `platforms` are those that binaries are made for, `linux-x86_64`, `windows-x86_64`...; default: this machine's.
        `parameters` and `start`, by name in SI units, become the defaults of the FMU. `outputs` are variables that
        become outputs, `hide` those that it does not show; `*` and `?` stand for any text and any character. With
        `scalar` entries of arrays are variables of their own in FMI 3, too; with `clocks` FMI 3 tells of its clocks.
        `author`, `license` and `model_version` stand in its description. `with_source` puts the text of the model into
        it. Notes go to `sink`. Raises CompilationFailed where there is no FMU of this model or it cannot be made here,
        OSError where `path` cannot be written, KeyError and ValueError for arguments that do not fit.
        """
        from lagdsl.exchange.fmi.description.description import Attribution
        from lagdsl.exchange.fmi.variables.ports import Ports
        from lagdsl.interfaces.api.fmu import export_fmu

        self._parameter_vector(parameters)
        source = self._source if with_source else None
        chosen, starts = known("parameter", parameters, self._named("parameter")), self._start_values(start)
        export_fmu(
            self._compilation,
            Path(path),
            version=fmi,
            kind=kind,
            platforms=platforms,
            parameters=chosen,
            start=starts,
            source=source,
            ports=Ports(outputs=tuple(outputs), hidden=tuple(hide), scalar=scalar, clocks=clocks),
            attribution=Attribution(author=author, license=license, version=model_version),
            engine=self._engine.name,
            sink=sink,
            progress=watched(progress, "FMU"),
        )


@cache
def _simulator() -> tuple[Callable[..., Any], type[SimulationFailed], Callable[..., Trajectory]]:
    """`simulate`, what it raises, and what makes its product that of this interface: looked up once, as a short run
    takes ten times as long as the look."""
    from lagdsl.interfaces.api.trajectory import Trajectory
    from lagdsl.motion.simulate.failure import SimulationFailed
    from lagdsl.motion.simulate.simulate import simulate

    return simulate, SimulationFailed, Trajectory.of
