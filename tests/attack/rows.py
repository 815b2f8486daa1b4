"""Small models, each with a reference that uses nothing of lagdsl: closed forms, or a few lines of NumPy.

A model either moves as its reference says, in bounded time, or is refused with an error that names the cause where the
row allows that. `check` runs one row in a process of its own, so that a run that does not end is a failure like others.
"""

from __future__ import annotations

import os
import pickle
import signal
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property
from typing import Any, get_args

import pytest
from choice import EXPLORE, spread

import lagdsl
from lagdsl.engines.runtime.engines.engine import EngineName

KNOWN: tuple[str, ...] = get_args(EngineName)
FIRST = "tape" if "tape" in KNOWN else "c"
ENGINES: tuple[str, ...] = tuple(e for e in ("tape", "c", "numpy") if e in KNOWN) if EXPLORE else (FIRST,)
SECONDS = 10  # of the processor


class Later(Mapping[str, float]):
    """Values that `compute` gives when one of them is asked for: references that are integrated are not needed where
    tests are collected only."""

    def __init__(self, compute: Callable[[], Mapping[str, float]]) -> None:
        self._compute = compute

    @cached_property
    def _values(self) -> Mapping[str, float]:
        return self._compute()

    def __getitem__(self, name: str) -> float:
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)


@dataclass(frozen=True)
class Attack:
    """`ends` are values of columns at the end, `counts` numbers of events by (name, kind). `refused` are codes of
    errors and warnings that are an answer, too; "any" is any error."""

    name: str
    text: str
    stop: float
    ends: Mapping[str, float] = field(default_factory=dict)
    counts: Mapping[tuple[str, str], int] = field(default_factory=dict)
    inputs: Mapping[str, Any] = field(default_factory=dict)
    parameters: Mapping[str, float] = field(default_factory=dict)
    refused: tuple[str, ...] = ()
    tolerance: float = 1e-10
    near: float = 1e-8
    interval: float | None = None
    solver: str = "auto"


def model(body: str, clauses: str = "", units: bool = False) -> str:
    """A text from its statements and equations, without units unless asked for."""
    equation = f"\nequation\n{clauses}" if clauses else ""
    free = "" if units else 'annotation(units = "none");'
    return f"model Attacked\n{body}\n{free}{equation}\nend Attacked;\n"


def rows(table: list[Attack]) -> pytest.MarkDecorator:
    """Every row with every engine; three of them where not all is run."""
    cases = [pytest.param(row, engine, id=f"{row.name}-{engine}") for row in spread(table, 3) for engine in ENGINES]
    return pytest.mark.parametrize(("row", "engine"), cases)


def check(row: Attack, engine: str) -> None:
    code, found = in_bounded_time(lambda: _run(row, engine))
    if code is not None and (code in row.refused or "any" in row.refused):
        return
    assert code is None, f"refused: {code} {found}"
    ends, events = found
    for name, value in row.ends.items():
        assert abs(ends[name] - value) <= row.near * max(1.0, abs(value)), f"{name}: {ends[name]!r}, exact {value!r}"
    for event, count in row.counts.items():
        assert events.count(event) == count, f"{event}: {events.count(event)} times, exact {count}"


def _run(row: Attack, engine: str) -> tuple[str | None, Any]:
    """The code of an error and its text; or values at the end, and events."""
    try:
        attacked = lagdsl.compile(row.text, engine=engine)  # type: ignore[arg-type]
        warned = [each.code for each in attacked.diagnostics if each.code in row.refused]
        if warned:
            return warned[0], "a warning"
        motion = attacked.simulate(
            stop=row.stop,
            tolerance=row.tolerance,
            interval=row.interval or row.stop / 10,
            inputs=row.inputs or None,
            parameters=row.parameters or None,
            solver=row.solver,
        )
    except lagdsl.CompilationFailed as failed:
        return failed.diagnostics[0].code, str(failed)
    except lagdsl.SimulationFailed as failed:
        return failed.diagnostic.code, str(failed)
    assert abs(motion.time[-1] - row.stop) <= 1e-12 * row.stop, f"ended at {motion.time[-1]}"
    ends = {column.name: float(column.values[-1]) for column in motion.columns}
    return None, (ends, [(event.name, event.kind) for event in motion.events])


@cache
def _loaded() -> None:
    """Parser, library and modules are loaded here once, not in every child."""
    lagdsl.compile(model("coordinate Real x(start = 1); kinetic 1/2*der(x)^2;"), engine="tape").simulate(stop=0.1)


def in_bounded_time(work: Callable[[], Any], seconds: int = SECONDS) -> Any:
    """Result of `work`, computed in a child of this process that the system ends after so many seconds."""
    _loaded()
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        _work(work, write, seconds)
    os.close(write)
    with os.fdopen(read, "rb") as pipe:
        answer = pipe.read()
    _, status = os.waitpid(child, 0)
    assert not os.WIFSIGNALED(status), f"ended by {signal.Signals(os.WTERMSIG(status)).name}, {seconds} s are allowed"
    result, raised = pickle.loads(answer)
    assert raised is None, raised
    return result


def _work(work: Callable[[], Any], write: int, seconds: int) -> None:
    """The child: never returns."""
    signal.signal(signal.SIGPROF, signal.SIG_DFL)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        answer = (work(), None)
    except BaseException as error:
        answer = (None, f"{type(error).__name__}: {error}")
    with os.fdopen(write, "wb") as pipe:
        pipe.write(pickle.dumps(answer))
    os._exit(0)
