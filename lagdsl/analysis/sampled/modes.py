"""Modes of sampled loops, and the points about which they mean something."""

from __future__ import annotations

from lagdsl.analysis.point import Point, System
from lagdsl.analysis.sampled.fixed_point import fixed_point
from lagdsl.analysis.sampled.loop import loop_at
from lagdsl.analysis.sampled.schedule import schedule_of
from lagdsl.analysis.sampled.verdict import SampledModes, sampled_modes
from lagdsl.diagnostics import Sink


def loop_modes(system: System, point: Point, sink: Sink) -> SampledModes | None:
    """Of the loop that clocks close; None after errors."""
    schedule = schedule_of(system, point.p, None, sink)
    loop = None if schedule is None else loop_at(system, point, schedule, sink, with_outputs=False)
    return None if loop is None else sampled_modes(system, loop)


def trimmed(system: System, guess: Point, sink: Sink) -> Point | None:
    """The fixed point of the loop near `guess`; None after errors."""
    schedule = schedule_of(system, guess.p, None, sink)
    return None if schedule is None else fixed_point(system, guess, schedule, sink)
