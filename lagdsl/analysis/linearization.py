"""Result of `linearize`: matrices with names and units."""

from __future__ import annotations

from dataclasses import dataclass

from lagdsl.analysis.border import on_both_sides
from lagdsl.analysis.linearize import Named, holonomic_rows, reduce, state_names
from lagdsl.analysis.point import Point, System
from lagdsl.analysis.steady import Steadiness, steadiness
from lagdsl.diagnostics import Sink
from lagdsl.numerics.rank import Floats


@dataclass(frozen=True, slots=True, kw_only=True)
class Linearization:
    """d(dx)/dt = A dx + B du, dy = C dx + D du about a point, SI units; x is the minimal state.

    A (nx, nx), B (nx, nu), C (ny, nx), D (ny, nu); rows and columns are named by `states`, `inputs`, `outputs`. `rate`
    (nx,) is dx/dt at the point itself, which is zero at an equilibrium.
    """

    model: str
    point: Point
    states: tuple[Named, ...]
    inputs: tuple[Named, ...]
    outputs: tuple[Named, ...]
    A: Floats
    B: Floats
    C: Floats
    D: Floats
    rate: Floats
    steadiness: Steadiness


def linearize_at(system: System, point: Point, sink: Sink) -> Linearization | None:
    """Exact; None after E0850, E0851, E0855 or E0860."""
    at = reduce(system, point, holonomic_rows(system), sink)
    at = None if at is None else on_both_sides(system, at, sink)
    if at is None:
        return None
    layout = system.engine.layout
    return Linearization(
        model=system.flat.name,
        point=point,
        states=state_names(system, at.partition),
        inputs=tuple(Named(slot.name, slot.unit) for slot in layout.inputs),
        outputs=tuple(Named(slot.name, slot.unit) for slot in layout.outputs),
        A=at.a,
        B=at.b,
        C=at.c,
        D=at.d,
        rate=at.value,
        steadiness=steadiness(system, at),
    )
