"""Failure of a simulation: time, state, the name at fault, and the motion up to there."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from lagdsl.foundation.diagnostics import Diagnostic

if TYPE_CHECKING:
    from lagdsl.motion.signals.trajectory import Trajectory


class SimulationFailed(Exception):  # noqa: N818 the interface's name
    """The motion could not be continued. `str()` is the rendered diagnostic.

    `time` [s], `state` (values by name, SI units) and `name` (coordinate, state, constraint or invariant at fault)
    say where; `trajectory` holds the rows so far.
    """

    def __init__(
        self, diagnostic: Diagnostic, time: float, state: Mapping[str, float], name: str | None, trajectory: Trajectory
    ) -> None:
        super().__init__(diagnostic.message)
        self.diagnostic = diagnostic
        self.diagnostics = (diagnostic,)
        self.time = time
        self.state = dict(state)
        self.name = name
        self.trajectory = trajectory

    def __reduce__(self) -> tuple[type[SimulationFailed], tuple[Any, ...]]:
        """Exceptions are made anew from the arguments of their base class; a pool of processes waits for ever for one
        that cannot be."""
        return type(self), (self.diagnostic, self.time, self.state, self.name, self.trajectory)

    def __str__(self) -> str:
        from lagdsl.foundation.diagnostics.render import render_all

        return render_all(self.diagnostics)
