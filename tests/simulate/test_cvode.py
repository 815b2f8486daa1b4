"""CVODE, where SUNDIALS is installed; what is said where it is not."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import lagdsl
from lagdsl.simulate.integrators.cvode import has_sundials

OSCILLATOR = """model Oscillator
  parameter Real mu = 1000;
  state Real x(start = 2), y(start = 0);
equation
  der(x) = y*(1 Hz);
  der(y) = mu*((1 - x^2)*y - x)*(1 Hz);
end Oscillator;
"""

installed = pytest.mark.skipif(not has_sundials(), reason="SUNDIALS is not installed")


def test_without_sundials_it_is_said(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("SUNDIALS_CVODE", str(tmp_path / "nothing.so"))
    with pytest.raises(ValueError, match=r"SUNDIALS, which is not found: .* SUNDIALS_CVODE"):
        lagdsl.compile(OSCILLATOR).simulate(stop=1.0, solver="cvode")


@installed
@pytest.mark.parametrize("engine", ["numpy", "c"])
def test_it_agrees_with_radau(engine: str) -> None:
    model = lagdsl.compile(OSCILLATOR, engine=engine)
    motion = model.simulate(stop=1.0, interval=0.1, solver="cvode", tolerance=1e-8)
    exact = model.simulate(stop=1.0, interval=0.1, solver="radau", tolerance=1e-9)
    assert motion.statistics.solver == "cvode"
    assert 0 < motion.statistics.jacobians < motion.statistics.evaluations
    for name in ("x", "y"):
        np.testing.assert_allclose(motion[name], exact[name], rtol=1e-5, atol=1e-6)


@installed
def test_what_inputs_raise_comes_through() -> None:
    model = lagdsl.compile(
        "model Pushed input Force F = 0 N; coordinate Length x; mass 1 kg at x*world.x; gravity = 0; "
        "force F on x; end Pushed;"
    )

    def force(t: float) -> float:
        if t > 0.5:
            raise RuntimeError("out of data")
        return 1.0

    with pytest.raises(RuntimeError, match="out of data"):
        model.simulate(stop=1.0, inputs={"F": force}, solver="cvode")
