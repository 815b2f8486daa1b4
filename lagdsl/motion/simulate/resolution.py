"""Do the rows show the motion? How many would, and what is said where they do not."""

from __future__ import annotations

import math
from collections.abc import Sequence

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.motion.signals.trajectory import Head

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
        """Rows of the number that turns around most often."""
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
    def smooth(self) -> int:
        """With as many intervals curves look smooth."""
        return max(min(_SMOOTH * self.turns, _MOST_ROWS), self.rows)


def hidden(resolution: Resolution, heads: Sequence[Head], times: Floats, end: float) -> tuple[str, ...]:
    """A note where rows at `times` hide what the motion up to `end` does; `heads` are those of its columns."""
    intervals, turns = len(times) - 1, resolution.turns
    if intervals >= _LEAST * turns:
        return ()
    first, last = float(times[0]), float(times[-1])
    return (
        f"the rows do not show `{heads[1 + resolution.place][0]}`, which turns around {turns} times: they are "
        f"{(last - first) / intervals:.3g} s apart, {(end - first) / (_ENOUGH * turns):.2g} s would do",
    )
