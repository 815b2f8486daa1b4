"""An importer for model exchange that adds next to no error: DOP853 at 1e-13, events by Brent's method.

A step in which an indicator changes its sign is done again up to the first change. Differences to a reference are those
of the FMU.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from ctypes import POINTER, c_double
from dataclasses import dataclass
from typing import Any

import numpy as np
from fmpy.fmi2 import FMU2Model
from fmpy.fmi3 import FMU3Model
from fmpy.simulation import apply_start_values, settable_in_initialization_mode, settable_in_instantiated
from scipy.integrate import DOP853
from scipy.optimize import brentq

from fmi.exported import Exported

RELATIVE, ABSOLUTE = 1e-13, 1e-14
LONGEST = 0.02  # of the experiment, as FMPy does
ROUNDINGS = 64  # of time, over which a line leads across a force that jumps before its indicator does
MOST_EVENTS = 20_000


class Terminated(Exception):  # noqa: N818 it is no failure
    """An FMU ended the simulation."""


@dataclass
class Told:
    """Result of an update of discrete states."""

    again: bool
    terminate: bool
    next_time: float


class Instance:
    """One instance in model exchange, of either version."""

    def __init__(self, fmu: Exported, stop: float, starts: Mapping[str, Any]) -> None:
        description = fmu.description
        exchange = description.modelExchange
        kind = FMU2Model if fmu.version == 2 else FMU3Model
        self.fmu: Any = kind(
            guid=description.guid,
            unzipDirectory=str(fmu.folder),
            modelIdentifier=exchange.modelIdentifier,
            instanceName="exact",
        )
        self.is_second = fmu.version == 2
        self.size, self.count = description.numberOfContinuousStates, description.numberOfEventIndicators
        self.start = float(description.defaultExperiment.startTime or 0.0)
        self.fmu.instantiate()
        if self.is_second:
            self.fmu.setupExperiment(tolerance=RELATIVE, startTime=self.start, stopTime=stop)
        left = apply_start_values(self.fmu, description, dict(starts), settable_in_instantiated)
        if self.is_second:
            self.fmu.enterInitializationMode()
        else:
            self.fmu.enterInitializationMode(tolerance=RELATIVE, startTime=self.start, stopTime=stop)
        left = apply_start_values(self.fmu, description, left, settable_in_initialization_mode)
        assert not left
        self.fmu.exitInitializationMode()

    def allowed(self) -> np.ndarray:
        """Absolute errors of the states: parts of their nominal values, as the standards recommend."""
        nominals = np.zeros(self.size)
        self.fmu.getNominalsOfContinuousStates(_pointer(nominals), self.size)
        return ABSOLUTE * nominals

    def update(self) -> float:
        """Event mode up to its end, and continuous time; the time of the next event."""
        again, next_time = True, np.inf
        while again:
            found = self.fmu.newDiscreteStates() if self.is_second else self.fmu.updateDiscreteStates()
            again, terminate, _, _, defined, instant = found
            next_time = instant if defined else np.inf
            if terminate:
                raise Terminated
        self.fmu.enterContinuousTimeMode()
        return float(next_time)

    def states(self) -> np.ndarray:
        x = np.zeros(self.size)
        self.fmu.getContinuousStates(_pointer(x), self.size)
        return x

    def place(self, t: float, x: np.ndarray) -> None:
        self.fmu.setTime(t)
        self.fmu.setContinuousStates(_pointer(np.ascontiguousarray(x)), self.size)

    def rates(self, t: float, x: np.ndarray) -> np.ndarray:
        self.place(t, x)
        rates = np.zeros(self.size)
        read = self.fmu.getDerivatives if self.is_second else self.fmu.getContinuousStateDerivatives
        read(_pointer(rates), self.size)
        return rates

    def indicators(self, t: float, x: np.ndarray) -> np.ndarray:
        values = np.zeros(self.count)
        if self.count:
            self.place(t, x)
            self.fmu.getEventIndicators(_pointer(values), self.count)
        return values

    def is_at_event(self) -> bool:
        """Of a completed step."""
        event, terminate = self.fmu.completedIntegratorStep()
        if terminate:
            raise Terminated
        return bool(event)


def _pointer(values: np.ndarray) -> Any:
    return values.ctypes.data_as(POINTER(c_double))


def ends_exactly(fmu: Exported, stop: float, names: Sequence[str], starts: Mapping[str, Any]) -> dict[str, float]:
    """Values of scalar variables at the end, or where the FMU ends the simulation."""
    one = Instance(fmu, stop, starts)
    try:
        t, x = one.start, one.states()
        try:
            next_time = one.update()
            for _ in range(MOST_EVENTS):
                x = one.states()
                t, x, at_event = _to_event(one, t, x, next_time, stop)
                if not at_event and t >= stop:
                    break
                one.fmu.enterEventMode()
                next_time = one.update()
            else:
                raise AssertionError(f"{MOST_EVENTS} events up to {t} s")
        except Terminated:
            pass
        values = {name: _value(one, fmu, name) for name in names}
        one.fmu.terminate()
        return values
    finally:
        one.fmu.freeInstance()


def _value(one: Instance, fmu: Exported, name: str) -> float:
    variable, index = fmu.entry(name)
    count = 1 if index is None else int(np.prod(variable.shape))
    more = {} if one.is_second else {"nValues": count}
    values = getattr(one.fmu, f"get{variable.type}")([variable.valueReference], **more)
    return float(values[index or 0])


def _to_event(one: Instance, t: float, x: np.ndarray, next_time: float, stop: float) -> tuple[float, np.ndarray, bool]:
    """Steps up to the first event, one at the stop included, or to `stop`; True where there is one."""
    before = one.indicators(t, x) > 0
    limit = min(next_time, stop)
    if not limit > t:
        return t, x, next_time <= stop
    solver = DOP853(one.rates, t, x, limit, rtol=RELATIVE, atol=one.allowed(), max_step=LONGEST * stop)
    while solver.status == "running":
        t, x = solver.t, solver.y.copy()
        if solver.step() is not None:
            beyond = min(limit, t + ROUNDINGS * float(np.spacing(t)))
            x = _state_at(one, t, x, beyond)
            one.place(beyond, x)
            one.is_at_event()
            return beyond, x, True
        if np.any((one.indicators(solver.t, solver.y) > 0) != before):
            return (*_first_change(one, solver, before, t, x), True)
        one.place(solver.t, solver.y)
        if one.is_at_event():
            return solver.t, solver.y, True
        t, x = solver.t, solver.y
    return t, x, next_time <= stop


def _first_change(
    one: Instance, solver: DOP853, before: np.ndarray, t: float, x: np.ndarray
) -> tuple[float, np.ndarray]:
    """The state behind the first change of a sign in the last step, from the state before it."""
    along = solver.dense_output()

    def margin(time: float) -> float:
        """Negative: a sign has changed."""
        values = one.indicators(time, along(time))
        return float(np.min(np.where(before, values, -values)))

    end = _changed(margin, t, solver.t)
    further = 2 * (end - t) * np.finfo(float).eps + 4 * np.spacing(end)
    for _ in range(60):
        there = _state_at(one, t, x, end)
        if end >= solver.t or np.any((one.indicators(end, there) > 0) != before):
            break
        end, further = min(solver.t, end + further), 2 * further
    one.place(end, there)
    one.is_at_event()
    return end, there


def _state_at(one: Instance, t: float, x: np.ndarray, end: float) -> np.ndarray:
    """A line where the method asks for steps below the rounding of time."""
    solver = DOP853(one.rates, t, x, end, rtol=RELATIVE, atol=one.allowed())
    while solver.status == "running":
        solver.step()
    return np.asarray(solver.y + (end - solver.t) * one.rates(solver.t, solver.y))


def _changed(margin: Callable[[float], float], a: float, b: float) -> float:
    """The first change between a and b, on the side where it has changed."""
    if margin(a) <= 0 or not margin(b) < 0:
        return b
    root = float(brentq(margin, a, b, xtol=1e-15, rtol=8.9e-16, maxiter=1000))
    step = float(np.spacing(root))
    while root < b and margin(root) > 0:
        root, step = min(b, root + step), 2 * step
    return root
