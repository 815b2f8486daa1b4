"""The product of a simulation: columns over time, and what the solver can tell about their quality."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import partial
from math import isfinite, isnan
from typing import TYPE_CHECKING, Any, Literal, Protocol, Self, TypeAlias, overload

import numpy as np

from lagdsl.foundation.diagnostics import refused
from lagdsl.foundation.diagnostics.suggest import did_you_mean, listing
from lagdsl.foundation.diagnostics.unknown import unknown_among
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.display import Display
from lagdsl.language.settings.arrays import family
from lagdsl.motion.signals.moved import MovedRow
from lagdsl.motion.signals.parquet import attributes
from lagdsl.motion.signals.sensitivities import Sensitivities

if TYPE_CHECKING:
    import pandas as pd

Kind = Literal["time", "coordinate", "rate", "state", "discrete", "output"]
# Name, unit, kind and display of a column.
Head: TypeAlias = tuple[str, str, Kind, Display]


@record(kw_only=True)
class Column:
    """One quantity over time in its coherent SI unit; `display` is how people see it. `lowest` and `highest` are those
    of the motion, which may lie between rows; left out, those of the rows. `aliases` are other names of it."""

    name: str
    unit: str
    kind: Kind
    display: Display
    values: Floats
    lowest: float = np.nan
    highest: float = np.nan
    aliases: tuple[str, ...] = ()

    @property
    def called(self) -> tuple[str, ...]:
        """All its names."""
        return self.name, *self.aliases

    def __post_init__(self) -> None:
        if not isnan(self.lowest):
            return
        seen = self.values[np.isfinite(self.values)]
        if len(seen):
            object.__setattr__(self, "lowest", float(np.min(seen)))
            object.__setattr__(self, "highest", float(np.max(seen)))


class Table(Protocol):
    """Rows of a motion, column by column."""

    def __getitem__(self, place: int, /) -> Floats: ...


class LateColumn(Column):
    """A column whose values are made when they are first asked for."""

    __slots__ = ("_given",)
    _given: Floats | Callable[[], Floats]

    @property
    def values(self) -> Floats:
        if callable(self._given):
            self._given = self._given()
        return self._given

    @values.setter
    def values(self, given: Floats | Callable[[], Floats]) -> None:
        self._given = given


class Columns(Sequence[Column]):
    """The columns of a table, each made when it is first asked for: short motions are read in part.

    `table` has the time first; `ends` (2, columns but for time) are the lowest and highest values, infinite where there
    was no number; `aliases` are other names by name.
    """

    __slots__ = ("_aliases", "_ends", "_heads", "_made", "_table")

    def __init__(
        self, heads: Sequence[Head], table: Table, ends: Floats, aliases: Mapping[str, tuple[str, ...]]
    ) -> None:
        self._heads, self._table, self._ends, self._aliases = heads, table, ends, aliases
        self._made: dict[int, Column] = {}

    def __len__(self) -> int:
        return len(self._heads)

    @overload
    def __getitem__(self, place: int) -> Column: ...

    @overload
    def __getitem__(self, place: slice) -> tuple[Column, ...]: ...

    def __getitem__(self, place: int | slice) -> Column | tuple[Column, ...]:
        if isinstance(place, slice):
            return tuple(self[k] for k in range(len(self))[place])
        if place not in self._made:
            self._made[place] = self._column(range(len(self))[place])
        return self._made[place]

    def _column(self, place: int) -> Column:
        name, unit, kind, shown = self._heads[place]
        if place:
            low, high = self._ends[:, place - 1].tolist()
        else:
            times = self._table[0]
            low, high = (times[0], times[-1]) if len(times) else (np.nan, np.nan)
        late = not isinstance(self._table, np.ndarray)
        values: Any = partial(self._table.__getitem__, place) if late else self._table[place]
        return (LateColumn if late else Column)(
            name=name,
            unit=unit,
            kind=kind,
            display=shown,
            values=values,
            lowest=low if isfinite(low) else np.nan,
            highest=high if isfinite(high) else np.nan,
            aliases=self._aliases.get(name, ()),
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class InvariantRecord:
    """Drift of a declared invariant: its value at the start, the largest drift from it, and the permitted drift."""

    name: str
    start: float
    drift: float
    limit: float


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Event:
    """An event at an instant. The trajectory has two rows of this time: just before and just after the event.

    - `kind` `true`, `false`: `name` is the relation that changed, as written
    - `tick`: the clock, `sample(0, 5 ms)`
    - `impact`, `closed`, `opened`: the contact
    - `jump`: `floor`, `ceil`, `mod` or `wrap` of time, as written
    - `reinit`: the state or rate that was set
    - `terminate`: the message

    `derivatives` are those of its time by what `tangents` named.

    At one instant, clocks and relations, which cause the event, come first; relations that change by it are not listed.
    """

    time: float
    name: str
    kind: str
    derivatives: Mapping[str, float] = field(default_factory=dict, compare=False)

    def time_derivative(self, by: str) -> float:
        """Of its time [s] by a quantity that `tangents` named, in SI units. Raises UnknownName."""
        if by not in self.derivatives:
            raise unknown_among("quantity of `tangents`", by, list(self.derivatives))
        return self.derivatives[by]

    def __repr__(self) -> str:
        return f"<Event {self.time:.9g} s: {self.name} {self.kind}>"


@dataclass(frozen=True, slots=True, kw_only=True)
class Statistics:
    """Statistics of the solver. `notes` list changes of method and singular positions passed."""

    solver: str
    steps: int = 0
    evaluations: int = 0
    jacobians: int = 0
    projections: int = 0
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True, repr=False)
class Trajectory:
    """Rows at the requested times, and two at the time of an event: before it and after it. `trajectory["theta"]` is a
    column in SI units.

    `checks` are `energy`, `position_residual` and `velocity_residual`.
    `finer` makes the same motion with rows that show it, where those that were asked for are too few to draw it, else
    None; with True, with so many that curves look smooth. A copy that comes from another process (pickle) has the rows
    alone.
    """

    model: str
    columns: Sequence[Column]
    checks: Table
    invariants: tuple[InvariantRecord, ...]
    moved: tuple[MovedRow, ...]
    statistics: Statistics
    events: tuple[Event, ...] = ()
    finer: Callable[[bool], Trajectory | None] | None = field(default=None, compare=False)
    sensitivities: Sensitivities | None = None

    def __reduce__(self) -> tuple[partial[Trajectory], tuple[()]]:
        """Without `finer`, which holds the model and its compiled functions."""
        values = {each.name: getattr(self, each.name) for each in fields(self)}
        return partial(type(self), **values | {"finer": None}), ()

    def __repr__(self) -> str:
        span = f"{self.time[0]:g} s to {self.time[-1]:g} s" if len(self) else "no time"
        count = len(self.events)
        happened = f", {count} event{'' if count == 1 else 's'}" if count else ""
        return f"<{type(self).__name__} {self.model}: {len(self)} rows, {span}{happened}, {', '.join(self.names[1:])}>"

    @property
    def time(self) -> Floats:
        return self.columns[0].values

    @property
    def energy(self) -> Floats:
        """energy() [J] at each row."""
        return self.checks[0]

    @property
    def position_residual(self) -> Floats:
        """Largest violation of the constraints on positions at each row, in the units of the rows of constraints."""
        return self.checks[1]

    @property
    def velocity_residual(self) -> Floats:
        """The same of all constraints, as they restrict rates."""
        return self.checks[2]

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(column.name for column in self.columns)

    def derivative(self, of: str, by: str) -> Floats:
        """(rows,): of the column `of`, at a fixed time, by a quantity that `tangents` named, in SI units: by the
        equations of motion, constraints, start values and events. Raises UnknownName, and CallRefused for a motion
        without tangents."""
        if self.sensitivities is None:
            raise refused("E0884", text="`simulate(tangents=[...])`")
        return self.sensitivities.derivative(of, by)

    @property
    def found(self) -> dict[str, float]:
        """The parameters that were found with the start, by name, in SI units."""
        return {row.name: row.value for row in self.moved if row.kind == "found"}

    def drawn(self, *, smooth: bool = False) -> Trajectory:
        """The motion with rows that are enough to draw it; with `smooth`, also its curves at any size."""
        return self if self.finer is None else self.finer(smooth) or self

    def column(self, name: str) -> Column:
        """The column with its unit; KeyError with the known names otherwise."""
        for column in self.columns:
            if name in column.called:
                return column
        hint = did_you_mean(str(name), self._called(), f"there are {listing(str(name), self.names)}")
        raise KeyError(f"no column `{name}`; {hint}")

    def __iter__(self) -> Iterator[str]:
        """The names of the columns, so that `dict(trajectory)` holds them all."""
        return iter(self.names)

    def keys(self) -> tuple[str, ...]:
        return self.names

    def __contains__(self, name: object) -> bool:
        return name in self.names or (isinstance(name, str) and bool(family(name, self.names)))

    def __getitem__(self, name: str) -> Floats:
        """Values (rows,) of the column, or (rows, elements) of the array `name`; KeyError with the known names."""
        called = self._called()
        elements = [] if name in called else family(name, called)
        if elements:
            return np.stack([self.column(each).values for each in elements], axis=-1)
        return self.column(name).values

    def _called(self) -> list[str]:
        """All names of all columns."""
        return [name for column in self.columns for name in column.called]

    def __len__(self) -> int:
        return len(self.time)

    def only(self, names: Collection[str] | None) -> Self:
        """The motion with the time and the columns `names`, in their order here and under the names that are asked for;
        with None itself."""
        if names is None:
            return self
        own = self.finer

        def finer(smooth: bool) -> Trajectory | None:
            found = own(smooth) if own is not None else None
            return None if found is None else found.only(names)

        return replace(
            self,
            columns=(self.columns[0], *(each for column in self.columns[1:] for each in _under(column, names))),
            finer=None if own is None else finer,
        )

    def to_dataframe(self) -> pd.DataFrame:
        """All columns as a pandas DataFrame; `attrs["units"]` has the SI unit of each. Needs the extra `table`."""
        try:
            import pandas as pd
        except ModuleNotFoundError as missing:
            raise ModuleNotFoundError(f"data frames need pandas: pip install pandas ({missing})") from missing
        frame = pd.DataFrame({column.name: column.values for column in self.columns})
        frame.attrs = attributes(self.model, {column.name: column.unit for column in self.columns})
        return frame

    def crossings(self, name: str, level: float = 0.0, *, direction: int = 0) -> Floats:
        """Times at which a column passes `level`; `direction` 1 rising, -1 falling, 0 both.

        Between rows the column is the polynomial through the eight nearest rows, so rows a tenth of a period apart
        give times to about 1e-6 of the period, and finer rows much better ones. Events are not reached across; a jump
        over `level` is a passage.
        """
        return crossing_times(self.time, self[name] - level, direction)


def _under(column: Column, names: Collection[str]) -> list[Column]:
    """The column once under each of the names that are its own."""
    asked = [name for name in column.called if name in names]
    others = tuple(name for name in column.called if name not in asked)
    return [replace(column, name=name, aliases=others) for name in asked]


def crossing_times(t: Floats, x: Floats, direction: int) -> Floats:
    """Zeros of the data x(t)."""
    found: list[float] = []
    for row in range(len(t) - 1):
        before, after = float(x[row]), float(x[row + 1])
        if before == 0.0:
            rising = after > 0.0 if after != 0.0 else None
            arrived = row > 0 and float(x[row - 1]) * after < 0.0
            if row == 0 or arrived:
                _append(found, float(t[row]), rising, direction)
        elif before * after < 0.0:
            _append(found, _zero(t, x, row), after > before, direction)
        elif after == 0.0 and row + 2 == len(t):
            _append(found, float(t[-1]), before < 0.0, direction)
    return np.array(found)


def _append(found: list[float], time: float, rising: bool | None, direction: int) -> None:
    if direction == 0 or (rising is not None and rising == (direction > 0)):
        found.append(time)


def _zero(t: Floats, x: Floats, row: int) -> float:
    """The zero between two rows, by bisection on the polynomial through rows without an event between them."""
    low, high = float(t[row]), float(t[row + 1])
    if low == high:
        return low
    jumps = np.flatnonzero(t[1:] == t[:-1])
    begin = int(np.max(jumps[jumps < row], initial=-1)) + 1
    end = int(np.min(jumps[jumps > row], initial=len(t) - 1)) + 1
    first = min(max(row - 3, begin), max(end - 8, begin))
    nodes, values = t[first : min(first + 8, end)], x[first : min(first + 8, end)]
    sign = np.sign(x[row])
    for _ in range(60):
        middle = 0.5 * (low + high)
        if np.sign(_polynomial(nodes, values, middle)) == sign:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def _polynomial(nodes: Floats, values: Floats, t: float) -> float:
    """Neville's scheme."""
    p = values.copy()
    for k in range(1, len(p)):
        ahead, behind = nodes[k:], nodes[:-k]
        p = ((t - behind) * p[1:] - (t - ahead) * p[:-1]) / (ahead - behind)
    return float(p[0])
