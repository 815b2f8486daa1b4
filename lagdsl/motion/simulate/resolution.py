"""Do the rows show the motion? How many would, and what is said where they do not."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from lagdsl.foundation.record import record
from lagdsl.motion.signals.trajectory import Head, Trajectory

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
    """Of a motion; `reversals` says how often every number of its state turns around."""

    reversals: Sequence[float]

    @property
    def turns(self) -> int:
        """Those of the number that turns around most often."""
        return int(max(self.reversals, default=0.0))

    @property
    def place(self) -> int:
        """The first number of the state that turns around about as often."""
        most = self.turns
        return next((k for k, count in enumerate(self.reversals) if count >= _AS_OFTEN * most), 0)

    @property
    def rows(self) -> int:
        """As many intervals as a motion needs."""
        return max(math.ceil(min(_ENOUGH * self.turns, _MOST_ROWS) / DEFAULT_ROWS), 1) * DEFAULT_ROWS

    @property
    def least(self) -> int:
        """With fewer intervals the motion looks like another one."""
        return _LEAST * self.turns

    @property
    def smooth(self) -> int:
        """With as many intervals curves look smooth."""
        return max(min(_SMOOTH * self.turns, _MOST_ROWS), self.rows)


def noted(motion: Trajectory, heads: Sequence[Head], resolution: Resolution, intervals: int) -> Trajectory:
    """With a note where so many intervals between rows hide what the motion does; `heads` are those of its columns."""
    if intervals >= resolution.least:
        return motion
    time = motion.time
    span = float(time[-1] - time[0])
    name = heads[1 + resolution.place][0]
    turns = resolution.turns
    text = (
        f"the rows do not show `{name}`, which turns around {turns} times: they are "
        f"{span / intervals:.3g} s apart, {span / (_ENOUGH * turns):.2g} s would do"
    )
    statistics = replace(motion.statistics, notes=(*motion.statistics.notes, text))
    return replace(motion, statistics=statistics)
