"""Large motions by the implicit method: matrices in a band, Jacobians along several directions at once."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import expm

import lagdsl
from lagdsl.engines.runtime.engines.tape_engine import TapeEngine

COUNT = 60
CHAIN = f"""
model Chain "Masses between walls, one behind the other"
  structural parameter Integer N = {COUNT};
  parameter Real k(unit = "N/m") = 4e4 "Springs";
  parameter Real c(unit = "N.s/m") = 2e3 "Dampers";
  coordinate Length x[N](start = {{sin(pi*i/(N + 1))*(1 m) for i in 1:N}});
  gravity = 0;
  for i in 1:N loop
    kinetic 1/2*(1 kg)*der(x[i])^2;
  end for;
  for i in 1:N + 1 loop
    potential 1/2*k*((if i > N then 0 m else x[min(i, N)]) - (if i == 1 then 0 m else x[max(i - 1, 1)]))^2;
    dissipation 1/2*c
      *((if i > N then 0 m/s else der(x[min(i, N)])) - (if i == 1 then 0 m/s else der(x[max(i - 1, 1)])))^2;
  end for;
end Chain;
"""


def positions(stiffness: float, damping: float, t: float) -> np.ndarray:
    """By the exponential of the matrix of the linear system."""
    one, zero = np.eye(COUNT), np.zeros((COUNT, COUNT))
    links = 2 * one - np.eye(COUNT, k=1) - np.eye(COUNT, k=-1)
    start = np.sin(np.pi * np.arange(1, COUNT + 1) / (COUNT + 1))
    system = np.block([[zero, one], [-stiffness * links, -damping * links]])
    return (expm(system * t) @ np.concatenate([start, 0 * start]))[:COUNT]


@pytest.mark.parametrize("solver", ["radau", "auto"])
def test_a_stiff_chain_moves_as_the_matrix_exponential_says(solver: str) -> None:
    model = lagdsl.compile(CHAIN, engine="tape")
    for stiffness, damping in ((4e4, 2e3), (2e4, 6e3)):  # what parameters alone change is prepared anew
        motion = model.simulate(
            stop=0.5, interval=0.1, solver=solver, tolerance=1e-8, parameters={"k": stiffness, "c": damping}
        )
        assert motion.statistics.solver == "radau"
        found = np.array([motion[f"x[{i}]"][-1] for i in range(1, COUNT + 1)])
        assert np.max(np.abs(found - positions(stiffness, damping, 0.5))) < 1e-6


def test_auto_steps_over_fast_waves_that_oscillate_but_are_no_part_of_the_motion() -> None:
    """The slowest mode alone, of 10 rad/s. The fastest, of 400 rad/s, has a damping ratio of 0.04."""
    model = lagdsl.compile(CHAIN, engine="tape")
    motion = model.simulate(stop=5.0, interval=5.0, tolerance=1e-4, parameters={"c": 8.0})
    assert motion.statistics.solver == "radau"
    found = np.array([motion[f"x[{i}]"][-1] for i in range(1, COUNT + 1)])
    assert np.max(np.abs(found - positions(4e4, 8.0, 5.0))) < 1e-3


COUPLED = """
model Coupled "Every mass is damped against every other: no band"
  structural parameter Integer N = 40;
  parameter Real c(unit = "N.s/m") = 25;
  coordinate Length x[N](der(start = {i*(1 m/s) for i in 1:N}));
  gravity = 0;
  for i in 1:N loop
    kinetic 1/2*(1 kg)*der(x[i])^2;
    for j in 1:i - 1 loop
      dissipation 1/2*c*(der(x[i]) - der(x[j]))^2;
    end for;
  end for;
end Coupled;
"""


def test_auto_tries_no_matrices_that_cost_more_than_the_whole_motion() -> None:
    """Speeds approach their mean at the rate c N. Matrices of 80 states without a band cost 600 evaluations."""
    model = lagdsl.compile(COUPLED, engine="tape")
    short, long = (model.simulate(stop=stop, interval=stop, solver="auto", tolerance=1e-6) for stop in (0.2, 3.0))
    assert short.statistics.solver == "dop853"
    assert short.statistics.jacobians == 0  # their entries tell how large the matrices are
    assert long.statistics.solver == "radau"
    for motion, t in ((short, 0.2), (long, 3.0)):
        speeds = np.arange(1, 41)
        expected = speeds.mean() * t + (speeds - speeds.mean()) * -np.expm1(-1e3 * t) / 1e3
        assert np.max(np.abs([motion[f"x[{i}]"][-1] for i in speeds] - expected)) < 1e-4


def test_what_is_raised_while_directions_are_made_is_raised(monkeypatch: pytest.MonkeyPatch) -> None:
    def made(_: TapeEngine) -> None:
        raise MemoryError("no room")

    monkeypatch.setattr(TapeEngine, "along", made)
    with pytest.raises(MemoryError, match="no room"):
        lagdsl.compile(COUPLED, engine="tape").simulate(stop=0.01, interval=0.01, solver="radau")


def test_directions_are_not_made_for_the_few_of_a_band(monkeypatch: pytest.MonkeyPatch) -> None:
    """Columns that share no row are one direction: so few are followed sooner than functions of several are made."""
    made: list[TapeEngine] = []
    monkeypatch.setattr(TapeEngine, "along", made.append)
    motion = lagdsl.compile(CHAIN, engine="tape").simulate(stop=0.01, interval=0.01, solver="radau")
    assert motion.statistics.jacobians > 0
    assert not made


FAR = """
model Far "Masses at stiff springs a kilometer from the origin, which pull a slow one"
  structural parameter Integer n = 20;
  coordinate Length x[n](start = {1 km + i*(1 m) for i in 1:n});
  coordinate Length y(start = 1 m);
  gravity = 0;
  kinetic 1/2*(1 kg)*der(y)^2;
  potential 1/2*(1 N/m)*(y - (x[n] - 1 km - n*(1 m)))^2;
  for i in 1:n loop
    kinetic 1/2*(1 g)*der(x[i])^2;
    potential 1/2*(1e6 N/m)*(x[i] - (if i == 1 then 1 km else x[max(i - 1, 1)]) - 1 m)^2;
  end for;
end Far;
"""


def test_auto_leaves_explicit_steps_that_round_off_makes_short() -> None:
    """A position is known to 1e-13 m, a force to 1e-7 N: accelerations have a noise of 1e-4 m/s2."""
    model = lagdsl.compile(FAR, engine="tape")
    explicit = model.simulate(stop=0.02, interval=0.02, solver="dop853", tolerance=1e-6)
    motion = model.simulate(stop=0.02, interval=0.02, tolerance=1e-6)
    assert motion.statistics.evaluations < 0.2 * explicit.statistics.evaluations
    assert motion["y"][-1] == pytest.approx(np.cos(0.02), abs=1e-7)  # the springs give way by 2e-5 m
