"""Motions that tests write down."""

from __future__ import annotations

import numpy as np

from lagdsl.language.flat.display import Display
from lagdsl.motion.signals.trajectory import Column, Event, Kind, Statistics, Trajectory

T = np.linspace(0.0, 2.0, 201)


def column(name: str, values: np.ndarray, kind: Kind = "coordinate", unit: str = "m", scale: float = 1.0) -> Column:
    return Column(name=name, unit=unit, kind=kind, display=Display(unit, scale), values=values)


def trajectory(*columns: Column, energy: np.ndarray | None = None, events: tuple[Event, ...] = ()) -> Trajectory:
    return Trajectory(
        model="Model",
        columns=(column("time", T, "time", "s"), *columns),
        checks=np.array([np.zeros(len(T)) if energy is None else energy, *np.zeros((2, len(T)))]),
        invariants=(),
        moved=(),
        statistics=Statistics(solver="dop853"),
        events=events,
    )


def bounces(*times: float) -> tuple[Event, ...]:
    return tuple(Event(time=t, name="floor", kind="impact") for t in times)


ANGLE = column("theta", np.sin(5 * T), unit="deg", scale=180 / np.pi)
