"""Why a run ended, in the user's names: from the status of the runtime to a diagnostic."""

from __future__ import annotations

from typing import Any, Literal, TypeAlias, assert_never

import numpy as np

from lagdsl.derivation.program.program import Layout
from lagdsl.derivation.structure.names import located, place
from lagdsl.engines.runtime.run_view import Fault, RunView
from lagdsl.engines.runtime.structures import Status
from lagdsl.foundation.diagnostics import Label, Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.event_flow import branches
from lagdsl.language.flat.events import Branch, Check, Contact, Entry, Friction, Reset, entries
from lagdsl.language.flat.model import Constraint, FlatModel
from lagdsl.language.flat.quantity import Item
from lagdsl.motion.simulate.state_words import component_name, evaluator_at, state_text, time_text, zero_norm

# Steps are at least so many units in the last place of time.
_LEAST_STEP = 16.0 * 2.0**-52
# Of the inertias: with less, accelerations are known to half of their digits at most.
_NEARLY_CANCELLED = 1e-8
_EventStatus: TypeAlias = Literal[
    Status.EVENT_ITERATION_FAILED,
    Status.CHATTER,
    Status.PENETRATION,
    Status.CONFLICT,
    Status.ASSERTION_FAILED,
    Status.POSITION_JUMP,
    Status.WAY_JUMP,
]
_BLAMED = {
    Status.EVENT_ITERATION_FAILED: "E0804",
    Status.CHATTER: "E0833",
    Status.PENETRATION: "E0834",
    Status.WAY_JUMP: "E0836",
}


@record()
class Course:
    """Data for the words of a fault; `last` is the stop time of the run."""

    flat: FlatModel
    layout: Layout
    run: RunView
    last: float
    most_steps: int


def report_fault(course: Course, status: Status, fault: Fault, u: Floats, sink: Sink) -> str | None:
    """Reports why the run ended at `fault`, with inputs u (nu,). Returns the name at fault."""
    flat, layout = course.flat, course.layout
    match status:
        case Status.SINGULAR:
            coordinate = flat.coordinates[fault.which]
            return _told(course, "E0806", fault, coordinate, sink, name=coordinate.name)
        case Status.MOMENTUM_UNREACHABLE:
            coordinate = flat.coordinates[fault.which]
            return _told(course, "E0840", fault, coordinate, sink, name=coordinate.name)
        case Status.NO_FORCES:
            return _report_no_forces(course, fault, sink)
        case Status.NOT_FINITE:
            return _report_not_finite(course, fault, u, sink)
        case Status.STEP_TOO_SMALL:
            name = component_name(flat, fault.which)
            step, more = f"{_LEAST_STEP * course.last:.1g}", _cancelling_note(course, fault)
            return _told(course, "E0809", fault, None, sink, *more, name=name, step=step)
        case Status.PROJECTION_FAILED:
            row = _row(flat, fault.which)
            name, residual = layout.constraints[fault.which].name, f"{fault.value:.3g}"
            return _told(course, "E0811", fault, row, sink, name=name, residual=residual)
        case Status.TOO_LONG | Status.LONG_PAST:
            return _report_too_much(course, status, fault, sink)
        case Status.BRANCH_POINT:
            name = layout.constraints[fault.which].name
            span = place(_row(flat, fault.which))
            notes = (f"state: {state_text(flat, fault.x)}",)
            sink.report("E0830", span, notes=notes, time=time_text(fault.t), name=name)
            return name
        case Status.VIOLATED:
            return _report_violated(course, fault, sink)
        case (
            Status.EVENT_ITERATION_FAILED
            | Status.CHATTER
            | Status.PENETRATION
            | Status.CONFLICT
            | Status.ASSERTION_FAILED
            | Status.POSITION_JUMP
            | Status.WAY_JUMP
        ):
            code, item, text = _of_event(course, status, fault)
            return _told(course, code, fault, item, sink, text=text)
        case (
            Status.OK
            | Status.MISSING
            | Status.ATTENTION
            | Status.STOPPED
            | Status.EVENT_PENDING
            | Status.BAD_STATE_DATA
            | Status.BAD_CLOCK
            | Status.BAD_DELAY
            | Status.GRAZING
            | Status.NOT_SMOOTH
        ):
            raise AssertionError(f"the runtime ended a run with {status.name}")
        case _:
            assert_never(status)


def _report_too_much(
    course: Course, status: Literal[Status.TOO_LONG, Status.LONG_PAST], fault: Fault, sink: Sink
) -> str | None:
    """E0812 or E0898: more steps, or a longer past, than a run has room for."""
    if status is Status.TOO_LONG:
        return _told(course, "E0812", fault, None, sink, steps=course.most_steps)
    delay = course.flat.events.delays[0]
    return _told(course, "E0898", fault, delay, sink, name=delay.name)


def _told(
    course: Course, code: str, fault: Fault, item: Item | None, sink: Sink, *more: str, **arguments: Any
) -> str | None:
    notes = (f"state: {state_text(course.flat, fault.x)}", *more)
    span = item.spans[0] if item is not None and item.spans else None
    sink.report(code, span, notes=notes, time=time_text(fault.t), **arguments)
    name = arguments.get("name")
    return None if name is None else str(name)


def _row(flat: FlatModel, row: int) -> Constraint:
    return next(item.constraint for item in located(flat) if row in item.rows)


