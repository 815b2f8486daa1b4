"""A slider-crank with an elastic rod, by energies, against the IVP Test Set, and its gradient."""

from __future__ import annotations

from pathlib import Path

import elastic_slider_crank_by_hand as hand
import numpy as np
import pytest

import lagdsl

MODEL = Path(__file__).parents[2] / "benchmarks" / "models" / "elastic_slider_crank.lag"

# F. Mazzia, C. Magherini, Test Set for Initial Value Problem Solvers (2008), problem crank: values at 0.1 s, by name,
# and how far they may be off. The start has nine digits, and nothing damps what they leave in how the rod stretches.
END = {
    "psi": (-3.311734987910881e-01, 1e-10),
    "x": (1.697373326718410e-01, 1e-10),
    "w1": (1.893192460247178e-04, 1e-10),
    "w2": (2.375751865617931e-05, 1e-10),
    "u1": (-5.323907988763734e-06, 2e-11),
    "u2": (-8.363283141616840e-06, 4e-11),
    "der(psi)": (6.025346682645789e01, 1e-6),
    "der(x)": (-8.753116989887888e00, 1e-6),
    "der(w1)": (-3.005536801092212e-02, 1e-6),
    "der(w2)": (-5.500488291932075e-03, 1e-6),
    "der(u1)": (4.978243404809343e-04, 1e-6),
    "der(u2)": (1.104933470696396e-03, 1e-6),
}


@pytest.fixture(scope="module")
def model() -> lagdsl.Model:
    return lagdsl.compile(MODEL)


@pytest.fixture(scope="module")
def by_hand() -> np.ndarray:
    return hand.gradient(0.1, 600)


@pytest.mark.parametrize("solver", ["radau", "dop853"])
def test_the_end_is_that_of_the_test_set(model: lagdsl.Model, solver: str) -> None:
    motion = model.simulate(stop=0.1, interval=0.1, tolerance=1e-9, solver=solver)
    for name, (value, apart) in END.items():
        assert motion[name][-1] == pytest.approx(value, abs=apart, rel=0), name


@pytest.mark.parametrize("solver", ["radau", "dop853"])
def test_the_gradient_by_ten_parameters_is_that_of_an_integration_by_hand(
    model: lagdsl.Model, by_hand: np.ndarray, solver: str
) -> None:
    """Of psi and x each one to 1e-8 of itself, by parameters that move them by 1e-6 of themselves, too.

    How the rod bends and stretches is known to 1e-8 of itself at these tolerances, and so its derivatives are. Rounding
    decides their last two digits: of three motions the middle value of each error counts.
    """
    errors = []
    for tolerance in (1e-11, 8e-12, 6e-12) if solver == "dop853" else (1e-11,):
        motion = model.simulate(
            stop=0.1, interval=0.1, tolerance=tolerance, solver=solver, tangents=list(hand.PARAMETERS)
        )
        own = [[motion.derivative(of, name)[-1] * p for name, p in hand.PARAMETERS.items()] for of in hand.COLUMNS]
        errors.append(np.abs(np.array(own) - by_hand))
    error = np.median(errors, axis=0)
    assert (error[:2] < 1e-8 * np.abs(by_hand[:2])).all()
    assert (error < 1e-7 * np.abs(by_hand).max(axis=1, keepdims=True)).all()
