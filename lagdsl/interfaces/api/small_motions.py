"""Small motions of a model: linearization, modes, equilibria."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Self

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.engines.backends.python.support.values import given_once
from lagdsl.foundation.diagnostics import Sink
from lagdsl.interfaces.api.inputs.values import inputs_at
from lagdsl.interfaces.api.names import Given, Value, entries
from lagdsl.interfaces.api.shown import Shown
from lagdsl.interfaces.api.unknowns import with_starts
from lagdsl.language.settings.aliases import by_own_names

if TYPE_CHECKING:
    from lagdsl.interfaces.api.frequency_response import FrequencyResponse
    from lagdsl.interfaces.api.modes import Modes
    from lagdsl.motion.analysis.linearization import Linearization
    from lagdsl.motion.analysis.point import System
    from lagdsl.motion.analysis.trim import Equilibrium
    from lagdsl.motion.analysis.variation import Variation
    from lagdsl.motion.analysis.where import Where
    from lagdsl.motion.pipeline import Compilation
    from lagdsl.motion.signals.inputs import Signal


class SmallMotions(Shown):
    """A model near one of its states.

    Starts, parameters and inputs have the same names and forms as for `simulate`; `q`, `qd`, `z`, `p` and `u` take
    whole vectors, too.
    """

    def _of_starts(self, start: Mapping[str, object] | None) -> Self:
        """This model; with starts of joints that close loops the same with their coordinates as unknowns."""
        from lagdsl.interfaces.api.unknowns import with_unknowns

        found = with_unknowns(self._compilation, self._source, start or {})
        return self if found is None else self._made_of(found)

    def _made_of(self, compilation: Compilation) -> Self:
        """A model as this one, of another compilation."""
        raise NotImplementedError

    @with_starts
    def linearize(
        self,
        *,
        t: float | None = None,
        q: Given = None,
        qd: Given = None,
        z: Given = None,
        u: Given = None,
        p: Given = None,
        start: Mapping[str, Value] | None = None,
        parameters: Mapping[str, Value] | None = None,
        inputs: Mapping[str, Signal | str] | Path | str | None = None,
        every: float | str | None = None,
        trim: bool = False,
        sink: Sink | None = None,
    ) -> Linearization:
        """`.A .B .C .D` on the minimal state, exact, in SI units, with `.states .inputs .outputs`.

        Vectors in the order of the model's names, or mappings of some of them; what is left out is that of the initial
        state. The point is the state that a motion from there begins with, `.point`: on the constraints, behind the
        events of the start; with `trim` it is the equilibrium next to that. Raises CompilationFailed where there is no
        linearization, as between two sides of a corner.

        With `every`, in seconds or as a text with a unit, `"2 ms"`, the system is sampled: A, B, C and D lead from one
        instant to the next, inputs are held in between. In a model with clocks that is the sampled loop, states and
        discrete variables together, just before its ticks; `every` is then a multiple of the common period, and `trim`
        takes a fixed point of the loop.
        """
        from lagdsl.motion.analysis.where import linearize

        where = replace(self._where(t, (q, qd, z), u, p, start, parameters, inputs), trim=trim)
        return linearize(self._system, where, Sink() if sink is None else sink, every=_period(every))

    @with_starts
    def modes(
        self,
        *,
        t: float | None = None,
        q: Given = None,
        qd: Given = None,
        z: Given = None,
        u: Given = None,
        p: Given = None,
        start: Mapping[str, Value] | None = None,
        parameters: Mapping[str, Value] | None = None,
        inputs: Mapping[str, Signal | str] | Path | str | None = None,
        trim: bool = False,
        sink: Sink | None = None,
    ) -> Modes:
        """`.eigenvalues .frequencies [Hz] .damping .shapes .stability` of the linearized motion.

        The point is as for `linearize`; with `trim` it is the equilibrium next to it. Warnings go to `sink`. Raises
        CompilationFailed.
        """
        from lagdsl.interfaces.api.modes import modes_of

        where = replace(self._where(t, (q, qd, z), u, p, start, parameters, inputs), trim=trim)
        return modes_of(self._system, where, Sink() if sink is None else sink, self._source)

    @with_starts
    def bode(
        self,
        source: str | None = None,
        target: str | None = None,
        *,
        frequencies: ArrayLike | None = None,
        t: float | None = None,
        q: Given = None,
        qd: Given = None,
        z: Given = None,
        u: Given = None,
        p: Given = None,
        start: Mapping[str, Value] | None = None,
        parameters: Mapping[str, Value] | None = None,
        inputs: Mapping[str, Signal | str] | Path | str | None = None,
        trim: bool = False,
        every: float | str | None = None,
        sink: Sink | None = None,
    ) -> FrequencyResponse:
        """The response of the output or state `target` to sinusoids in the input `source`, which may be left out where
        there is one: `.frequencies .response .magnitude .phase .transfer .margins .plot()`.

        `frequencies` are in Hz; left out, they show all poles, zeros and crossings. The point is as for `modes`.
        `every` samples the system as for `linearize`. Warnings go to `sink`. Raises UnknownName and CompilationFailed.
        """
        from lagdsl.interfaces.api.frequency_response import FrequencyResponse
        from lagdsl.motion.analysis.where import bode

        where = replace(self._where(t, (q, qd, z), u, p, start, parameters, inputs), trim=trim)
        omega = None if frequencies is None else 2.0 * np.pi * np.atleast_1d(np.asarray(frequencies, dtype=np.float64))
        told = Sink() if sink is None else sink
        found = bode(self._system, where, told, channel=(source, target), omega=omega, every=_period(every))
        return FrequencyResponse.of(found)

    @with_starts
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
        start: Mapping[str, Value] | None = None,
        parameters: Mapping[str, Value] | None = None,
        inputs: Mapping[str, Signal | str] | Path | str | None = None,
        trim: bool = False,
    ) -> Variation:
        """Eigenvalues for `values` of the parameter, input or start value `name`, and `.thresholds` between them.

        `values` are numbers in SI units or a text, `0:0.1:3 N` (first:step:last), `linspace(0, 3, 31) N`. With `trim`
        each value has the equilibrium next to the given state, else the state itself. Raises CompilationFailed.
        """
        from lagdsl.interfaces.api.texts import grid_of
        from lagdsl.motion.analysis.where import vary

        where = replace(self._where(t, (q, qd, z), u, p, start, parameters, inputs), trim=trim)
        return vary(self._system, where, name, grid_of(self._compilation.flat, name, values), Sink())

    @with_starts
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
        start: Mapping[str, Value] | None = None,
        parameters: Mapping[str, Value] | None = None,
        inputs: Mapping[str, Signal | str] | Path | str | None = None,
    ) -> Equilibrium:
        """The equilibrium near a state, or from afar the one that the model at rest falls to: `.point` with
        `.q .qd .z .u`; `.growth` tells an unstable one.

        Unknown are coordinates and states that are not fixed, without those in `hold` and with those in `free`, which
        may be inputs and rates, too. Rates that are not given are zero, or with `steady` those of the start. Raises
        CompilationFailed with what is left over where there is none.
        """
        from lagdsl.motion.analysis.where import trim

        chosen = self._where(t, (q, qd, z), u, p, start, parameters, inputs)
        where = replace(chosen, trim=True, free=tuple(free), hold=tuple(hold), steady=steady)
        return trim(self._system, where, Sink())

    @property
    def _system(self) -> System:
        from lagdsl.motion.analysis.point import System

        return System(self._compilation.flat, self._compilation.program, self._engine)

    def _where(
        self,
        t: float | None,
        state: tuple[Given, Given, Given],
        u: Given,
        p: Given,
        start: Mapping[str, Value] | None,
        parameters: Mapping[str, Value] | None,
        inputs: Mapping[str, Signal | str] | Path | str | None,
    ) -> Where:
        from lagdsl.motion.analysis.where import Where

        if inputs is not None and u is not None:
            raise ValueError("u and inputs are two names of one argument: give one of them")
        if parameters is not None:
            p = given_once("p", p, "parameters", parameters)
        starts, flat = self._named("start"), self._compilation.flat
        coordinates, states = ({name: starts[name] for name in names} for names in (self.coordinates, self.states))
        q, qd, z = (by_own_names(flat, given) if isinstance(given, Mapping) else given for given in state)
        rates = entries("qd", qd, coordinates).items()
        found = {**entries("q", q, coordinates), **{f"der({name})": value for name, value in rates}}
        found |= entries("z", z, states)
        for name, value in self._start_values(start).items():
            if name in found:
                raise ValueError(f"the start of `{name}` is given twice")
            found[name] = value
        time = flat.experiment.start_time if t is None else t
        given = entries("u", u, self._named("input")) if inputs is None else inputs_at(flat, inputs, time)
        return Where(p=self._parameter_vector(p), t=t, start=found, inputs=given)


def _period(every: float | str | None) -> float | None:
    """In seconds. Raises CallRefused."""
    from lagdsl.motion.simulate.control import seconds

    return None if every is None else seconds("`every`", every)