def _report_not_finite(course: Course, fault: Fault, u: Floats, sink: Sink) -> str:
    """E0813 or E0808: at this state there are no accelerations."""
    flat, time = course.flat, time_text(fault.t)
    norm = zero_norm(flat, evaluator_at(flat, course.layout, fault.t, fault.x, u, course.run.p))
    if norm is not None:
        item, element = norm
        sink.report("E0813", item.spans[0] if item.spans else None, time=time, element=element)
        return element
    n, index = len(flat.coordinates), fault.which
    name = f"der({component_name(flat, index)})"
    owner = flat.coordinates[index % n] if index < 2 * n else flat.states[index - 2 * n]
    label = Label(owner.spans[0], "its acceleration" if index < 2 * n else "its derivative") if owner.spans else None
    sink.report("E0808", label, notes=(f"state: {state_text(flat, fault.x)}",), time=time, name=name)
    return name


def _report_violated(course: Course, fault: Fault, sink: Sink) -> str:
    """E0810 for a failed assertion, E0807 for an invariant beyond its tolerance."""
    flat, time = course.flat, time_text(fault.t)
    if fault.which < len(flat.assertions):
        assertion = flat.assertions[fault.which]
        sink.report("E0810", assertion.spans[0] if assertion.spans else None, time=time, text=assertion.message)
        return assertion.message
    index = fault.which - len(flat.assertions)
    invariant = flat.invariants[index]
    unit = course.layout.invariants[index].unit
    suffix = "" if unit == "1" else f" {unit}"
    sink.report(
        "E0807",
        Label(invariant.spans[0]) if invariant.spans else None,
        notes=(_power_note(course, fault),),
        name=invariant.name,
        time=time,
        drift=f"{fault.value:.2g}{suffix}",
        limit=f"{fault.limit:.2g}{suffix}",
    )
    return invariant.name


def _power_note(course: Course, fault: Fault) -> str:
    """The largest power at this instant and where it goes in."""
    n = len(course.flat.coordinates)
    found = course.run.evaluate("power", fault.t, fault.x, 2 * n).tolist()
    powers = [
        (value * sign, kind, slot.name)
        for values, sign, kind in ((found[:n], 1.0, "loads"), (found[n:], -1.0, "dissipation"))
        for value, slot in zip(values, course.layout.coordinates, strict=True)
    ]
    value, kind, name = max(powers, key=lambda entry: abs(entry[0]), default=(0.0, "", ""))
    if value == 0.0:
        return "no declared load or dissipation has power now"
    return f"largest power: {value:.3g} W by the {kind} along `{name}`"


def _cancelling_note(course: Course, fault: Fault) -> tuple[str, ...]:
    """The coordinates whose inertias nearly cancel in a common motion, each measured by its own; none with constraints,
    where such a motion may be held."""
    coordinates = course.layout.coordinates
    n = len(coordinates)
    mass = course.run.evaluate("mass_matrix", fault.t, fault.x, n * n).reshape(n, n)
    own = np.sqrt(np.maximum(np.diag(mass), 0.0))
    if n == 0 or course.layout.constraints or not (np.isfinite(mass).all() and own.all()):
        return ()
    sizes, motions = np.linalg.eigh(mass / np.outer(own, own))
    if not sizes[0] < _NEARLY_CANCELLED:
        return ()
    names = [f"`{slot.name}`" for slot, part in zip(coordinates, motions[:, 0], strict=True) if abs(part) > 0.1]
    return (f"the inertias of {', '.join(names)} cancel in a common motion, but for a part of {sizes[0]:.1g}",)


def _report_no_forces(course: Course, fault: Fault, sink: Sink) -> str | None:
    """The frictions that act, which leave no forces."""
    frictions = course.flat.events.frictions
    named = ", ".join(f"`{each.name}`" for each in frictions)
    return _told(course, "E0843", fault, frictions[0] if frictions else None, sink, text=named)


def _of_event(course: Course, status: _EventStatus, fault: Fault) -> tuple[str, Item, str]:
    """Code, place and name of the clause that failed at an instant."""
    flat = course.flat
    actions = [action for branch in branches(flat) for action in branch.actions]
    resets = [action for action in actions if isinstance(action, Reset)]
    checks = [action for action in actions if isinstance(action, Check)]
    match status:
        case Status.EVENT_ITERATION_FAILED | Status.CHATTER | Status.PENETRATION | Status.WAY_JUMP:
            known = entries(flat.events)
            changing = [known[k] for k in course.run.guilty()]
            behind = fault.which - len(known)
            if 0 <= behind < len(resets):  # the clause that sets a state, and no condition of clauses
                reset = resets[behind]
                others = (entry for entry in changing if not isinstance(entry.item, Branch))
                changing = [Entry(reset.name, "variable", reset), *others]
            items = [entry.item for entry in changing if entry.item is not None]
            laws = (Contact, Friction)
            names = [entry.item.name if isinstance(entry.item, laws) else entry.name for entry in changing]
            told = ", ".join(f"`{name}`" for name in dict.fromkeys(names)) or "rates"
            candidates = [*items, *resets, *flat.events.frictions, *flat.events.contacts]
            return _BLAMED[status], candidates[0], told
        case Status.CONFLICT:
            return "E0832", resets[fault.which], resets[fault.which].name
        case Status.ASSERTION_FAILED:
            return "E0810", checks[fault.which], checks[fault.which].message
        case Status.POSITION_JUMP:
            return "E0835", _row(flat, fault.which), f"`{course.layout.constraints[fault.which].name}`"
        case _:
            assert_never(status)
