"""Why there is no start, in the user's names."""

from __future__ import annotations

from math import isfinite

import numpy as np

from lagdsl.derivation.program.program import Layout
from lagdsl.derivation.structure.constraints import ENDLESS
from lagdsl.derivation.structure.names import Located, configuration, located, place, seat, unit_suffix
from lagdsl.engines.backends.start import free_parameters
from lagdsl.engines.runtime.run import Run
from lagdsl.engines.runtime.run_view import Found, RunView
from lagdsl.engines.runtime.structures import InitialFault
from lagdsl.foundation.diagnostics import Label, Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.limits import check_limits
from lagdsl.language.flat.model import Coordinate, FlatModel
from lagdsl.language.flat.spans import place as place_of

# Residuals, as a part of the row's size, above which a constraint is said to be left over (LAG_HOLDS).
_HOLDS = 1e-7
# In natural sizes: a start that was moved this far ran away, and a step as long as this does not lead to a zero nearby.
FAR = 1e4
_LONG_STEP = 0.1
_MOST_JOINTS = 6
_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth")


def report_no_start(
    flat: FlatModel, layout: Layout, run: RunView, t: float, found: Found, sink: Sink, *, searched: bool = True
) -> None:
    """E0801, E0802, E0803, E0815, E0816, E0831, E0837, E0838, E0839 or E0842, if there is no start; E0839 only if it is
    `searched` for."""
    unmet = found.fault in (InitialFault.POSITIONS, InitialFault.RATES, InitialFault.EQUATIONS)
    if searched and unmet and flat.initial_equations:
        from lagdsl.derivation.structure.contradictions import report_contradiction  # few models contradict themselves

        if report_contradiction(flat, layout, run, t, found, sink):
            return
    match found.fault:
        case InitialFault.NONE:
            return
        case InitialFault.NUMBERS:
            _report_numbers(layout, run, t, found, sink)
        case InitialFault.POSITIONS if not found.excess:
            _report_positions(flat, layout, run, t, found, sink)
        case InitialFault.RATES:
            _report_rates(flat, layout, found, sink)
        case InitialFault.EQUATIONS if not (found.excess and any(c.fixed for c in flat.coordinates)):
            first = flat.initial_equations[0]
            sink.report("E0815", first.spans[0] if first.spans else None, residual=f"{found.residual:.3g}")
        case InitialFault.POSITIONS | InitialFault.EQUATIONS:
            _report_overdetermined(flat, found, sink)
        case InitialFault.RANK | InitialFault.SIZES:
            _report_rows(flat, layout, found, sink)
        case InitialFault.PARAMETERS:
            name = layout.parameters[found.which].name
            parameter = next(p for p in flat.parameters if p.name == name)
            sink.report("E0837", place_of(parameter), name=name)
        case InitialFault.BOUNDS:
            _report_bounds(flat, layout, found, sink)


def report_numbers(flat: FlatModel, starts: Floats, u: Floats, sink: Sink) -> bool:
    """E0816 for every start value and input that is not a number; whether there is any."""
    if all(map(isfinite, starts.tolist())) and all(map(isfinite, u.tolist())):
        return False
    names = [
        *(c.name for c in flat.coordinates),
        *(f"der({c.name})" for c in flat.coordinates),
        *(s.name for s in flat.states),
        *(i.name for i in flat.inputs),
    ]
    values = [*starts.tolist(), *u.tolist()]
    wrong = [name for name, value in zip(names, values, strict=True) if not np.isfinite(value)]
    for name in wrong:
        sink.report("E0816", None, name=name)
    return True


def report_found(flat: FlatModel, layout: Layout, p: Floats, sink: Sink) -> None:
    """E0334 for what is told to events with the free parameters in p (np,), which were found."""
    if free_parameters(flat):
        check_limits(flat, _values(layout, p), sink)


def _values(layout: Layout, p: Floats) -> dict[str, float]:
    return {slot.name: value for slot, value in zip(layout.parameters, p.tolist(), strict=True)}


