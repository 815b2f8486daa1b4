"""What a method is to the step loop: a stepper of SciPy whose state may be corrected between steps."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from lagdsl.mechanics.rank import Floats

# SciPy takes no smaller relative tolerance. All of the error control is in the absolute tolerances, which follow the
# motion.
SMALLEST_RELATIVE = 2.3e-14


class System(Protocol):
    """The first-order system y' = f(t, y) with its exact Jacobian; y begins with n coordinates and their rates."""

    n: int

    def __call__(self, t: float, y: Floats) -> Floats: ...

    def jacobian(self, t: float, y: Floats) -> Floats: ...


@dataclass(frozen=True, slots=True)
class Method:
    """`factor`: local tolerance as a part of the tolerance asked for, so that the motion as a whole is about that
    accurate.

    `start(system, t, y, t_end, atol, first_step)` makes SciPy's stepper; `correct(stepper, y)` gives it another
    present state. `fixed(h, ...)` is what `make` is where the user gives the length of the steps; None: the method
    chooses it.
    """

    name: str
    order: int
    implicit: bool
    factor: float
    make: Callable[..., Any]
    correct: Callable[[Any, System, Floats], None]
    fixed: Callable[..., Any] | None = None

    def start(self, system: System, t: float, y: Floats, t_end: float, atol: Floats, first_step: float | None) -> Any:
        """A stepper at (t, y) that will not step beyond t_end."""
        further: dict[str, Any] = {"jac": system.jacobian} if self.implicit else {}
        if first_step is not None:
            further["first_step"] = min(first_step, t_end - t)
        return self.make(system, t, y, t_end, rtol=SMALLEST_RELATIVE, atol=atol, **further)


def correct_one_step(stepper: Any, system: System, y: Floats) -> None:
    """For methods that remember nothing but the present state and its derivative."""
    stepper.y = y
    stepper.f = system(stepper.t, y)


def newton_tolerance(relative: float) -> float:
    """Part of the error tolerance to which stage equations are solved. Source: Hairer and Wanner II, section IV.8."""
    return float(max(10.0 * np.finfo(np.float64).eps / relative, min(0.03, relative**0.5)))
