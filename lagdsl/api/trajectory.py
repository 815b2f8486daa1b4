"""The motion with a picture: what `Model.simulate` returns."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING

from lagdsl.signals import trajectory

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Trajectory(trajectory.Trajectory):
    """Rows at the requested times; `trajectory["theta"]` is a column in SI units."""

    __slots__ = ()

    @classmethod
    def of(cls, motion: trajectory.Trajectory) -> Trajectory:
        return cls(**{field.name: getattr(motion, field.name) for field in fields(motion)})

    def plot(self, path: Path | str | None = None) -> Figure:
        """A figure of the columns over time, written to `path` if there is one; needs the extra `plot`."""
        from lagdsl.plot.figure import plot

        return plot(self, path)
