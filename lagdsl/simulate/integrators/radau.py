"""The implicit Runge-Kutta method Radau IIA of order 5, for stiff models; with our exact Jacobian.

Source: Hairer and Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.8; SciPy's Radau.
"""

from __future__ import annotations

from typing import Any

from lagdsl.simulate.integrators.method import Method, correct_one_step, newton_tolerance


def _make(*arguments: Any, **options: Any) -> Any:
    from scipy import integrate

    made = integrate.Radau(*arguments, **options)
    made.newton_tol = newton_tolerance(1e-6)
    return made


RADAU = Method("radau", 5, implicit=True, factor=1e-1, make=_make, correct=correct_one_step)
