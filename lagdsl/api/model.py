"""The compiled model: what `lagdsl.compile` returns."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lagdsl.api.inputs import signals_of
from lagdsl.api.names import Given, Value, entries, known
from lagdsl.api.shown import Shown
from lagdsl.backends.python.sizes import motion_sizes
from lagdsl.diagnostics import Sink

if TYPE_CHECKING:
    import xarray

    from lagdsl.analysis.linearization import Linearization
    from lagdsl.analysis.modes import Modes
    from lagdsl.analysis.point import System
    from lagdsl.analysis.trim import Equilibrium
    from lagdsl.analysis.variation import Variation
    from lagdsl.analysis.where import Where
    from lagdsl.api.motions import Motions
    from lagdsl.api.trajectory import Trajectory
    from lagdsl.pipeline import Compilation
    from lagdsl.runtime.engines.broadcast import BatchEngine
    from lagdsl.signals.inputs import Signal
    from lagdsl.simulate.initialize import InitialState
    from lagdsl.source import SourceFile
    from lagdsl.textbook.equations import EquationsOfMotion

Floats = NDArray[np.float64]


class Model(Shown):
    """Equations of motion of one model, as functions of state and parameters, in SI units.

    Every function takes the time `t`, coordinates `q` and rates `qd` and, by keyword, first-order states `z`, inputs
    `u`, discretes `w` and parameters `p`; what is left out are the initial values and defaults of the
    model, for `w` with relations as they stand. A parameter that is found with the start has its guess there:
    `initial_state().p` are the values that were found.
    Leading axes broadcast: `t` of shape (...), `q` of shape (..., nq). Names and order of the entries stand in
    `coordinates`, `states`, `inputs`, `parameters`, `outputs` and `constraints`.
    """

    def __init__(self, compilation: Compilation, engine: BatchEngine, source: SourceFile | None = None) -> None:
        program = compilation.program
        super().__init__(
            compilation,
            engine.evaluate_many,
            engine.solve_many,
            engine.jacobian_many,
            motion_sizes(program),
            program.layout.defaults,
        )
        self._compilation = compilation
        self._engine = engine
        self._source = source

    @cached_property
    def equations(self) -> EquationsOfMotion:
        """The equations of motion in symbols (SymPy), by the textbook's route."""
        from lagdsl.textbook.derive import derive

        return derive(self._compilation.flat)

    # ---- many states -------------------------------------------------------------------------------------------------

    def batch(
        self,
        t: ArrayLike,
        q: ArrayLike,
        qd: ArrayLike,
        z: ArrayLike | None = None,
        u: ArrayLike | None = None,
        w: ArrayLike | None = None,
        p: ArrayLike | None = None,
        *,
        threads: int | None = None,
    ) -> Floats:
        """Accelerations qdd (..., nq) of many states and parameter sets, on all cores: `forward_dynamics` for a crowd.

        All arguments broadcast over their leading axes. `threads` is the number of cores to use. The results are those
        of `forward_dynamics`, whatever the number of threads. Raises ValueError for shapes that do not fit and
        SingularSystem for the first state whose accelerations are not determined.
        """
        from lagdsl.runtime.engines.cores import cores

        if threads is not None and threads < 1:
            raise ValueError(f"threads must be at least 1, not {threads}")
        state = self._state(t, q, qd, z, u, w, p)
        return self._engine.solve_batch(cores() if threads is None else threads, *state)[0]

    # ---- motion ------------------------------------------------------------------------------------------------------

    def initial_state(
        self, *, parameters: Mapping[str, Value] | None = None, start: Mapping[str, Value] | None = None
    ) -> InitialState:
        """The consistent state to start from: `.q .qd .z` in SI units and `.moved`, which tells what was adjusted.

        `start` overrides start values by name, `theta` or `der(theta)`. Raises CompilationFailed where there is none.
        """
        from lagdsl.simulate.initialize import initial_state

        p = self._parameter_vector(parameters)
        return initial_state(self._compilation.flat, self._engine, p, start=self._start_values(start))

    def simulate(
        self,
        *,
        stop: float | None = None,
        interval: float | None = None,
        tolerance: float | None = None,
        parameters: Mapping[str, Value] | None = None,
        start: Mapping[str, Value] | None = None,
        inputs: Mapping[str, Signal | str] | Path | str | None = None,
        solver: str = "auto",
        step: float | None = None,
        progress: Callable[[float], None] | None = None,
        sink: Sink | None = None,
    ) -> Trajectory:
        """The motion from the initial state, a row every `interval` and two at each event, which `.events` lists; the
        model's experiment says what is left out.

        `inputs` are constants, functions of time or pairs (times, values), by name, or the path of a CSV file with a
        column `time` and one for each input. `solver`: auto, dop853, radau, or rk4, leapfrog, ros2 in steps of the
        length `step`. `progress` is called with the part of the time that is done; warnings go to `sink`. Raises
        CompilationFailed before the first step, SimulationFailed with the motion so far after it; KeyError, ValueError.
        """
        from lagdsl.api.trajectory import Trajectory
        from lagdsl.simulate.failure import SimulationFailed
        from lagdsl.simulate.simulate import simulate

        page = partial(self._page, stop=stop, tolerance=tolerance, parameters=parameters, start=start, inputs=inputs)
        try:
            motion = simulate(
                self._engine,
                self._compilation.flat,
                stop=stop,
                interval=interval,
                tolerance=tolerance,
                p=self._parameter_vector(parameters),
                inputs=signals_of(self._compilation.flat, inputs),
                start=self._start_values(start),
                solver=solver,
                step=step,
                progress=progress,
                sink=sink,
            )
        except SimulationFailed as failure:
            failure.trajectory = Trajectory.of(failure.trajectory, page)
            raise
        return Trajectory.of(motion, page)

    def simulate_many(
        self,
        *,
        parameters: Mapping[str, ArrayLike] | None = None,
        start: Mapping[str, ArrayLike] | None = None,
        stop: float | None = None,
        interval: float | None = None,
        tolerance: float | None = None,
        inputs: Mapping[str, Signal | str] | Path | str | None = None,
        solver: str = "auto",
        columns: Sequence[str] | None = None,
        threads: int | None = None,
        progress: Callable[[float], None] | None = None,
    ) -> Motions:
        """Many motions at once, on all cores: run k has entry k of every sequence among the values.

        `motions["theta"]` has the shape (runs, rows), the rows those of `simulate` at `motions.time`, to the bit.
        `motions.failures` says why which run failed; its rows after that are nan. Names and values are those of
        `simulate`, numbers or sequences of one length. `columns` are the names to keep, `threads` the number of
        cores to use. Raises KeyError and ValueError for arguments that do not fit.
        """
        from lagdsl.api.motions import simulate_many, values_of_runs

        if threads is not None and threads < 1:
            raise ValueError(f"threads must be at least 1, not {threads}")
        return simulate_many(
            self._compilation,
            values_of_runs("parameter", parameters, self._named("parameter")),
            values_of_runs("start value", start, self._named("start")),
            engine=self._engine.name,
            stop=stop,
            interval=interval,
            tolerance=tolerance,
            inputs=signals_of(self._compilation.flat, inputs),
            solver=solver,
            columns=columns,
            threads=threads,
            progress=progress,
        )

    def sweep(
        self,
        values: Mapping[str, ArrayLike],
        *,
        samples: Mapping[str, ArrayLike] | None = None,
        stop: float | None = None,
        interval: float | None = None,
        tolerance: float | None = None,
        inputs: Mapping[str, Signal | str] | Path | str | None = None,
        solver: str = "auto",
        columns: Sequence[str] | None = None,
        output: Path | str | None = None,
        resume: bool = False,
        jobs: int | None = None,
        scheduler: str | None = None,
        progress: Callable[[float], None] | None = None,
    ) -> xarray.Dataset:
        """Motions for every combination of `values`, each for all `samples`, as one labelled dataset.

        Names are those of parameters and, for starts, `theta.start` or `der(theta).start`; values are numbers or
        sequences of them, in SI units. `samples` are drawn by the caller: entry k of all of them belongs to sample k.
        Every column has an axis for each sequence, `sample` and `time`; `status`, `message` and `ended` tell how each
        run went: a run that fails ends no sweep. With `output` (.nc, .parquet, .csv) finished runs are kept on disk,
        and `resume` goes on after an interruption. `jobs` is the number of threads (default: the cores), `scheduler`
        the address of a Dask cluster to use instead. The rest is as for `simulate`.

        Raises KeyError and ValueError for arguments that do not fit, OSError for a file that cannot be written,
        ModuleNotFoundError without the extra `sweep`.
        """
        from lagdsl.api.sweep import run_sweep

        return run_sweep(
            self._compilation,
            values,
            samples or {},
            engine=self._engine.name,
            stop=stop,
            interval=interval,
            tolerance=tolerance,
            inputs=signals_of(self._compilation.flat, inputs),
            solver=solver,
            columns=columns,
            output=None if output is None else Path(output),
            resume=resume,
            jobs=jobs,
            scheduler=scheduler,
            progress=progress,
        )

    # ---- small motions -----------------------------------------------------------------------------------------------

    def linearize(
        self,
        *,
        t: float | None = None,
        q: Given = None,
        qd: Given = None,
        z: Given = None,
        u: Given = None,
        p: Given = None,
        sink: Sink | None = None,
    ) -> Linearization:
        """`.A .B .C .D` on the minimal state, exact, in SI units, with `.states .inputs .outputs`.

        Vectors in the order of the model's names, or mappings of some of them; what is left out is that of the initial
        state. The point is the consistent state nearest to it, `.point`. Raises CompilationFailed where there is no
        linearization.
        """
        from lagdsl.analysis.where import linearize

        return linearize(self._system, self._where(t, q, qd, z, u, p), Sink() if sink is None else sink)

    def modes(
        self,
        *,
        t: float | None = None,
        q: Given = None,
        qd: Given = None,
        z: Given = None,
        u: Given = None,
        p: Given = None,
        trim: bool = False,
        sink: Sink | None = None,
    ) -> Modes:
        """`.eigenvalues .frequencies [Hz] .damping .shapes .stability` of the linearized motion.

        The point is as for `linearize`; with `trim` it is the equilibrium next to it. Warnings go to `sink`. Raises
        CompilationFailed.
        """
        from lagdsl.analysis.where import modes

        where = replace(self._where(t, q, qd, z, u, p), trim=trim)
        return modes(self._system, where, Sink() if sink is None else sink)

    def vary(
        self,
        name: str,
        values: ArrayLike | str,
        *,
        t: float | None = None,
        q: Given = None,
        qd: Given = None,
        z: Given = None,
        u: Given = None,
        p: Given = None,
        trim: bool = False,
    ) -> Variation:
        """Eigenvalues for `values` of the parameter, input or start value `name`, and `.thresholds` between them.

        `values` are numbers in SI units or a text, `0:0.1:3 N` (first:step:last), `linspace(0, 3, 31) N`. With `trim`
        each value has the equilibrium next to the given state, else the state itself. Raises CompilationFailed.
        """
        from lagdsl.analysis.where import vary
        from lagdsl.api.texts import grid_of

        where = replace(self._where(t, q, qd, z, u, p), trim=trim)
        return vary(self._system, where, name, grid_of(self._compilation.flat, name, values), Sink())

    def trim(
        self,
        *,
        free: Sequence[str] = (),
        hold: Sequence[str] = (),
        steady: bool = False,
        t: float | None = None,
        q: Given = None,
        qd: Given = None,
        z: Given = None,
        u: Given = None,
        p: Given = None,
    ) -> Equilibrium:
        """The equilibrium nearest to a state: `.point` with `.q .qd .z .u`.

        Unknown are coordinates and states that are not fixed, without those in `hold` and with those in `free`, which
        may be inputs and rates, too. Rates that are not given are zero, or with `steady` those of the start. Raises
        CompilationFailed with what is left over where there is none.
        """
        from lagdsl.analysis.where import trim

        chosen = self._where(t, q, qd, z, u, p)
        where = replace(chosen, trim=True, free=tuple(free), hold=tuple(hold), steady=steady)
        return trim(self._system, where, Sink())

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
        with_source: bool = False,
        progress: Callable[[float], None] | None = None,
        sink: Sink | None = None,
    ) -> None:
        """Write the model to `path` as an FMU of FMI 2.0 or 3.0, checked and run once before it appears.

        `platforms` are those that binaries are made for, `linux-x86_64`, `windows-x86_64`...; default: this machine's.
        `parameters` and `start`, by name in SI units, become the defaults of the FMU. `with_source` puts the text of
        the model into it. Notes go to `sink`. Raises CompilationFailed where there is no FMU of this model or it cannot
        be made here, OSError where `path` cannot be written, KeyError and ValueError for arguments that do not fit.
        """
        from lagdsl.api.fmu import export_fmu

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
            engine=self._engine.name,
            sink=sink,
            progress=progress,
        )

    @property
    def _system(self) -> System:
        from lagdsl.analysis.point import System

        return System(self._compilation.flat, self._compilation.program, self._engine)

    def _where(self, t: float | None, q: Given, qd: Given, z: Given, u: Given, p: Given) -> Where:
        from lagdsl.analysis.where import Where

        starts = self._named("start")
        coordinates, states = ({name: starts[name] for name in names} for names in (self.coordinates, self.states))
        rates = entries("qd", qd, coordinates).items()
        start = {**entries("q", q, coordinates), **{f"der({name})": value for name, value in rates}}
        inputs = entries("u", u, self._named("input"))
        start |= entries("z", z, states)
        return Where(p=self._parameter_vector(p), t=t, start=start, inputs=inputs)
