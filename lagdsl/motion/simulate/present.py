"""The present of a run by names: what `present["theta"]` is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from ctypes import c_double, c_void_p, cast
from typing import Any

import numpy as np

from lagdsl.engines.runtime.held_inputs import HeldInputs
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.engines.runtime.run import Run
from lagdsl.foundation.diagnostics.unknown import unknown_among
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.aliases import results_names
from lagdsl.language.settings.arrays import family
from lagdsl.motion.simulate.table import heads_of, places_of_columns


class Places:
    """Places of the values of a model in a row of the runtime: of those that trajectories have as columns, by all
    their names. The first `states` numbers of a row are the time and the state."""

    def __init__(self, flat: FlatModel) -> None:
        self.names = [head[0] for head in heads_of(flat)]
        self.known = dict(zip(self.names, places_of_columns(flat), strict=True))
        self.known |= {other: self.known[name] for other, name in results_names(flat).items() if name in self.known}
        self.states = 1 + 2 * len(flat.coordinates) + len(flat.states)

    def of(self, name: str) -> int | list[int]:
        """The place of a variable, or those of the elements of an array. Raises UnknownName."""
        if name in self.known:
            return self.known[name]
        elements = family(name, self.known) if isinstance(name, str) else []
        if not elements:
            raise unknown_among("variable", name, self.names)
        return [self.known[each] for each in elements]


class Present:
    """`present["theta"]` is the present value of a variable or an output in SI units, `present["q"]` an array of its
    elements; `present.t` [s] is the time. All names are those of the columns of a trajectory."""

    def __init__(self, places: Places) -> None:
        self._places = places
        self._known = places.known
        self._row: list[float] | None = None

    def watch(self, run: Run, held: HeldInputs) -> None:
        """From now on the values are those of this run."""
        self._held = held
        self._state: Any = (c_double * run.size).from_address(cast(run.report.x, c_void_p).value or 0)
        self._numbers = np.zeros(run.results.width)
        self._one = (c_void_p * 1)(held.address)
        self._row = None

    def imagine(self, row: list[float]) -> None:
        """The values are those of this row of the runtime, at the present time."""
        self._state, self._row = row[1 : self._places.states], row

    def moved(self) -> None:
        """The present is another one."""
        self._row = None

    @property
    def row(self) -> list[float] | None:
        """The row of the present state in the runtime, where it is known."""
        return self._row

    @row.setter
    def row(self, row: list[float]) -> None:
        self._row = row

    @property
    def t(self) -> float:
        """The time [s]."""
        return float(self._held.hold.goal)

    def __getitem__(self, name: str) -> float | Floats:
        """Raises UnknownName with the nearest name."""
        place = self._known.get(name)
        if place is None:
            return self._array(name)
        if 0 < place < self._places.states:
            return float(self._state[place - 1])
        return self.values()[place]

    def __contains__(self, name: object) -> bool:
        return name in self._known or (isinstance(name, str) and bool(family(name, self._known)))

    def __iter__(self) -> Iterator[str]:
        """The names, so that `dict(present)` holds all values."""
        return iter(self._places.names)

    def keys(self) -> Sequence[str]:
        """The names of all variables and outputs."""
        return tuple(self._places.names)

    def _array(self, name: str) -> Floats:
        values, places = self.values(), self._places.of(name)
        assert isinstance(places, list), "a single value is known"
        return np.array([values[place] for place in places])

    def values(self) -> list[float]:
        """The row of the present state."""
        if self._row is None:
            runtime_library().holds_row(self._one, 1, self._numbers.ctypes.data)
            self._row = self._numbers.tolist()
        return self._row
