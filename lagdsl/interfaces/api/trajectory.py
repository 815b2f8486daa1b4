"""The motion with a picture: what `Model.simulate` returns."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING

from lagdsl.foundation.diagnostics import refused
from lagdsl.motion.signals import trajectory

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# Reads and writes a field, past the check that nobody writes.
_FIELDS = tuple(
    (getattr(trajectory.Trajectory, field.name).__get__, getattr(trajectory.Trajectory, field.name).__set__)
    for field in fields(trajectory.Trajectory)
)


class Trajectory(trajectory.Trajectory):
    """Rows at the requested times; `trajectory["theta"]` is a column in SI units."""

    __slots__ = ("_page",)
    _page: Callable[[], str] | None

    @classmethod
    def of(cls, motion: trajectory.Trajectory, page: Callable[[], str] | None = None) -> Trajectory:
        """`page` makes the page of the motion; None where no page can repeat it."""
        made = object.__new__(cls)  # a copy, without a look at its values
        for read, write in _FIELDS:
            write(made, read(motion))
        object.__setattr__(made, "_page", page)
        return made

    def show(self, path: Path | str | None = None, *, browser: bool = True) -> Path:
        """Write a page on which the motion is seen and can be changed, and open it in a browser; see `Model.show`.

        Raises CallRefused where a controller or a caller set inputs on the way."""
        from lagdsl.interfaces.api.shown import write_page

        if self._page is None:
            raise refused("E0897")
        return write_page(self._page(), self.model, path, browser=browser)

    def _repr_html_(self) -> str | None:
        from lagdsl.interfaces.api.shown import framed

        return None if self._page is None else framed(self._page(), self.model)

    def plot(
        self,
        path: Path | str | None = None,
        *,
        show: str | Sequence[str] | None = None,
        xy: tuple[str, str] | Sequence[tuple[str, str]] | None = None,
    ) -> Figure:
        """A figure of the columns over time, written to `path` (.png, .svg, .pdf) if there is one; needs the extra
        `plot`.

        `show="theta, der(theta)"` chooses columns, two units on two axes; a list of such texts has a panel for each.
        `xy=("theta", "der(theta)")` draws the second against the first; a list of such pairs has a panel for each.
        Raises KeyError for a name that no column has.
        """
        from lagdsl.documents.plot.figure import plot_of

        return plot_of(self, path, show=show, xy=xy)
