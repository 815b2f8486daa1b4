"""A table of an input that keeps its value between the rows."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record


@record()
class Hold:
    """A signal in rows: at each of `times` [s] the input takes the value beside it (SI units) and keeps it up to the
    next row. Inputs of type Integer, Boolean or of an enumeration are held in any case."""

    times: Sequence[float] | Floats
    values: Sequence[float] | Floats
