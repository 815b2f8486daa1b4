"""Andrews' squeezing mechanism: the values that the IVP Test Set prints for t = 0.03 s."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from models.references.squeezer import PINS, andrews_squeezer

import lagdsl

MODEL = Path(__file__).parents[2] / "models" / "andrews_squeezer.lag"

# Mazzia and Magherini, Test Set for Initial Value Problem Solvers, release 2.4, problem `andrews`. The printed digits
# themselves are good to about 1e-10 of their size: integration of the printed equations with extended precision gives
# beta = 15.810771195153709.
PRINTED = (
    0.1581077119629904e2,
    -0.1575637105984298e2,
    0.4082224013073101e-1,
    -0.5347301163226948,
    0.5244099658805304,
    0.5347301163226948,
    0.1048080741042263e1,
)
BETA = 15.810771195153709


def test_the_end_is_the_printed_one() -> None:
    motion = lagdsl.compile(MODEL, engine="tape").simulate(tolerance=1e-12)
    assert motion.time[-1] == 0.03
    end = [motion[pin][-1] for pin in PINS]
    np.testing.assert_allclose(end, PRINTED, rtol=3e-10)
    np.testing.assert_allclose(end[0], BETA, rtol=1e-12)


def test_the_printed_equations_lead_there() -> None:
    end = [column[-1] for column in andrews_squeezer({}, np.array([0.0, 0.03])).values()]
    np.testing.assert_allclose(end, PRINTED, rtol=3e-10)
    np.testing.assert_allclose(end[0], BETA, rtol=1e-12)
