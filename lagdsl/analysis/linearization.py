"""Result of `linearize`: matrices with names and units."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from lagdsl.analysis.border import on_both_sides
from lagdsl.analysis.dependence import dependence, idle_charges
from lagdsl.analysis.linearize import Named, Reduced, holonomic_rows, reduce, state_names
from lagdsl.analysis.point import Point, System
from lagdsl.analysis.steady import Steadiness, steadiness
from lagdsl.diagnostics import Sink
from lagdsl.numerics.connected_blocks import Flags
from lagdsl.numerics.rank import Floats


@dataclass(frozen=True, slots=True, kw_only=True)
class Linearization:
    """d(dx)/dt = A dx + B du, dy = C dx + D du about a point, SI units; x is the minimal state.

    A (nx, nx), B (nx, nu), C (ny, nx), D (ny, nu); rows and columns are named by `states`, `inputs`, `outputs`. `rate`
    (nx,) is dx/dt at the point itself, which is zero at an equilibrium. `left_out` are charges that no other state, no
    output and no relation depends on: the circuit depends on their rates alone.
    """

    model: str
    point: Point
    states: tuple[Named, ...]
    inputs: tuple[Named, ...]
    outputs: tuple[Named, ...]
    left_out: tuple[Named, ...]
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
    entries, watched = dependence(system, at)
    idle = idle_charges(system, at, entries, watched)
    kept = [i for i in range(len(at.value)) if i not in idle]
    names = state_names(system, at.partition)
    a, b, c, d = _without_rounding(at, entries)
    return Linearization(
        model=system.flat.name,
        point=at.flow.point,
        states=tuple(names[i] for i in kept),
        inputs=tuple(Named(slot.name, slot.unit) for slot in layout.inputs),
        outputs=tuple(Named(slot.name, slot.unit) for slot in layout.outputs),
        left_out=tuple(names[i] for i in idle),
        A=a[np.ix_(kept, kept)],
        B=b[kept],
        C=c[:, kept],
        D=d,
        rate=at.value[kept],
        steadiness=steadiness(system, at),
    )


def _without_rounding(at: Reduced, entries: Flags) -> tuple[Floats, Floats, Floats, Floats]:
    """A, B, C and D with zeros at all entries but these."""
    states = len(at.value)
    whole = np.where(entries, np.block([[at.a, at.b], [at.c, at.d]]), 0.0)
    return whole[:states, :states], whole[:states, states:], whole[states:, :states], whole[states:, states:]
