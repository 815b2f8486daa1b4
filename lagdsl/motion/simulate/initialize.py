"""A consistent state to start from ("Starting values" in docs/reference/language.md): found in C, reported here."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

import numpy as np
from numpy.typing import NDArray

from lagdsl.derivation.program.passes.pattern import jacobian_pattern
from lagdsl.engines.backends.start import QUATERNION, WRITTEN, Start
from lagdsl.engines.runtime.engines.engine import Engine
from lagdsl.engines.runtime.run import Run
from lagdsl.engines.runtime.run_view import Found
from lagdsl.engines.runtime.structures import InitialFault
from lagdsl.foundation.diagnostics import Diagnostic, Sink
from lagdsl.foundation.numerics.connected_blocks import Flags
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record, remembered
from lagdsl.language.flat.admissible import report_outside
from lagdsl.language.flat.model import Coordinate, FlatModel, State
from lagdsl.motion.signals.moved import MovedRow, Starts, found_rows, loops_of, moved_rows, moved_text, report_moved
from lagdsl.motion.simulate.explicit_rates import report_contradictions, turned_rates
from lagdsl.motion.simulate.initial_words import report_endless, report_found, report_no_start, report_numbers
from lagdsl.motion.simulate.placed import placed, start_values


@record(kw_only=True)
class InitialState:
    """x = (q, qd, z), with `count` coordinates, at time t, SI units, found from `starts`; `moved` tells which of them
    were changed, `freedom` counts the rates that the constraints leave free here, `loops` names the joints at which
    loops are cut, `redundant` flags the rows that depend on others near this state; `p` are the independent
    parameters, those that were found with them."""

    model: str
    t: float
    x: Floats
    starts: Floats
    count: int
    p: Floats
    freedom: int
    moved: tuple[MovedRow, ...]
    redundant: tuple[bool, ...]
    loops: tuple[str, ...] = ()

    @property
    def q(self) -> Floats:
        """Coordinates (nq,)."""
        return self.x[: self.count]

    @property
    def qd(self) -> Floats:
        """Rates (nq,)."""
        return self.x[self.count : 2 * self.count]

    @property
    def z(self) -> Floats:
        """States (nz,)."""
        return self.x[2 * self.count :]

    def __str__(self) -> str:
        return moved_text(self.model, self.freedom, self.moved, self.loops)


def initial_state(
    flat: FlatModel,
    engine: Engine,
    p: Floats | None = None,
    *,
    t0: float | None = None,
    u: Floats | None = None,
    start: Mapping[str, float] | None = None,
    sink: Sink | None = None,
) -> InitialState:
    """The state nearest to the starts that satisfies constraints, fixed values and initial equations.

    `p` are the independent parameters (default: the model's), `u` the inputs at the start, `start` further start values
    by name in SI units, also `der(theta)`. Reports errors and moved starts to `sink`; without one, errors raise
    CompilationFailed.
    """
    own = Sink() if sink is None else sink
    parameters = np.array(engine.layout.defaults, dtype=np.float64) if p is None else p
    t = flat.experiment.start_time if t0 is None else t0
    with np.errstate(all="ignore"):
        inputs = start_values(engine, t, parameters)[1] if u is None else u
        run = placed(flat, engine, parameters, inputs, t0=t)
        found = find_start(flat, engine, run, t, inputs, start or {}, own)
        run.leave()
    if sink is None:
        own.raise_if_errors()
    return found


def find_start(
    flat: FlatModel, engine: Engine, run: Run, t: float, u: Floats, start: Mapping[str, float], sink: Sink
) -> InitialState:
    """The same for a run that has not begun; `u` are its inputs then. The last start is kept: found from the same, it
    is told again, with what was reported."""
    # Free parameters and inputs that change are looked at by the search itself.
    lasting = isinstance(run.settings.inputs, np.ndarray) and not run.settings.measures.start.free
    key = (flat, t, run.settings.p.tobytes(), u.tobytes(), tuple(start.items())) if lasting else None
    for known, kept in run.model.found[:1]:
        if key is not None and known == key:
            assert isinstance(kept, _Kept), "starts alone are kept"
            return kept.again(run, sink)
    own = Sink()
    found, initial = _searched(flat, engine, run, t, u, start, own)
    for diagnostic in own.diagnostics:
        sink.add(diagnostic)
    if key is not None and not own.has_errors:
        run.model.found[:] = [(key, _Kept(found, _apart(initial), own.diagnostics))]
    return initial


@record()
class _Kept:
    """A start with what was reported about it. Nobody may change it."""

    found: Found
    initial: InitialState
    reported: tuple[Diagnostic, ...]

    def again(self, run: Run, sink: Sink) -> InitialState:
        """For another run."""
        run.find_again(self.initial.t, self.found)
        for diagnostic in self.reported:
            sink.add(diagnostic)
        return _apart(self.initial)


def _apart(initial: InitialState) -> InitialState:
    """The same with arrays of its own."""
    return InitialState(
        model=initial.model,
        t=initial.t,
        x=initial.x.copy(),
        starts=initial.starts.copy(),
        count=initial.count,
        p=initial.p.copy(),
        freedom=initial.freedom,
        moved=initial.moved,
        redundant=initial.redundant,
        loops=initial.loops,
    )


def _searched(
    flat: FlatModel, engine: Engine, run: Run, t: float, u: Floats, start: Mapping[str, float], sink: Sink
) -> tuple[Found, InitialState]:
    """By a search; errors and moved starts go to `sink`."""
    given = _by_place(flat, start, sink) if start else {}
    found = run.find(t, given, equations=bool(flat.initial_equations))
    _report_outside(flat, found.starts, given, sink)
    if not report_numbers(flat, found.starts, u, sink):
        report_no_start(flat, engine.layout, run, t, found, sink)
    if found.fault is InitialFault.NONE:
        if found.moved:
            report_endless(flat, engine.layout, run, t, found, sink)
        report_found(flat, engine.layout, found.p, sink)
    rows = tuple[MovedRow, ...]()
    if not sink.has_errors:
        if found.moved:
            rows = _moved(flat, run, t, found, _starts(flat, engine, run, found, given), sink)
        rows += found_rows(flat, engine.layout, run.settings.p, found.p)
    return found, InitialState(
        model=flat.name,
        t=t,
        x=found.x,
        starts=found.starts,
        count=len(flat.coordinates),
        p=found.p,
        freedom=found.freedom,
        moved=rows,
        redundant=tuple(found.dependent.tolist()),
        loops=loops_of(flat),
    )


def _moved(flat: FlatModel, run: Run, t: float, found: Found, starts: Starts, sink: Sink) -> tuple[MovedRow, ...]:
    """Everything that was moved. It is reported unless initial equations say themselves that starts are to be moved."""
    rows = moved_rows(starts, found.x, partial(_outputs, flat, run, t, found))
    if not flat.initial_equations:
        if flat.constraints:
            report_contradictions(starts, run, t, found, sink)
        if not sink.has_errors:
            report_moved(starts, rows, sink)
    return rows


@remembered
def places_of(flat: FlatModel) -> dict[str, int]:
    """The places in (q, qd, z) by the names of start values."""
    coordinates = [c.name for c in flat.coordinates]
    names = [*coordinates, *(f"der({name})" for name in coordinates), *(s.name for s in flat.states)]
    return {name: place for place, name in enumerate(names)}


def _by_place(flat: FlatModel, start: Mapping[str, float], sink: Sink) -> dict[int, float]:
    """Start values by their place in (q, qd, z); E0805 for a name that has none."""
    places = places_of(flat)
    for name in start:
        if name not in places:
            sink.report("E0805", None, name=name, known=", ".join(places))
    return {places[name]: value for name, value in start.items() if name in places}


def _report_outside(flat: FlatModel, starts: Floats, given: Mapping[int, float], sink: Sink) -> None:
    """W0328 for start values outside of their bounds."""
    for place, item in _bounded(flat).items():
        if place in given or item.start_explicit:
            report_outside(item, f"{item.name}(start)", float(starts[place]), sink)


@remembered
def _bounded(flat: FlatModel) -> dict[int, Coordinate | State]:
    """Coordinates and states that have bounds, by their place in (q, qd, z)."""
    items = dict(enumerate(flat.coordinates)) | dict(enumerate(flat.states, 2 * len(flat.coordinates)))
    return {place: item for place, item in items.items() if item.minimum is not None or item.maximum is not None}


@remembered
def _flags(told: Start) -> tuple[Flags, Flags, NDArray[np.intp]]:
    """Flags of fixed and of written starts (2 nq + nz,), and the places of the first rates of quaternions."""
    flags = np.array(told.written, dtype=np.uint8)
    return np.array(told.fixed, dtype=np.bool_), (flags & WRITTEN) != 0, np.flatnonzero(flags & QUATERNION)


def _starts(flat: FlatModel, engine: Engine, run: Run, found: Found, given: Mapping[int, float]) -> Starts:
    n = len(flat.coordinates)
    measures = run.settings.measures
    fixed, written, turning = _flags(measures.start)
    if given:
        written = written.copy()
        written[list(given)] = True
    return Starts(
        flat=flat,
        x=turned_rates(found.starts, found.x, turning - n, n),
        sizes=measures.natural,
        fixed=fixed,
        written=written,
        pattern=jacobian_pattern(engine.program) if engine.program.has("position_constraint") else ((), ()),
        count=n,
    )


def _outputs(flat: FlatModel, run: Run, t: float, found: Found) -> Floats:
    """Outputs at the start, which hold the coordinates of cut joints."""
    return run.evaluate("output", t, found.x, len(flat.outputs))
