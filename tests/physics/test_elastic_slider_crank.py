"""A slider-crank with an elastic rod, by energies, against the IVP Test Set, and its gradient."""

from __future__ import annotations

from pathlib import Path

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
    "u1": (-5.323907988763734e-06, 1e-11),
    "u2": (-8.363283141616840e-06, 1e-11),
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


@pytest.mark.parametrize("solver", ["radau", "dop853"])
def test_the_end_is_that_of_the_test_set(model: lagdsl.Model, solver: str) -> None:
    motion = model.simulate(stop=0.1, interval=0.1, tolerance=1e-9, solver=solver)
    for name, (value, apart) in END.items():
        assert motion[name][-1] == pytest.approx(value, abs=apart, rel=0), name


def test_the_gradient_by_radau_is_that_of_differences(model: lagdsl.Model) -> None:
    """Richardson's extrapolation of whole runs, by parameters that move the end much more than errors of runs do."""
    options = {"stop": 0.1, "interval": 0.1, "tolerance": 1e-11, "solver": "radau"}
    motion = model.simulate(tangents=["Omega", "l2"], **options)
    for name, value in (("Omega", 150.0), ("l2", 0.3)):
        slopes = []
        for part in (2e-5, 1e-5):
            one, other = (model.simulate(parameters={name: value * (1 + sign * part)}, **options) for sign in (1, -1))
            slopes.append({of: (one[of][-1] - other[of][-1]) / (2 * part * value) for of in ("psi", "x")})
        for of in ("psi", "x"):
            expected = (4 * slopes[1][of] - slopes[0][of]) / 3
            assert motion.derivative(of, name)[-1] == pytest.approx(expected, rel=1e-8), (of, name)
