"""Derivatives of a controller's law by the present that it reads: central differences of the sixth order, as the
runtime takes them at instants (lag/sensitivities/differences.h)."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from lagdsl.foundation.numerics.rank import Floats

_PLACES = np.array([-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0])
_SIXTH = np.array([-1.0, 9.0, -45.0, 0.0, 45.0, -9.0, 1.0]) / 60.0
_FOURTH = np.array([0.0, 1.0, -8.0, 0.0, 8.0, -1.0, 0.0]) / 12.0
_BROKEN = np.array([0.0, -1.0, 4.0, -6.0, 4.0, -1.0, 0.0]) / 3.0  # of a slope that is another one on the other side
_STEP = 2.0**-8  # as a part of natural sizes
_LEVELS = 5
_ROUNDINGS = 64.0


def differences(law: Callable[[Floats], Floats], here: Floats, along: Floats) -> Floats | None:
    """(nu,): of `law`, which makes (nu,) of (n,), at `here` (n,) along `along` (n,); None: there is none."""
    extent = float(np.nanmax(np.abs(along) / np.maximum(np.abs(here), 1.0), initial=0.0))
    if extent == 0.0:
        return np.zeros_like(law(here))
    found, least, step = None, np.inf, 16.0 * _STEP
    for _ in range(_LEVELS):
        h = step / extent
        values = np.array([law(here + place * h * along) for place in _PLACES])
        sixth = _SIXTH @ values / h
        sizes = np.maximum(np.abs(values[3]), 1.0)
        rounding = _ROUNDINGS * np.finfo(float).eps * sizes / h
        broken = np.abs(_BROKEN @ values) / h > _STEP * (sizes * extent + np.abs(sixth)) + rounding
        if not broken.any():
            bent = float(np.max(np.abs(sixth - _FOURTH @ values / h) / (sizes * extent), initial=0.0))
            left = bent**1.5 + np.finfo(float).eps / step
            if not left < least:
                break
            found, least = sixth, left
        step /= 16.0
    return found
