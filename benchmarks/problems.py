"""The motions that integrators are compared on, the same for everybody."""

from dataclasses import dataclass
from math import asin, cos, sin, sqrt


@dataclass(frozen=True)
class Problem:
    """A model of models/, with `n` as its size; the state at the start, q and qd, and the time at the end [s].

    `stiff`: right-hand sides are counted, over all tolerances, for errors along the whole motion; else time is
    measured, for an error of GOAL at the end.
    """

    title: str
    model: str
    n: int | None
    start: tuple[float, ...]
    stop: float
    stiff: bool

    @property
    def times(self) -> list[float]:
        """States are compared at ROWS equidistant times of a stiff problem, with the end, and at the end of others."""
        rows = ROWS if self.stiff else 1
        return [self.stop * (k + 1) / rows for k in range(rows - 1)] + [self.stop]


GOAL = 1e-6
ROWS = 60
_RATIO = 0.3  # throw by rod
_ROD = -asin(_RATIO * sin(0.3))
_ROD_RATE = -50.0 * _RATIO * cos(0.3) / sqrt(1.0 - (_RATIO * sin(0.3)) ** 2)

PROBLEMS = {
    "double_pendulum": Problem("two links, 10 s", "planar_chain", 2, (1.0, 0.5, 0.0, 0.0), 10.0, stiff=False),
    "ten_links": Problem("ten links, 5 s", "planar_chain", 10, (0.5, *[0.05] * 9, *[0.0] * 10), 5.0, stiff=False),
    "slider_crank": Problem(
        "slider-crank in a stiff guide, 0.5 s",
        "stiff_slider_crank",
        None,
        (0.3, _ROD, 50.0, _ROD_RATE),
        0.5,
        stiff=True,
    ),
    "oscillator": Problem("van der Pol, epsilon 1e-6, 2 s", "stiff_oscillator", None, (2.0, 0.0), 2.0, stiff=True),
}
