"""Do the rows show the motion? How many would, and what is said where they do not."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from lagdsl.foundation.record import record
from lagdsl.motion.signals.trajectory import Trajectory

# Rows where nobody says how many, if they are enough.
DEFAULT_ROWS = 500
# Rows from one turning point of the motion to the next: fewer hide what it does, so many draw it.
_LEAST, _ENOUGH = 4, 8
# With so many, lines from row to row look smooth.
_SMOOTH = 32
# A quantity with at least this part of another one's reversals is as fast as that one.
_AS_OFTEN = 0.9
# Of a motion that turns more often no more are made without being asked for.
_MOST_ROWS = 50_000


@record()
class Resolution:
    """`rows` are as many intervals as a motion needs; `turns` is how often the number of the state at `place` turns
    around, the first of those that do so most often."""

    rows: int
    turns: int
    place: int

    @property
    def least(self) -> int:
        """With fewer intervals the motion looks like another one."""
        return _LEAST * self.turns

    @property
    def smooth(self) -> int:
        """With as many intervals curves look smooth."""
        return max(min(_SMOOTH * self.turns, _MOST_ROWS), self.rows)


def resolution_of(turns: Sequence[float]) -> Resolution:
    """From how often every number of the state turns around."""
    most = int(max(turns, default=0.0))
    place = next((k for k, count in enumerate(turns) if count >= _AS_OFTEN * most), 0)
    times = max(math.ceil(min(_ENOUGH * most, _MOST_ROWS) / DEFAULT_ROWS), 1)
    return Resolution(times * DEFAULT_ROWS, most, place)


def noted(motion: Trajectory, resolution: Resolution, intervals: int) -> Trajectory:
    """With a note where so many intervals between rows hide what the motion does."""
    if intervals >= resolution.least:
        return motion
    time = motion.time
    span = float(time[-1] - time[0])
    name = motion.columns[1 + resolution.place].name
    text = (
        f"the rows do not show `{name}`, which turns around {resolution.turns} times: they are "
        f"{span / intervals:.3g} s apart, {span / (_ENOUGH * resolution.turns):.2g} s would do"
    )
    statistics = replace(motion.statistics, notes=(*motion.statistics.notes, text))
    return replace(motion, statistics=statistics)
