"""Values that commands give to a motion that is shown. Every `lag run` loads them, few draw a scene."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field

from lagdsl.foundation.record import record
from lagdsl.motion.signals.inputs import Signal


@record(kw_only=True)
class Wishes:
    """Values that a motion begins with, by name in SI units. The experiment of the model says the others."""

    stop: float | None = None
    tolerance: float | None = None
    parameters: Mapping[str, float] = field(default_factory=dict)
    start: Mapping[str, float] = field(default_factory=dict)
    inputs: Mapping[str, Signal] = field(default_factory=dict)
