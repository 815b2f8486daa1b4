"""Steps of one length, which the user gives: no error is estimated. The same methods as lag/fixed.h has in C.

`rk4`: the classical Runge-Kutta method of order 4. `leapfrog`: kick, drift, kick, of order 2; symplectic where forces
depend on positions only and the mass matrix is constant. `ros2`: linearly implicit, of order 2, L-stable.

Sources: Kutta, Z. Math. Phys. 46 (1901) 435; Hairer, Lubich and Wanner, Geometric Numerical Integration, 2nd ed.,
section I.1.4; Verwer, Spee, Blom and Hundsdorfer, SIAM J. Sci. Comput. 20 (1999) 1456, formula (2.1).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from lagdsl.mechanics.rank import Floats
from lagdsl.simulate.integrators.method import Method, System, correct_one_step

# A last step that would leave less than this part of itself is stretched.
_STRETCH = 1.01
_GAMMA = 1.0 - 0.5**0.5

# (system, t, y, its derivative, length) to the state at the end of the step.
Formula = Callable[[System, float, Floats, Floats, float], Floats]


class FixedSteps:
    """A stepper as SciPy has them, with cubic Hermite interpolation as dense output (of order 3)."""

    def __init__(
        self, formula: Formula, h: float, system: System, t: float, y: Floats, t_end: float, first: float
    ) -> None:
        self._formula, self._h, self._system = formula, h, system
        self._first, self._start, self._count = min(first, h), t, 0
        self.t, self.y, self.t_bound = t, np.array(y, dtype=np.float64), t_end
        self.f = system(t, self.y)
        self.status = "running"
        self.h_abs = h
        self.max_step = np.inf
        self.atol: Floats = np.zeros(len(self.y))
        self._before = (t, self.y, self.f)

    def step(self) -> None:
        """The next of them; the times are multiples of the length, not sums."""
        end = self._start + self._first + self._count * self._h
        if self.t_bound - self.t <= _STRETCH * (end - self.t):
            end = self.t_bound
        y = self._formula(self._system, self.t, self.y, self.f, end - self.t)
        if not np.all(np.isfinite(y)):
            self.status = "failed"
            return
        self._before = (self.t, self.y, self.f)
        self._count += 1
        self.t, self.y, self.f = end, y, self._system(end, y)
        if self.t >= self.t_bound:
            self.status = "finished"

    def dense_output(self) -> Callable[[float], Floats]:
        t, y, f = self._before
        return partial(_hermite, t, y, f, self.t, self.y, self.f)


def _hermite(t0: float, y0: Floats, f0: Floats, t1: float, y1: Floats, f1: Floats, t: float) -> Floats:
    h = t1 - t0
    x = (t - t0) / h
    line = (1.0 - x) * y0 + x * y1
    return line + x * (x - 1.0) * ((1.0 - 2.0 * x) * (y1 - y0) + (x - 1.0) * h * f0 + x * h * f1)


def _rk4(system: System, t: float, y: Floats, f: Floats, h: float) -> Floats:
    second = system(t + 0.5 * h, y + 0.5 * h * f)
    third = system(t + 0.5 * h, y + 0.5 * h * second)
    last = system(t + h, y + h * third)
    return y + h / 6.0 * (f + 2.0 * second + 2.0 * third + last)


def _leapfrog(system: System, t: float, y: Floats, f: Floats, h: float) -> Floats:
    """The second kick takes the rates that the first acceleration predicts; states z go by Heun's method."""
    n = system.n
    at = y + h * f
    at[:n] = y[:n] + h * (y[n : 2 * n] + 0.5 * h * f[n : 2 * n])
    last = system(t + h, at)
    at[n:] = y[n:] + 0.5 * h * (f[n:] + last[n:])
    return at


def _ros2(system: System, t: float, y: Floats, f: Floats, h: float) -> Floats:
    matrix = np.eye(len(y)) - _GAMMA * h * system.jacobian(t, y)
    first = np.linalg.solve(matrix, f)
    second = np.linalg.solve(matrix, system(t + h, y + h * first) - 2.0 * first)
    return y + h * (1.5 * first + 0.5 * second)


def _make(
    formula: Formula,
    h: float,
    system: System,
    t: float,
    y: Floats,
    t_end: float,
    *,
    rtol: float,
    atol: Floats,
    first_step: float = np.inf,
) -> Any:
    return FixedSteps(formula, h, system, t, y, t_end, first_step)


def _without_length(*_: Any, **__: Any) -> Any:
    raise ValueError("the length of the steps is missing")


def _method(name: str, order: int, formula: Formula) -> Method:
    fixed = partial(_make, formula)
    return Method(name, order, implicit=False, factor=1.0, make=_without_length, correct=correct_one_step, fixed=fixed)


RK4 = _method("rk4", 4, _rk4)
LEAPFROG = _method("leapfrog", 2, _leapfrog)
ROS2 = _method("ros2", 2, _ros2)


def with_steps(method: Method, h: float) -> Method:
    """A method of fixed steps, with their length [s]."""
    assert method.fixed is not None
    return replace(method, make=partial(method.fixed, h))
