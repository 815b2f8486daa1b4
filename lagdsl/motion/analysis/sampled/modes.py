"""Modes of sampled loops, and the points about which they mean something."""

from __future__ import annotations

from dataclasses import replace

from lagdsl.foundation.diagnostics import Sink
from lagdsl.motion.analysis.point import Point, System
from lagdsl.motion.analysis.sampled.fixed_point import fixed_point
from lagdsl.motion.analysis.sampled.loop import Loop, loop_at
from lagdsl.motion.analysis.sampled.schedule import schedule_of
from lagdsl.motion.analysis.sampled.verdict import SampledModes, is_same, reads_time, sampled_modes

# Periods after which a loop that time acts on is looked at again.
_LATER = (0.6180339887, 7.4142135623)


def loop_modes(system: System, point: Point, sink: Sink) -> SampledModes | None:
    """Of the loop that clocks close; None after errors."""
    schedule = schedule_of(system, point.p, None, sink)
    loop = None if schedule is None else loop_at(system, point, schedule, sink, with_outputs=False)
    if loop is None:
        return None
    found = sampled_modes(system, loop)
    if not changes_with_time(system, loop, with_outputs=False):
        return found
    return replace(found, unbalanced=(*found.unbalanced, "time"))


def changes_with_time(system: System, loop: Loop, *, with_outputs: bool) -> bool:
    """True if the loop is another one some periods later, at the same state."""
    if not reads_time(system):
        return False
    times = [loop.point.t + periods * loop.period for periods in _LATER]
    others = [
        loop_at(system, replace(loop.point, t=t), loop.schedule, Sink(), with_outputs=with_outputs) for t in times
    ]
    return not all(other is not None and is_same(system, loop, other) for other in others)


def trimmed(system: System, guess: Point, sink: Sink) -> Point | None:
    """The fixed point of the loop near `guess`; None after errors."""
    schedule = schedule_of(system, guess.p, None, sink)
    return None if schedule is None else fixed_point(system, guess, schedule, sink)
