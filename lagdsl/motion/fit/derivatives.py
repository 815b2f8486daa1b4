"""The way to derivatives of runs that fits and sensitivities take."""

from __future__ import annotations

from lagdsl.motion.fit.differences import DifferencesOfRuns
from lagdsl.motion.fit.rollout import Derivatives


def derivatives_of_runs() -> Derivatives:
    """A new one, for one fit."""
    return DifferencesOfRuns()