def _report_bounds(flat: FlatModel, layout: Layout, found: Found, sink: Sink) -> None:
    """Every parameter that was found outside of its bounds."""
    values = _values(layout, found.p)
    for parameter in flat.parameters:
        low, high = parameter.minimum, parameter.maximum
        value = values.get(parameter.name, parameter.value)
        for word, bound, outside in (
            ("min", low, low is not None and value < low),
            ("max", high, high is not None and value > high),
        ):
            if parameter.free and outside and bound is not None:
                unit = "" if parameter.unit == "1" else f" {parameter.unit}"
                sink.report(
                    "E0838",
                    place_of(parameter),
                    name=parameter.name,
                    value=f"{value:.6g}{unit}",
                    which=word,
                    limit=f"{bound:g}{unit}",
                )


def _report_numbers(layout: Layout, run: RunView, t: float, found: Found, sink: Sink) -> None:
    """Rows that are no numbers at the start values."""
    count = len(layout.constraints)
    rows = [
        run.evaluate(function, t, found.starts, count * (1 + len(layout.coordinates)))[:count]
        for function in ("position_constraint", "velocity_constraint")
    ]
    for slot, position, velocity in zip(layout.constraints, *rows, strict=True):
        if not np.isfinite(position) or not np.isfinite(velocity):
            sink.report("E0816", None, name=slot.name)


def _report_positions(flat: FlatModel, layout: Layout, run: RunView, t: float, found: Found, sink: Sink) -> None:
    n, count = len(layout.coordinates), len(layout.constraints)
    phi = run.evaluate("position_constraint", t, found.x, count * (1 + n))[:count]
    sizes = np.where(np.isfinite(phi), np.abs(phi) / found.row_sizes, np.inf)
    items = located(flat)
    item = _item(items, found.which)
    name = seat(item.constraint) if item.constraint.closure else layout.constraints[found.which].name
    sink.report(
        "E0802",
        place(item.constraint),
        notes=(f"configuration reached: {configuration(flat, found.x[:n])}", *_left_over(items, layout, phi, sizes)),
        residual=f"{found.residual:.3g}{unit_suffix(item.constraint)}",
        name=name,
    )


def report_endless(flat: FlatModel, layout: Layout, run: Run, t: float, found: Found, sink: Sink) -> None:
    """E0802 for rows such as x/(1 + x^2) that count as met far away, where they are small: a zero nearby is as far
    along their gradient as the start has moved."""
    n, count = len(layout.coordinates), len(layout.constraints)
    natural = run.settings.measures.natural[:n]
    moved = np.abs(found.x[:n] - found.starts[:n]) > FAR * natural
    if not moved.any():
        return
    values = run.evaluate("position_constraint", t, found.x, count * (1 + n))
    slopes = np.linalg.norm(values[count:].reshape(count, n) * natural * moved, axis=1)
    for item in located(flat):
        endless = [r for r in item.rows if layout.position_level[r] and abs(values[r]) > _LONG_STEP * slopes[r] > 0.0]
        if endless and not item.constraint.of_law:
            residual = f"{abs(values[endless[0]]):.3g}{unit_suffix(item.constraint)}"
            name = seat(item.constraint) if item.constraint.closure else layout.constraints[endless[0]].name
            notes = (f"configuration reached: {configuration(flat, found.x[:n])}", ENDLESS)
            sink.report("E0802", place(item.constraint), notes=notes, residual=residual, name=name)


