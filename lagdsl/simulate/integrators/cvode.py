"""CVODE of SUNDIALS, for comparison: backward differentiation formulas of orders 1 to 5 with our exact Jacobian.

Nothing needs it; where the library is installed it is loaded as it is. Every projection makes it start anew at order 1,
so it says little about models with constraints.

Source: Hindmarsh and others, ACM Trans. Math. Softw. 31 (2005) 363.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any

import numpy as np

from lagdsl.mechanics.rank import Floats
from lagdsl.simulate.integrators.method import Method, System

# The path of libsundials_cvode, where it is not where the system looks.
SUNDIALS_VARIABLE = "SUNDIALS_CVODE"


def has_sundials() -> bool:
    """Whether the library is there."""
    from lagdsl.simulate.integrators.sundials import library

    return library(os.environ.get(SUNDIALS_VARIABLE)) is not None


class _Stepper:
    """A stepper as SciPy has them."""

    def __init__(
        self, system: System, t: float, y: Floats, t_end: float, rtol: float, atol: Floats, first: float
    ) -> None:
        from lagdsl.simulate.integrators.sundials import Cvode, library

        found = library(os.environ.get(SUNDIALS_VARIABLE))
        assert found is not None
        self._solver = Cvode(found, system, system.jacobian, t, y, t_end, rtol, atol, first)
        self.t, self.y, self.t_bound = t, np.array(y, dtype=np.float64), t_end
        self.status = "running"
        self.h_abs = 0.0
        self.max_step = np.inf

    @property
    def atol(self) -> Floats:
        return self._solver.atol

    @atol.setter
    def atol(self, value: Floats) -> None:
        self._solver.atol = value

    def step(self) -> None:
        before = self.t
        if self._solver.step(self.t_bound, self.max_step):
            self.t, self.y = self._solver.t, self._solver.y.copy()
            self.h_abs = self.t - before
            self.status = "finished" if self.t >= self.t_bound else "running"
        else:
            self.status = "failed"

    def dense_output(self) -> Callable[[float], Floats]:
        return self._solver.inside

    def move(self, y: Floats) -> None:
        self.y = y
        self._solver.restart(self.t, y)


def _make(
    system: System,
    t: float,
    y: Floats,
    t_end: float,
    *,
    rtol: float,
    atol: Floats,
    jac: object,
    first_step: float = 0.0,
) -> Any:
    return _Stepper(system, t, y, t_end, rtol, atol, first_step)


def _correct(stepper: Any, system: System, y: Floats) -> None:
    stepper.move(y)


CVODE = Method("cvode", 5, implicit=True, factor=1e-2, make=_make, correct=_correct)
