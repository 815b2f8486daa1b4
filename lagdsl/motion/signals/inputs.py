"""Inputs of a simulation as functions of time: constants, functions, tables; and the times at which they are not
smooth."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Any, TypeAlias, cast

import numpy as np

from lagdsl.engines.runtime.held_inputs import HeldInputs
from lagdsl.engines.runtime.signal_tables import SignalTable, TabledInputs
from lagdsl.engines.runtime.structures import SignalKind
from lagdsl.foundation.diagnostics import Diagnostic, Sink
from lagdsl.foundation.diagnostics.suggest import did_you_mean
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record, remembered
from lagdsl.language.flat.admissible import report_outside
from lagdsl.language.flat.model import FlatModel, Input
from lagdsl.motion.signals.hold import Hold

# A pair is (times, values), or an array of these two rows, see `_of_table`. Two equal times are a jump.
Signal: TypeAlias = "float | Callable[[float], float] | tuple[Sequence[float], Sequence[float]] | Floats | Hold"
# (t, before) -> value; `before` asks for the limit from the left.
_Function: TypeAlias = Callable[[float, bool], float]


_NONE = np.zeros(0)
# A monotone cubic has a continuous slope: of higher derivatives only the second is a function.
_MOST_DERIVATIVES = 2
_MOST_NAMED = 4
KINDS = "a number, a function of time, a pair (times, values) or a Hold of these"


@record()
class Signals:
    """The input vector at any time; `breaks` are the times at which a step must end."""

    functions: tuple[_Function, ...]
    breaks: tuple[float, ...]

    @property
    def constant(self) -> bool:
        """True if no input changes."""
        return all(isinstance(function, _Constant) for function in self.functions)

    @property
    def tables(self) -> tuple[SignalTable | None, ...] | None:
        """The table of each input, None for constants; None if any input is a function of Python."""
        if not all(isinstance(function, (_Constant, SignalTable)) for function in self.functions):
            return None
        return tuple(function if isinstance(function, SignalTable) else None for function in self.functions)

    @property
    def following(self) -> tuple[bool, ...]:
        """True for each input that follows time; the others are constants."""
        return tuple(not isinstance(function, _Constant) for function in self.functions)

    @property
    def is_called(self) -> bool:
        """True if any input is a function of Python."""
        return self.tables is None

    @property
    def last(self) -> float:
        """The time at which the first table ends; infinite where there is none."""
        return min((function.last for function in self.functions if isinstance(function, SignalTable)), default=np.inf)

    def held(self, t0: float) -> HeldInputs:
        """For a run that begins at t0, between whose steps the constants are changed."""
        tables = [function if isinstance(function, SignalTable) else None for function in self.functions]
        called = [
            function if follows and table is None else None
            for function, follows, table in zip(self.functions, self.following, tables, strict=True)
        ]
        return HeldInputs(self.at(t0), tables, called, self.breaks)

    def course(self, t0: float) -> Floats | TabledInputs | Callable[[float, bool], Floats]:
        """As a run that begins at t0 is told of them."""
        if self.constant:
            return self.at(t0)
        if self.tables is not None:
            return TabledInputs(self.at(t0), self.tables)
        return lambda t, before: self.at(t, before=before)

    def at(self, t: float, *, before: bool = False) -> Floats:
        """u (nu,); at a jump the value after it, or before it."""
        return np.array([function(t, before) for function in self.functions]) if self.functions else _NONE


def signals(
    flat: FlatModel,
    defaults: Floats,
    inputs: Mapping[str, Signal],
    span: tuple[float, float],
    sink: Sink,
    *,
    speeds: Sequence[bool] = (),
    covered: float | None = None,
) -> Signals:
    """Every input of the model: given ones, derivatives of given tables and constants, defaults. Tables of inputs that
    prescribe `speeds` may jump. Where the end of the `span` is open, tables are to reach `covered`.

    Errors go to `sink`: unknown names (E0819), a table that does not cover `span` (E0817), a function whose
    derivative the model needs and nobody gave (E0818), a table that has not as many derivatives (E0846) or jumps where
    one is needed (E0847), a derivative of what stands still (E0849), what an Integer, a Boolean or an enumeration
    cannot be (E0845, E0885); and the note N0848.
    Raises ValueError for what is no signal at all.
    """
    if not inputs:
        return Signals(tuple(map(_Constant, defaults.tolist())), ())
    names = [item.name for item in flat.inputs]
    for name in inputs:
        if name not in names:
            help = did_you_mean(name, names)
            sink.report("E0819", None, help=help, name=name, known=", ".join(names) or "none")
    functions: list[_Function] = []
    breaks: set[float] = set()
    known = span if covered is None else (span[0], covered)
    jumping = [name for name, flag in zip(names, speeds, strict=False) if flag]
    for item, default in zip(flat.inputs, defaults.tolist(), strict=True):
        source, order = _source(item.name, inputs)
        if source is None:
            functions.append(_Constant(default))
            continue
        needed = order + _derivatives_left(item.name, names, inputs)
        found = _function(item, source, inputs[source], (order, needed), known, breaks, sink, source in jumping)
        functions.append(found)
    _check_given_together(names, inputs, sink)
    return Signals(tuple(functions), tuple(sorted(b for b in breaks if span[0] < b < span[1])))


def report_missing(flat: FlatModel, given: Collection[str], sink: Sink) -> None:
    """N0875 for the inputs that neither `given` nor the model has a value for."""
    if given:
        _report_missing(_unstated(flat), given, sink)
        return
    for diagnostic in _nothing_given(flat):
        sink.add(diagnostic)


@remembered
def _unstated(flat: FlatModel) -> list[Input]:
    """Inputs for which the model has no value."""
    return [item for item in flat.inputs if not item.stated and item.derivative_of is None]


@remembered
def _nothing_given(flat: FlatModel) -> tuple[Diagnostic, ...]:
    """The note where no input is given."""
    sink = Sink()
    _report_missing(_unstated(flat), (), sink)
    return sink.diagnostics


def _report_missing(items: Sequence[Input], given: Collection[str], sink: Sink) -> None:
    missing = [item for item in items if _source(item.name, given)[0] is None]
    if not missing:
        return
    names = [f"`{item.name}`" for item in missing[:_MOST_NAMED]]
    more = f" and {len(missing) - len(names)} more" if len(missing) > len(names) else ""
    unit = missing[0].unit if missing[0].unit != "1" else ""
    zero = f"it is {_assumed(missing[0])} {unit}".rstrip() if len(missing) == 1 else "they are zero"
    if len(missing) > 1 and any(item.literals for item in missing):
        zero += ", enumerations have their first value"
    sink.report(
        "N0875",
        missing[0].spans[0] if missing[0].spans else None,
        names=f"the input{'' if len(missing) == 1 else 's'} {', '.join(names)}{more}",
        zero=zero,
        first=missing[0].name,
        example=missing[0].literals[-1] if missing[0].literals else f"1 {unit}".rstrip(),
    )


def _assumed(item: Input) -> str:
    return item.literals[0] if item.literals else "0"


def given_inputs(flat: FlatModel, inputs: Mapping[str, Signal]) -> list[bool]:
    """Flags of the inputs that these signals determine; all others have their defaults."""
    return [_source(item.name, inputs)[0] is not None for item in flat.inputs]


def _source(name: str, inputs: Collection[str]) -> tuple[str | None, int]:
    """The given signal that an input is made of, and how often it is differentiated for that: `der(road)` is itself if
    it is given, else the derivative of `road`."""
    source, order = name, 0
    while source not in inputs:
        if not source.startswith("der("):
            return None, 0
        source, order = source[4:-1], order + 1
    return source, order


def _derivatives_left(name: str, names: list[str], inputs: Mapping[str, Signal]) -> int:
    """Number of further derivatives that the same signal must provide."""
    count = 0
    while (name := f"der({name})") in names and name not in inputs:
        count += 1
    return count


def _check_given_together(names: list[str], inputs: Mapping[str, Signal], sink: Sink) -> None:
    """E0849: the derivative of a signal that stands still."""
    for name in inputs:
        base = _base(name)
        if name in names and base not in inputs and base != name:
            sink.report("E0849", None, name=base, derivative=name)


def _base(name: str) -> str:
    """`der(der(road))` comes from `road`."""
    while name.startswith("der("):
        name = name[4:-1]
    return name


def _function(
    item: Input,
    source: str,
    signal: Signal,
    orders: tuple[int, int],
    span: tuple[float, float],
    breaks: set[float],
    sink: Sink,
    may_jump: bool,
) -> _Function:
    """One input from the signal given for `source`; `orders` are the derivative it is of that, and the highest that is
    taken of it."""
    order, _ = orders
    if callable(signal):
        given = signal
        if order:
            place = item.spans[0] if item.spans else None
            sink.report("E0818", place, name=source, derivative=item.name)
        return lambda t, before: float(given(t))
    if isinstance(signal, (tuple, list, Hold)) or np.ndim(signal) > 0:
        held = isinstance(signal, Hold)
        times, values = _columns(item.name, (signal.times, signal.values) if isinstance(signal, Hold) else signal)
        if times[0] > span[0] or times[-1] < span[1]:
            sink.report(
                "E0817", None, name=_base(item.name), first=times[0], last=times[-1], start=span[0], stop=span[1]
            )
            return _Constant(0.0)
        if order == 0 and not is_allowed(item, values, times, sink):
            return _Constant(0.0)
        if held and item.base == "Real":
            times, values = np.repeat(times, 2)[1:], np.repeat(values, 2)[:-1]
        return _of_table(item, source, (times, values), orders, breaks, sink, may_jump)
    try:
        constant = float(cast(float, signal))
    except (TypeError, ValueError) as error:
        raise ValueError(f"input `{item.name}` must be {KINDS}") from error
    if not np.isfinite(constant):
        raise ValueError(f"input `{item.name}` must be a finite number, not {constant:g}")
    if order == 0:
        is_allowed(item, np.array([constant]), None, sink)
    return _Constant(constant if order == 0 else 0.0)


def _of_table(
    item: Input,
    source: str,
    table: tuple[Floats, Floats],
    orders: tuple[int, int],
    breaks: set[float],
    sink: Sink,
    may_jump: bool,
) -> _Function:
    """Steps for what is counted; straight lines, also where their slope is taken once; monotone cubics where two
    derivatives are taken. So the highest derivative jumps at rows, and the one before it does not."""
    times, values = table
    order, needed = orders
    if item.base != "Real":
        breaks.update(times[1:][np.diff(values) != 0.0].tolist())
        return SignalTable(SignalKind.STEPS, times, values)
    if needed == 0:
        breaks.update(_kinks(times, values))
        return SignalTable(SignalKind.LINES, times, values)
    kept = np.append(True, (np.diff(times) > 0.0) | (np.diff(values) != 0.0))
    times, values = times[kept], values[kept]  # a row may stand twice for a jump in another column
    jumps = np.flatnonzero(np.diff(times) == 0.0)
    if len(jumps) and not may_jump:
        sink.report("E0847", None, name=source, time=times[jumps[0]])
        return _Constant(0.0)
    if needed > _MOST_DERIVATIVES:
        if order == needed:
            sink.report("E0846", None, name=source, derivative=item.name)
        return _Constant(0.0)
    if len(times) == 1:
        return _Constant(float(values[0]) if order == 0 else 0.0)
    breaks.update(times[1:-1].tolist())
    if needed == 1:
        if order == 0:
            return SignalTable(SignalKind.LINES, times, values)
        pieces = np.diff(times) > 0.0
        slopes = np.diff(values)[pieces] / np.diff(times)[pieces]
        return SignalTable(SignalKind.STEPS, np.append(times[:-1][pieces], times[-1]), np.append(slopes, slopes[-1]))
    if order == 2:
        sink.report("N0848", None, name=source, derivative=item.name)
    return _cubics(times, values, order)


def _columns(name: str, signal: Any) -> tuple[Floats, Floats]:
    """Times and values of a table. Raises ValueError where it is none."""
    try:
        times, values = (np.asarray(column, dtype=np.float64) for column in signal)
    except (TypeError, ValueError) as error:
        raise ValueError(f"input `{name}` must be {KINDS}") from error
    if times.ndim != 1 or times.shape != values.shape or len(times) < 2:
        raise ValueError(
            f"the table of input `{name}` needs as many values as times, two at least; "
            f"their shapes are {times.shape} and {values.shape}"
        )
    if not (np.isfinite(times).all() and np.isfinite(values).all()):
        raise ValueError(f"the table of input `{name}` holds entries that are not numbers")
    steps = np.diff(times)
    if (steps < 0.0).any():
        raise ValueError(f"time decreases in the table of input `{name}`")
    return times, values


def is_allowed(item: Input, values: Floats, times: Floats | None, sink: Sink) -> bool:
    """True if the input may have these values. The motion may lead a real input beyond its bounds (W0328); others have
    no meaning there: E0845, E0885."""
    if item.base == "Real":
        _check_bounds(item, values, sink)
        return True
    place = item.spans[0] if item.spans else None
    odd = values[(values != np.round(values)) | ((item.base == "Boolean") & (values != 0.0) & (values != 1.0))]
    if len(odd):
        what = "true (1) or false (0)" if item.base == "Boolean" else "whole numbers"
        sink.report("E0845", place, name=item.name, what=what, value=f"{odd[0]:g}")
        return False
    least = 1.0 if item.literals else item.minimum
    most = float(len(item.literals)) if item.literals else item.maximum
    outside = np.zeros(len(values), dtype=np.bool_)
    outside |= values < (-np.inf if least is None else least)
    outside |= values > (np.inf if most is None else most)
    if not outside.any():
        return True
    row = int(np.argmax(outside))
    when = "" if times is None else f" at t = {times[row]:g} s"
    sink.report(
        "E0885", place, name=item.name, value=f"{values[row]:g}", when=when, allowed=_allowed(item, least, most)
    )
    return False


def _allowed(item: Input, least: float | None, most: float | None) -> str:
    if item.literals:
        return ", ".join(f"{place} ({name})" for place, name in enumerate(item.literals, 1))
    if most is None:
        return f"{least:g} and more"
    return f"{most:g} and less" if least is None else f"{least:g} to {most:g}"


def _check_bounds(item: Input, values: Floats, sink: Sink) -> None:
    """W0328 for the values that are farthest outside of `min` or `max`."""
    if len(values):
        for value in (float(np.min(values)), float(np.max(values))):
            report_outside(item, item.name, value, sink)


@record()
class _Constant:
    value: float

    def __call__(self, t: float, before: bool) -> float:
        return self.value


def _cubics(times: Floats, values: Floats, order: int) -> SignalTable:
    """A derivative of cubics that have no extremum where the rows have none (F. N. Fritsch and J. Butland, SIAM J. Sci.
    Stat. Comput. 5 (1984) 300), as `table(..., "monotone")`. At a row the second derivative of the piece after it, or
    before it."""
    from scipy.interpolate import PchipInterpolator

    curve: Any = PchipInterpolator(times, values)
    powers = curve.derivative(order).c if order else curve.c
    return SignalTable(SignalKind.POLYNOMIAL, times, powers.T)


def _kinks(times: Floats, values: Floats) -> list[float]:
    """Times at which the value jumps or the slope changes."""
    spans = np.diff(times)
    jump = spans <= 0.0
    slopes = np.diff(values) / np.where(jump, 1.0, spans)
    size = float(np.max(np.abs(slopes), initial=0.0))
    changed = np.abs(np.diff(slopes)) > 1e-9 * size
    return [float(t) for t in times[1:-1][changed | jump[1:] | jump[:-1]]]
