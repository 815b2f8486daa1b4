"""The way to derivatives of runs that fits and sensitivities take: the tangents of the motion itself."""

from __future__ import annotations

import numpy as np

from lagdsl.foundation.diagnostics import CallRefused, Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.motion.fit.data import Series
from lagdsl.motion.fit.differences import DifferencesOfRuns
from lagdsl.motion.fit.rollout import Derivatives, Differentiated, Rollout, instants, rows_at
from lagdsl.motion.fit.unknowns import Unknown, is_parameter
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.failure import SimulationFailed

# No derivatives of this motion: at its start, at an instant, by what the model has.
_NONE = {"E0881", "E0882", "E0884"}


class TangentsOfRuns:
    """Exact along the motion: `error` is that of the integration at usual tolerances. A motion that has no tangents is
    left to differences, which tell where the order of events changes."""

    error = 1e-5

    def __init__(self) -> None:
        self._otherwise = DifferencesOfRuns()
        self._has_none = False

    def __call__(self, rollout: Rollout, x: Floats, *, exact: bool = False) -> Differentiated:
        """See `Derivatives`."""
        if not self._has_none:
            sink = Sink()
            try:
                motion = rollout.motion(x, tangents=[_name(each) for each in rollout.unknowns], sink=sink)
            except (CallRefused, SimulationFailed) as failure:
                if failure.diagnostics[0].code not in _NONE:
                    raise
                self._has_none = True
            else:
                smooth = all(diagnostic.code != "W0883" for diagnostic in sink.diagnostics)
                return Differentiated(
                    motion=motion,
                    values=rollout.observed(motion),
                    jacobian=_jacobian(rollout, motion),
                    steady=(smooth,) * len(x),
                )
        return self._otherwise(rollout, x, exact=exact)


def derivatives_of_runs() -> Derivatives:
    """A new one, for one fit."""
    return TangentsOfRuns()


def _name(unknown: Unknown) -> str:
    return unknown.target.key if is_parameter(unknown) else f"{unknown.target.key}.start"


def _jacobian(rollout: Rollout, motion: Trajectory) -> Floats:
    """(n, unknowns): derivatives of what is observed."""
    return np.column_stack(
        [
            np.concatenate([_derivative(motion, series, _name(unknown)) for series in rollout.series])
            for unknown in rollout.unknowns
        ]
    )


def _derivative(motion: Trajectory, series: Series, by: str) -> Floats:
    """Of the values of one series; nan for an event that does not happen."""
    if not series.event:
        return np.asarray(motion.derivative(series.name, by)[rows_at(motion, series.times)])
    found = [event.time_derivative(by) for event in instants(motion, series.name)[: len(series.values)]]
    return np.array([*found, *[np.nan] * (len(series.values) - len(found))])
