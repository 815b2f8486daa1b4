"""Dormand and Prince's explicit Runge-Kutta method of order 8(5,3) with dense output of order 7: the default.

Source: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, 2nd ed., section II.10; SciPy's DOP853.
"""

from __future__ import annotations

from typing import Any

from lagdsl.simulate.integrators.method import Method, correct_one_step


def _make(*arguments: Any, **options: Any) -> Any:
    from scipy import integrate

    return integrate.DOP853(*arguments, **options)


DOP853 = Method("dop853", 8, implicit=False, factor=1e-2, make=_make, correct=correct_one_step)
