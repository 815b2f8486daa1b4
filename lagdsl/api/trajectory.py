"""The motion with a picture: what `Model.simulate` returns."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING

from lagdsl.signals import trajectory

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Trajectory(trajectory.Trajectory):
    """Rows at the requested times; `trajectory["theta"]` is a column in SI units."""

    __slots__ = ("_page",)
    _page: Callable[[], str]

    @classmethod
    def of(cls, motion: trajectory.Trajectory, page: Callable[[], str]) -> Trajectory:
        """`page` makes the page of the motion."""
        made = cls(**{field.name: getattr(motion, field.name) for field in fields(motion)})
        object.__setattr__(made, "_page", page)
        return made

    def show(self, path: Path | str | None = None, *, browser: bool = True) -> Path:
        """Write a page on which the motion is seen and can be changed, and open it in a browser; see `Model.show`."""
        from lagdsl.api.shown import write_page

        return write_page(self._page(), self.model, path, browser=browser)

    def _repr_html_(self) -> str:
        from lagdsl.api.shown import framed

        return framed(self._page(), self.model)

    def plot(self, path: Path | str | None = None) -> Figure:
        """A figure of the columns over time, written to `path` if there is one; needs the extra `plot`."""
        from lagdsl.plot.figure import plot

        return plot(self, path)
