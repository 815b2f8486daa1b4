"""The two versions of the standard behind one set of names, on fmpy: what tests do with instances."""

from __future__ import annotations

import ctypes
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import numpy as np
from fmpy.simulation import instantiate_fmu

from fmi.exported import Exported

Floats = np.ndarray
_GETTERS = {
    "Real": "Real",
    "Float64": "Float64",
    "Integer": "Integer",
    "Enumeration": "Integer",
    "Int32": "Int32",
    "Int64": "Int64",
    "Boolean": "Boolean",
}


@dataclass
class Instance:
    """An instance by names of scalars and arrays; everything raises where the status is no success."""

    fmu: Exported
    raw: Any
    start: float = 0.0
    told: list[tuple[bool, ...]] = field(default_factory=list)  # what newDiscreteStates said, last event

    # ---- variables ---------------------------------------------------------------------------------------------------

    def get(self, *names: str) -> Floats:
        """(len(names)) scalars."""
        values = []
        for name in names:
            variable, index = self.fmu.entry(name)
            values.append(self.array(variable.name)[index or 0])
        return np.array(values)

    def array(self, name: str) -> Floats:
        """All of one variable, flat."""
        variable = self.fmu.variables[name]
        getter = getattr(self.raw, "get" + self._kind(variable.type))
        if self.fmu.version == 2:
            return np.array(getter([variable.valueReference]), dtype=float)
        count = int(np.prod(variable.shape)) if variable.shape else 1
        return np.array(getter([variable.valueReference], nValues=count), dtype=float)

    def set(self, values: Mapping[str, Any]) -> None:
        for name, value in values.items():
            variable = self.fmu.variables[name]
            setter = getattr(self.raw, "set" + self._kind(variable.type))
            numbers = np.atleast_1d(value)
            whole = variable.type not in ("Real", "Float64")
            setter([variable.valueReference], (numbers.astype(int) if whole else numbers).tolist())

    def _kind(self, kind: str) -> str:
        return "Int64" if kind == "Enumeration" and self.fmu.version == 3 else _GETTERS[kind]

    # ---- initialization ----------------------------------------------------------------------------------------------

    def initialize(
        self,
        values: Mapping[str, Any] | None = None,
        *,
        start: float = 0.0,
        stop: float | None = None,
        tolerance: float | None = None,
    ) -> None:
        self.start = start
        if self.fmu.version == 2:
            self.raw.setupExperiment(tolerance=tolerance, startTime=start, stopTime=stop)
            self.set(values or {})
            self.raw.enterInitializationMode()
        else:
            self.set(values or {})
            self.raw.enterInitializationMode(tolerance=tolerance, startTime=start, stopTime=stop)
        self.raw.exitInitializationMode()

    # ---- state -------------------------------------------------------------------------------------------------------

    def serialized(self) -> bytes:
        state = self.raw.getFMUState()
        data: bytes = self.raw.serializeFMUState(state)
        self.raw.freeFMUState(state)
        return data

    def restore(self, data: bytes) -> None:
        state = self.raw.deserializeFMUState(data)
        self.raw.setFMUState(state)
        self.raw.freeFMUState(state)

    # ---- derivatives -------------------------------------------------------------------------------------------------

    def directional(self, unknowns: Sequence[str], knowns: Sequence[str], seed: Floats) -> Floats:
        """d unknowns / d knowns * seed; names of variables, all entries of arrays."""
        wanted, given = self._references(unknowns), self._references(knowns)
        if self.fmu.version == 2:
            return np.array(self.raw.getDirectionalDerivative(wanted, given, seed.tolist()))
        return np.array(self.raw.getDirectionalDerivative(wanted, given, seed.tolist(), self.length(unknowns)))

    def adjoint(self, unknowns: Sequence[str], knowns: Sequence[str], seed: Floats) -> Floats:
        """Seed times d unknowns / d knowns; FMI 3."""
        wanted, given = self._references(unknowns), self._references(knowns)
        return np.array(self.raw.getAdjointDerivative(wanted, given, seed.tolist(), self.length(knowns)))

    def length(self, names: Sequence[str]) -> int:
        shapes = (self.fmu.variables[name].shape for name in names)
        return sum(int(np.prod(shape)) if shape else 1 for shape in shapes)

    def _references(self, names: Sequence[str]) -> list[int]:
        return [self.fmu.variables[name].valueReference for name in names]


class Slave(Instance):
    """Co-simulation."""

    def step(self, t: float, h: float, *, final: bool = True) -> None:
        """From t over h. `final`: nobody goes back before t."""
        told = self.raw.doStep(t, h, final)
        if self.fmu.version == 3:
            assert not told[2], f"early return at {told[3]}"
            assert abs(told[3] - t - h) <= 1e-12 * max(1.0, abs(t + h))

    def rows(self, names: Sequence[str], times: Floats) -> Floats:
        """(len(times), len(names)): values now, at times[0], and at the end of each step."""
        rows = [self.get(*names)]
        for t, end in pairwise(times):
            self.step(t, end - t)
            rows.append(self.get(*names))
        return np.array(rows)


class Model(Instance):
    """Model exchange."""

    @property
    def nx(self) -> int:
        count: int = self.fmu.description.numberOfContinuousStates
        if self.fmu.version == 3:
            count = self.raw.getNumberOfContinuousStates()
        return count

    @property
    def states(self) -> Floats:
        return self._vector(self.raw.getContinuousStates, self.nx)

    @property
    def derivatives(self) -> Floats:
        name = "getDerivatives" if self.fmu.version == 2 else "getContinuousStateDerivatives"
        return self._vector(getattr(self.raw, name), self.nx)

    @property
    def indicators(self) -> Floats:
        v3 = self.fmu.version == 3
        count = self.raw.getNumberOfEventIndicators() if v3 else self.fmu.description.numberOfEventIndicators
        return self._vector(self.raw.getEventIndicators, count)

    def move(self, t: float, x: Floats) -> None:
        self.raw.setTime(float(t))
        values = (ctypes.c_double * len(x))(*x)
        self.raw.setContinuousStates(values, len(x))

    def update(self) -> float:
        """Event mode until nothing changes, then continuous time; tells the next time event, or infinity."""
        self.told.clear()
        for _ in range(100):
            told = (self.raw.newDiscreteStates if self.fmu.version == 2 else self.raw.updateDiscreteStates)()
            self.told.append(told)
            assert not told[1], "the model ends the simulation"
            if not told[0]:
                self.raw.enterContinuousTimeMode()
                return float(told[5]) if told[4] else np.inf
        raise AssertionError("event mode does not come to an end")

    @staticmethod
    def _vector(getter: Any, count: int) -> Floats:
        values = (ctypes.c_double * count)()
        getter(values, count)
        return np.array(values)


@contextmanager
def slave(fmu: Exported, **options: Any) -> Iterator[Slave]:
    raw = instantiate_fmu(str(fmu.folder), fmu.description, "CoSimulation", **options)
    try:
        yield Slave(fmu, raw)
    finally:
        raw.freeInstance()


@contextmanager
def exchanged(fmu: Exported) -> Iterator[Model]:
    raw = instantiate_fmu(str(fmu.folder), fmu.description, "ModelExchange")
    try:
        yield Model(fmu, raw)
    finally:
        raw.freeInstance()
