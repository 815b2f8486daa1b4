"""Ticks of all clocks over their common period."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from itertools import pairwise
from math import lcm

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.analysis.point import System

_LARGEST_DENOMINATOR = 10**6
_MOST_INSTANTS = 20_000
# Instants that are nearer to each other than this part of the shortest period are one, as in the runtime.
_SAME = 1e-9


@dataclass(frozen=True, slots=True)
class Schedule:
    """`period` [s]; each of `instants` has its time since the first [s], and the places of the clocks that tick."""

    period: float
    instants: tuple[tuple[float, tuple[int, ...]], ...]

    @property
    def gaps(self) -> list[float]:
        """Times from each instant to the next, the last one to the end of the period."""
        times = [time for time, _ in self.instants] + [self.period]
        return [later - earlier for earlier, later in pairwise(times)]

    def at_once(self) -> Schedule:
        """The same ticks, in their order, without time between them."""
        return Schedule(0.0, tuple((0.0, clocks) for _, clocks in self.instants))


def schedule_of(system: System, p: Floats, every: float | None, sink: Sink) -> Schedule | None:
    """Over the least common period, or over `every` [s], which has to be a multiple of it. Begins where the clock that
    starts last ticks first. None after E0862 and E0863."""
    clocks = system.flat.events.clocks
    start = system.flat.experiment.start_time
    first, period = (block.tolist() for block in system.engine.evaluate("clock", start, p))
    exact = [_fraction(each) for each in period]
    named = ", ".join(f"`{clock.name}`" for clock in clocks)
    common = period[0] if len(set(period)) == 1 else _common(exact)
    if common is None or sum(common / each for each in period) > _MOST_INSTANTS:
        sink.report("E0862", clocks[0].spans[0], names=named, most=_MOST_INSTANTS)
        return None
    times = 1
    if every is not None:
        times = round(every / common)
        if times < 1 or abs(every - times * common) > _SAME * every:
            sink.report("E0863", clocks[0].spans[0], every=time_text(every), common=time_text(common))
            return None
    base = max(first)
    found: list[tuple[float, int]] = []
    for place, (begins, length) in enumerate(zip(first, period, strict=True)):
        offset = (begins - base) % length
        offset = 0.0 if length - offset <= _SAME * length else offset
        count = round(times * common / length)
        found += [(offset + k * length, place) for k in range(count)]
    return Schedule(times * common, _joined(sorted(found), _SAME * min(period)))


def _joined(ticks: list[tuple[float, int]], same: float) -> tuple[tuple[float, tuple[int, ...]], ...]:
    """Ticks at one instant together."""
    found: list[tuple[float, tuple[int, ...]]] = []
    for time, place in ticks:
        if found and time - found[-1][0] <= same:
            found[-1] = (found[-1][0], (*found[-1][1], place))
        else:
            found.append((time, (place,)))
    return tuple(found)


def _fraction(value: float) -> Fraction | None:
    """The short fraction that is `value` to the last bit."""
    found = Fraction(value).limit_denominator(_LARGEST_DENOMINATOR)
    return found if float(found) == value else None


def _common(periods: list[Fraction | None]) -> float | None:
    """The least common multiple."""
    known = [each for each in periods if each is not None]
    if len(known) < len(periods):
        return None
    denominator = lcm(*(each.denominator for each in known))
    return float(Fraction(lcm(*(int(each * denominator) for each in known)), denominator))


def time_text(seconds: float) -> str:
    """`2 ms`, `0.5 s`."""
    for unit, size in (("s", 0.1), ("ms", 1e-4), ("us", 1e-7)):
        if seconds >= size:
            return f"{seconds / {'s': 1.0, 'ms': 1e-3, 'us': 1e-6}[unit]:.6g} {unit}"
    return f"{seconds:.6g} s"


def no_clocks(period: float) -> Schedule:
    """Of a model without clocks: nothing happens at its instants."""
    return Schedule(period, ((0.0, ()),))
