"""Dormand and Prince's explicit Runge-Kutta method of order 5(4): for loose tolerances.

Source: Dormand and Prince, J. Comput. Appl. Math. 6 (1980) 19; SciPy's RK45.
"""

from __future__ import annotations

from typing import Any

from lagdsl.simulate.integrators.method import Method, correct_one_step


def _make(*arguments: Any, **options: Any) -> Any:
    from scipy import integrate

    return integrate.RK45(*arguments, **options)


RK45 = Method("rk45", 5, implicit=False, factor=1e-2, make=_make, correct=correct_one_step)
