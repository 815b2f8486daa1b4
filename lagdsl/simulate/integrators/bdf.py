"""Backward differentiation formulas of orders 1 to 5, for stiff models with many states; with our exact Jacobian.

Source: Shampine and Reichelt, SIAM J. Sci. Comput. 18 (1997) 1; SciPy's BDF.
"""

from __future__ import annotations

from typing import Any

from lagdsl.mechanics.rank import Floats
from lagdsl.simulate.integrators.method import Method, System, newton_tolerance


def _make(*arguments: Any, **options: Any) -> Any:
    from scipy import integrate

    made = integrate.BDF(*arguments, **options)
    made.newton_tol = newton_tolerance(1e-6)
    return made


def _correct(stepper: Any, system: System, y: Floats) -> None:
    """Shift the whole history by the correction, so that the differences, which carry the derivatives, stay."""
    stepper.D[0] += y - stepper.y
    stepper.y = y


BDF = Method("bdf", 5, implicit=True, factor=1e-2, make=_make, correct=_correct)
