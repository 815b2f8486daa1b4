"""Curves of one motion, or of the runs of a sweep, that a figure is drawn from."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

import numpy as np

from lagdsl.documents.plot.names import ENERGY
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record
from lagdsl.language.flat.display import Display
from lagdsl.motion.signals.trajectory import Trajectory


@record(kw_only=True)
class Curve:
    """One quantity in its display unit: `values` (runs, rows)."""

    name: str
    unit: str
    values: Floats


@record(kw_only=True)
class Variation:
    """Value that colors the runs of a sweep: `values` (runs,) in `unit`; `words` tell each run."""

    name: str
    unit: str
    values: Floats
    words: tuple[str, ...]


@record(kw_only=True)
class Bundle:
    """Curves by name over `time` (rows,) [s]; `events` [s] are those that a figure marks."""

    title: str
    time: Floats
    curves: Mapping[str, Curve]
    events: tuple[float, ...] = ()
    variation: Variation | None = field(default=None)


def bundle_of(motion: Trajectory) -> Bundle:
    """All columns of a motion and its energy; ticks of clocks are no events to mark."""
    curves = {name: shown(name, c.display, c.values[None, :]) for c in motion.columns for name in c.called}
    curves.setdefault(ENERGY, Curve(name=ENERGY, unit="J", values=motion.energy[None, :]))
    events = tuple(sorted({event.time for event in motion.events if event.kind != "tick"}))
    return Bundle(title=motion.model, time=motion.time, curves=curves, events=events)


def shown(name: str, display: Display, values: Floats) -> Curve:
    """`values` in SI units as people see them."""
    return Curve(name=name, unit=display.unit, values=np.asarray(values * display.scale + display.shift))
