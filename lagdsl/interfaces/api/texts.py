"""Texts of the command line, in Python: the unit must stand in them."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from lagdsl.engines.backends.python.support.names import real_numbers
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.axis import varied


def grid_of(flat: FlatModel, name: str, values: ArrayLike | str) -> Floats:
    """Values of what `lag modes --vary` takes, in SI units. Raises ValueError for a text that is none."""
    if not isinstance(values, str):
        return np.atleast_1d(real_numbers(name, values))
    sink = Sink()
    _, found = varied(flat, name, values, sink)
    require_units(sink)
    return np.array(found)


def require_units(sink: Sink) -> None:
    """Raise ValueError for the first value without a unit: nobody would see what is said of it."""
    for note in sink.diagnostics:
        if note.code in ("N0871", "W0421"):
            raise ValueError(f"{note.message}; {note.help}, or give numbers in SI units")