def _left_over(items: list[Located], layout: Layout, phi: Floats, sizes: Floats) -> tuple[str, ...]:
    """Residual of each joint or constraint, the largest first, if there are several."""
    held = {row for row, level in enumerate(layout.position_level) if level}
    open_ = [item for item in items if any(sizes[row] > _HOLDS for row in item.rows if row in held)]
    open_.sort(key=lambda item: -max(float(sizes[row]) for row in item.rows))
    parts = [
        f"{float(np.linalg.norm(phi[list(item.rows)])):.3g}{unit_suffix(item.constraint)} at `{seat(item.constraint)}`"
        for item in open_[:_MOST_JOINTS]
    ]
    more = f" and at {len(open_) - _MOST_JOINTS} more" if len(open_) > _MOST_JOINTS else ""
    return (f"left over: {', '.join(parts)}{more}",) if len(parts) > 1 else ()


def _report_overdetermined(flat: FlatModel, found: Found, sink: Sink) -> None:
    """At the last fixed start, the others as labels."""
    fixed = [c for c in flat.coordinates if c.fixed]
    spans = [span for c in fixed if (span := c.start_span or (c.spans[0] if c.spans else None)) is not None]
    freedom = found.general
    degrees = f"{freedom} degree{'s' if freedom != 1 else ''} of freedom"
    many = "one coordinate" if freedom == 1 else f"{freedom} coordinates"
    can = f"so {many} can be fixed" if freedom else "so no coordinate can be fixed"
    shown = [f"`{c.name}`" for c in fixed[:_MOST_JOINTS]]
    more = f" and {len(fixed) - _MOST_JOINTS} more" if len(fixed) > _MOST_JOINTS else ""
    sink.report(
        "E0801",
        Label(spans[-1], _ordinal(len(fixed), fixed[-1])) if spans else None,
        *(Label(span, "fixed as well") for span in dict.fromkeys(spans[:-1]) if span != spans[-1]),
        *(Label(span, "holds at the start") for span in dict.fromkeys(map(place_of, flat.initial_equations)) if span),
        notes=(f"the mechanism has {degrees}, {can}; fixed are {', '.join(shown)}{more}",),
        excess=found.excess,
    )


def _ordinal(number: int, coordinate: Coordinate) -> str:
    """`second fixed angle`."""
    noun = "angle" if coordinate.type_name == "Angle" else "coordinate"
    if number == 1:
        return f"fixed {noun}"
    return f"{_ORDINALS[number - 1]} fixed {noun}" if number <= len(_ORDINALS) else "one fixed start too many"


def _report_rates(flat: FlatModel, layout: Layout, found: Found, sink: Sink) -> None:
    rows = len(layout.constraints)
    fixed_spans = [c.rate_start_span or c.spans[0] for c in flat.coordinates if c.rate_fixed and c.spans]
    labels = [Label(span, "fixed rate") for span in fixed_spans]
    size = f"{found.residual:.3g}"
    if found.which < rows:
        item = _item(located(flat), found.which)
        name = layout.constraints[found.which].name if item.constraint.closure is None else seat(item.constraint)
        unit = unit_suffix(item.constraint) + ("/s" if item.constraint.level == "position" else "")
        sink.report("E0803", place(item.constraint), *labels, residual=size + unit, name=name)
        return
    coordinate = flat.coordinates[found.which - rows]
    sink.report("E0803", labels[0] if labels else None, *labels[1:], residual=size, name=f"der({coordinate.name})")


def _report_rows(flat: FlatModel, layout: Layout, found: Found, sink: Sink) -> None:
    """With other parameters than those of the text more rows are independent than then, or one looks like round-off."""
    if found.fault is InitialFault.SIZES:
        name, part = layout.constraints[found.which].name, f"{found.residual:.0e}"
        sink.report("E0842", place(_item(located(flat), found.which).constraint), name=name, part=part)
        return
    rows = range(len(layout.constraints))
    row = next((row for row in rows if layout.redundant[row] and not found.dependent[row]), 0)
    sink.report(
        "E0831",
        place(_item(located(flat), row).constraint),
        name=layout.constraints[row].name,
        before=layout.redundant.count(False),
        now=found.rank,
        freedom=max(len(layout.coordinates) - found.rank, 0),
    )


def _item(items: list[Located], row: int) -> Located:
    return next(item for item in items if row in item.rows)
