"""The state of an analysis: starts and inputs by name, parameters, and the choice to search for an equilibrium from
there."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import TypeVar

import numpy as np

from lagdsl.derivation.structure.count import counted
from lagdsl.derivation.structure.names import balanced_coordinates
from lagdsl.foundation.diagnostics import Sink, failed
from lagdsl.foundation.diagnostics.suggest import listing
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.units.naming import rate_text
from lagdsl.language.flat.spans import around, place
from lagdsl.language.settings.aliases import own_name
from lagdsl.motion.analysis.bode import bode_at, sampled_bode
from lagdsl.motion.analysis.control.frequency_response import FrequencyResponse
from lagdsl.motion.analysis.delayed import delayed_bode
from lagdsl.motion.analysis.held import report_held, sampled
from lagdsl.motion.analysis.integrable import integrable_rows
from lagdsl.motion.analysis.linearization import Linearization, linearize_at
from lagdsl.motion.analysis.linearize import Named, holonomic_rows
from lagdsl.motion.analysis.modes import Modes, modes_at
from lagdsl.motion.analysis.point import Point, System, point_of
from lagdsl.motion.analysis.sampled.modes import trimmed
from lagdsl.motion.analysis.sampled_linearization import sampled_linearization
from lagdsl.motion.analysis.trim import Equilibrium, trim_at
from lagdsl.motion.analysis.variation import Variation, variation
from lagdsl.motion.signals.inputs import report_missing

_Result = TypeVar("_Result")


@dataclass(frozen=True, slots=True, kw_only=True)
class Where:
    """`start`: coordinates, rates `der(x)` and states by name, SI units; what is left out are the model's.

    With `trim` the equilibrium nearest to it is meant; `free` and `hold` then name unknowns, and rates that are not
    named are zero, or with `steady` the model's.
    """

    p: Floats
    t: float | None = None
    start: Mapping[str, float] = field(default_factory=dict)
    inputs: Mapping[str, float] = field(default_factory=dict)
    trim: bool = False
    free: tuple[str, ...] = ()
    hold: tuple[str, ...] = ()
    steady: bool = False


def linearize(system: System, where: Where, sink: Sink, *, every: float | None = None) -> Linearization:
    """With `every` [s] the sampled system, of a model with clocks the sampled loop. Raises CompilationFailed; warnings
    go to `sink`."""
    _refuse_delays(system, "linearization")
    _report_assumed(system, where, sink, holds=every is None)
    if every is None:
        return _found(sink, lambda own: linearize_at(system, point(system, where, own), own))
    return _found(sink, lambda own: _sampled(system, where, every, own))


def _sampled(system: System, where: Where, every: float, sink: Sink) -> Linearization | None:
    at = loop_point(system, where, sink)
    return None if at is None else sampled_linearization(system, at, every, sink)


def bode(
    system: System,
    where: Where,
    sink: Sink,
    *,
    channel: tuple[str | None, str | None] = (None, None),
    omega: Floats | None = None,
    every: float | None = None,
) -> FrequencyResponse:
    """From one input to one output or state, at angular frequencies `omega` [rad/s], else at those that show poles,
    zeros and crossings; with `every` [s] of the sampled system. Raises CompilationFailed; warnings go to `sink`."""
    if every is not None or where.trim:
        _refuse_delays(system, "sampled linearization" if every is not None else "search for equilibria")
    _report_assumed(system, where, sink, holds=every is None)

    def search(own: Sink) -> FrequencyResponse | None:
        if every is None:
            respond = delayed_bode if system.flat.events.delays else bode_at
            return respond(system, point(system, where, own), channel, omega, own)
        linear = _sampled(system, where, every, own)
        return None if linear is None else sampled_bode(linear, channel, omega)

    return _found(sink, search)


def modes(system: System, where: Where, sink: Sink) -> Modes:
    """Raises CompilationFailed; warnings go to `sink`."""
    _refuse_delays(system, "modes")
    _report_assumed(system, where, sink, holds=not sampled(system))

    def search(own: Sink) -> Modes | None:
        at = loop_point(system, where, own)
        return None if at is None else modes_at(system, at, own)

    return _found(sink, search)


def trim(system: System, where: Where, sink: Sink) -> Equilibrium:
    """Raises CompilationFailed; warnings go to `sink`."""
    _refuse_delays(system, "search for equilibria")
    _report_assumed(system, where, sink)
    found = _found(sink, lambda own: _equilibrium(system, where, own))
    if found.growth and not sampled(system):
        sink.report("W0869", None, count=counted(len(found.growth), "growing mode"), rate=f"{found.growth[0]:.3g}")
    return found


def vary(system: System, where: Where, name: str, values: Floats, sink: Sink) -> Variation:
    """Eigenvalues for values of a parameter, an input or a start value. Raises CompilationFailed."""
    _refuse_delays(system, "modes")
    varied = _varied(system, name, sink)
    given = replace(where, inputs={**where.inputs, varied.name: 0.0})
    _report_assumed(system, given, sink, holds=not sampled(system))
    held = [*holonomic_rows(system), *integrable_rows(system, point(system, replace(where, trim=False), Sink()))]

    def placed(value: float) -> Point:
        own = Sink()
        found = loop_point(system, _with(system, where, varied.name, value), own)
        if found is None:
            raise failed(own.diagnostics)
        own.raise_if_errors()
        return found

    return variation(system, varied, values.tolist(), placed, held)


def point(system: System, where: Where, sink: Sink) -> Point:
    """The state that a motion begins with, or the equilibrium near it. Raises CompilationFailed."""
    if where.trim:
        found = _equilibrium(system, where, sink)
        if found is None:
            raise failed(sink.diagnostics)
        return found.point
    return _state(system, where, where.start, sink)


def loop_point(system: System, where: Where, sink: Sink) -> Point | None:
    """As `point`; with `trim` the fixed point of the loop, where clocks close one and the unknowns are not chosen."""
    if not where.trim or where.free or where.hold or not sampled(system):
        return point(system, where, sink)
    guess = _state(system, replace(where, trim=False), where.start, sink)
    return trimmed(system, guess, sink)


def _equilibrium(system: System, where: Where, sink: Sink) -> Equilibrium | None:
    start = dict(where.start)
    free, hold = (tuple(own_name(system.flat, name) for name in names) for names in (where.free, where.hold))
    if not where.steady:
        light = balanced_coordinates(system.flat)  # forces decide about these
        still = [c.name for j, c in enumerate(system.flat.coordinates) if j not in light]
        start = {**{f"der({name})": 0.0 for name in still}, **start}
    return trim_at(system, _state(system, where, start, None), free=free, hold=hold, sink=sink)


def _state(system: System, where: Where, start: Mapping[str, float], sink: Sink | None) -> Point:
    inputs = None
    if where.inputs:
        time = system.flat.experiment.start_time if where.t is None else where.t
        defaults = system.engine.evaluate("start", time, where.p)[3].tolist()
        slots = system.engine.layout.inputs
        inputs = np.array([where.inputs.get(s.name, value) for s, value in zip(slots, defaults, strict=True)])
    given = bool(where.start) or where.trim
    begins = not where.trim
    return point_of(system, t=where.t, start=start, u=inputs, p=where.p, given=given, begins=begins, sink=sink)


def _report_assumed(system: System, where: Where, sink: Sink, *, holds: bool = True) -> None:
    """N0875 for inputs that are taken as zero; N0876 for discrete variables that are held."""
    report_missing(system.flat, [*where.inputs, *where.free], sink)
    report_held(system, sink, of_loop=not holds)


def _refuse_delays(system: System, what: str) -> None:
    """E0868: the linear system would have a characteristic function that is no polynomial."""
    sink = Sink()
    for each in system.flat.events.delays[:1]:
        sink.report("E0868", place(each), *around(each), what=what, name=each.name)
    sink.raise_if_errors()


def _found(sink: Sink, search: Callable[[Sink], _Result | None]) -> _Result:
    own = Sink()
    result = search(own)
    for diagnostic in own.diagnostics:
        sink.add(diagnostic)
    if result is None:
        raise failed(own.diagnostics)
    return result


def _varied(system: System, name: str, sink: Sink) -> Named:
    """The quantity that `name` or `name.start` stands for; E0853 if it cannot be varied."""
    flat, layout = system.flat, system.engine.layout
    known = {slot.name: slot.unit for slot in (*layout.parameters, *layout.inputs)}
    starts = {item.name: item.unit for item in (*flat.coordinates, *flat.states)}
    starts |= {f"der({c.name})": rate_text(c.dimension, c.unit) for c in flat.coordinates}
    name = own_name(flat, name)
    found = name if name in known else name.removesuffix(".start")
    if found in known or found in starts:
        return Named(found, {**starts, **known}[found])
    own = Sink()
    own.report("E0853", None, name=name, what="varied", known=listing(name, [*known, *(f"{s}.start" for s in starts)]))
    sink.add(own.diagnostics[0])
    raise failed(own.diagnostics)


def _with(system: System, where: Where, name: str, value: float) -> Where:
    parameters = [slot.name for slot in system.engine.layout.parameters]
    if name in parameters:
        p = where.p.copy()
        p[parameters.index(name)] = value
        return replace(where, p=p)
    if any(slot.name == name for slot in system.engine.layout.inputs):
        return replace(where, inputs={**where.inputs, name: value})
    return replace(where, start={**where.start, name: value})
