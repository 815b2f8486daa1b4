"""From the rows and notes of a run to a trajectory."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import replace

from lagdsl.derivation.program.program import Layout
from lagdsl.engines.runtime.run import Run
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record, remembered
from lagdsl.language.flat.display import Display, display, display_rate
from lagdsl.language.flat.listing import discrete_outputs
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.aliases import other_names
from lagdsl.motion.signals.moved import MovedRow
from lagdsl.motion.signals.sensitivities import Sensitivities
from lagdsl.motion.signals.trajectory import Columns, Event, Head, InvariantRecord, Statistics, Table, Trajectory


@record(kw_only=True)
class Recorded:
    """Records along a motion. `columns` are those of the result, the time first, with the lowest and highest
    values `ends` (2, columns but for time) in between; `drifts` (3, ni) are the start, the size and the largest drift
    of every invariant, `limits` the permitted ones."""

    columns: Table
    ends: Floats
    checks: Table
    notes: Sequence[tuple[float, str, int]]
    drifts: Floats
    limits: Floats | None
    sensitivities: Sensitivities | None = None


def recorded_by(flat: FlatModel, run: Run, tangents: Sequence[str] = ()) -> Recorded:
    """All that a run has recorded so far."""
    places = _columns_of_rows(flat)
    whole = run.results.rows().T.copy()
    ends = run.results.extremes()
    if isinstance(places, list):
        ends = ends[:, [place - 1 for place in places[1:]]]
    return Recorded(
        columns=whole[places],
        ends=ends,
        checks=whole[-3:],
        notes=run.results.notes,
        drifts=run.results.drifts,
        limits=run.settings.invariant_tolerance,
        sensitivities=sensitivities_of(flat, run, tangents) if tangents else None,
    )


def trajectory(
    flat: FlatModel,
    layout: Layout,
    recorded: Recorded,
    moved: tuple[MovedRow, ...],
    statistics: Statistics,
    finer: Callable[[bool], Trajectory | None] | None = None,
) -> Trajectory:
    """The records, by the names of the model."""
    derivatives = recorded.sensitivities
    events = events_of(flat, layout, recorded.notes)
    return Trajectory(
        model=flat.name,
        columns=Columns(heads_of(flat), recorded.columns, recorded.ends, other_names(flat)),
        checks=recorded.checks,
        invariants=_invariants(flat, recorded) if flat.invariants else (),
        moved=moved,
        statistics=statistics,
        events=events if derivatives is None else differentiated(events, derivatives.names, derivatives.times),
        finer=finer,
        sensitivities=derivatives,
    )


def events_of(flat: FlatModel, layout: Layout, notes: Sequence[tuple[float, str, int]]) -> tuple[Event, ...]:
    """The notes of a run with the names of what something happened to."""
    if not notes:
        return ()
    names = event_names(flat, layout)
    return tuple(Event(time=t, name=names[what][which], kind=what) for t, what, which in notes)


def differentiated(events: tuple[Event, ...], names: Sequence[str], times: Floats) -> tuple[Event, ...]:
    """With the derivatives of their times (events, names)."""
    return tuple(
        replace(event, derivatives=dict(zip(names, each, strict=True)))
        for event, each in zip(events, times.tolist(), strict=True)
    )


def _invariants(flat: FlatModel, recorded: Recorded) -> tuple[InvariantRecord, ...]:
    """Drift of every invariant."""
    limits = [] if recorded.limits is None else recorded.limits.tolist()
    return tuple(
        InvariantRecord(name=i.name, start=start, drift=drift, limit=limit * size)
        for i, start, size, drift, limit in zip(flat.invariants, *recorded.drifts.tolist(), limits, strict=True)
    )


def event_names(flat: FlatModel, layout: Layout) -> dict[str, Sequence[str]]:
    """By kind of event, the names of what it may happen to, in the order of the runtime."""
    contacts = [each.name for each in flat.events.contacts]
    frictions = [each.name for each in flat.events.frictions]
    relations = [*(each.name for each in flat.events.relations), *(each.name for each in flat.events.timed)]
    return {
        "tick": [each.name for each in flat.events.clocks],
        **dict.fromkeys(("true", "false", "jump"), relations),
        **dict.fromkeys(("slips", "sticks", "reverses"), frictions),
        **dict.fromkeys(("opened", "closed", "impact"), contacts),
        "reinit": layout.instants.resets,
        "terminate": layout.instants.stops,
        "warning": [*layout.assertions, *layout.instants.failures],
    }


@remembered
def heads_of(flat: FlatModel) -> tuple[Head, ...]:
    """Names, units and kinds of the columns, in the order of result files. Discrete outputs stand among the outputs."""
    heads: list[Head] = [("time", "s", "time", Display("s"))]
    heads += [(c.name, c.unit, "coordinate", display(c)) for c in flat.coordinates]
    for c in flat.coordinates:
        unit = "1/s" if c.unit == "1" else f"{c.unit}/s"
        heads.append((f"der({c.name})", unit, "rate", display_rate(c)))
    heads += [(s.name, s.unit, "state", display(s)) for s in flat.states]
    outputs = discrete_outputs(flat)
    heads += [(d.name, d.unit, "discrete", display(d)) for d in flat.events.discretes if d.name not in outputs]
    heads += [(o.name, o.unit, "output", display(o)) for o in flat.outputs]
    return tuple(heads)


def called_heads(flat: FlatModel) -> dict[str, Head]:
    """Heads of the columns by all names: those of the results, then other names of coordinates and rates, with the
    other name in the head."""
    heads = {head[0]: head for head in heads_of(flat)}
    others = {other: heads[name] for name, each in other_names(flat).items() for other in each}
    return heads | {other: (other, *head[1:]) for other, head in others.items()}


def asked(flat: FlatModel, column: str, wanted: Collection[str] | None) -> list[str]:
    """The names of a column that are wanted; its own where nothing is said."""
    if wanted is None:
        return [column]
    return [name for name in (column, *other_names(flat).get(column, ())) if name in wanted]


@remembered
def places_of_columns(flat: FlatModel) -> list[int]:
    """Place of each column in a row of the runtime, which has all discrete variables, then all outputs."""
    outputs = discrete_outputs(flat)
    first = 1 + 2 * len(flat.coordinates) + len(flat.states)
    discretes = [first + k for k, item in enumerate(flat.events.discretes) if item.name not in outputs]
    end = first + len(flat.events.discretes)
    return [*range(first), *discretes, *range(end, end + len(flat.outputs))]


@remembered
def _columns_of_rows(flat: FlatModel) -> slice | list[int]:
    """The same, as one piece where it is one."""
    places = places_of_columns(flat)
    return slice(len(places)) if places == list(range(len(places))) else places


def sensitivities_of(flat: FlatModel, run: Run, names: Sequence[str]) -> Sensitivities:
    """Derivatives of all rows so far."""
    found = run.results.derivatives()
    return Sensitivities(names=tuple(names), table=found.rows(), times=found.times(), places=_places_of_names(flat))


@remembered
def _places_of_names(flat: FlatModel) -> dict[str, int | None]:
    """Places of all names in a row of derivatives, which has no time: it does not change."""
    columns = zip(heads_of(flat), places_of_columns(flat), strict=True)
    places = {head[0]: place - 1 if place else None for head, place in columns}
    others = {other: places[name] for name, each in other_names(flat).items() for other in each if name in places}
    return places | others
