"""Rates of a start where linkages stand one on another: constraints tie few rates, the mass matrix ties all."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import null_space

import lagdsl

CHAIN = """
model Chain "Four-bars, each standing on the coupler of the one before"
  structural parameter Integer N = 3;
  parameter Length l1 = {crank} m, l2 = {coupler} m, l3 = {rocker} m, d = {base} m;
  coordinate Angle a[N](each start = {a} deg), b[N](each start = {b} deg), c[N](each start = {c} deg);
  frame crank[N], coupler[N], rocker[N];
  gravity = 0;
  for i in 1:N loop
    frame crank[i] = (if i == 1 then world else coupler[i-1]).rotz(a[i]);
    frame coupler[i] = crank[i].move({{l1, 0}}).rotz(b[i]);
    frame rocker[i] = (if i == 1 then world else coupler[i-1]).move({{d, 0}}).rotz(c[i]);
    body bar1(m = 1 kg, com = {{l1/2, 0}}, Izz = 0.1 kg.m2) on crank[i];
    body bar2(m = 2 kg, com = {{l2/2, 0}}, Izz = 0.2 kg.m2) on coupler[i];
    body bar3(m = 3 kg, com = {{l3/2, 0}}, Izz = 0.3 kg.m2) on rocker[i];
    constraint l1*cos(a[i]) + l2*cos(a[i] + b[i]) = d + l3*cos(c[i]);
    constraint l1*sin(a[i]) + l2*sin(a[i] + b[i]) = l3*sin(c[i]);
  end for;
end Chain;
"""
BENT = CHAIN.format(crank=0.4, coupler=1, rocker=0.8, base=1, a=60, b=-33, c=83)
# A parallelogram that lies flat: both its branches begin here.
FLAT = CHAIN.format(crank=0.5, coupler=1, rocker=0.5, base=1, a=0, b=0, c=0)


def test_rates_that_nothing_decides_have_the_least_kinetic_energy() -> None:
    """(v - w)' M (v - w) is least where J v = 0 and the written rate holds: M (v - w) is orthogonal to what is free."""
    model = lagdsl.compile(BENT, engine="tape")
    state = model.initial_state(start={"der(a[2])": 1.0})
    held = [name == "a[2]" for name in model.coordinates]
    mass, jacobian = model.mass_matrix(0.0, state.q), model.constraint_jacobian(0.0, state.q)
    wanted = np.where(held, 1.0, 0.0)
    free = null_space(np.vstack([jacobian, np.eye(len(held))[held]]))
    assert free.shape[1] == 2
    assert np.max(np.abs(jacobian @ state.qd)) < 1e-13
    assert state.qd[held] == pytest.approx(1.0, abs=1e-14)
    assert np.max(np.abs(free.T @ mass @ (state.qd - wanted))) < 1e-12
    assert np.max(np.abs(state.qd[1:3])) > 1e-2  # the crank moves the others: nothing holds them


def test_linkages_in_singular_positions_have_the_rates_of_one_alone() -> None:
    """Contradicting rates become those of the nearest branch: flat bars turn as (1, -1, 1) or as (1, -3, -1)."""
    chain = lagdsl.compile(FLAT, engine="tape")
    given = {f"der({name}[{i}])": rate for i in (1, 2, 3) for name, rate in zip("abc", (1.0, -1.2, 0.9), strict=True)}
    state = chain.initial_state(start=given)
    alone = lagdsl.compile(FLAT, engine="tape", structural={"N": 1})
    one = alone.initial_state(start={name: rate for name, rate in given.items() if "[1]" in name})
    rates = dict(zip(chain.coordinates, state.qd.tolist(), strict=True))
    for name, rate in zip(("a", "b", "c"), one.qd.tolist(), strict=True):
        for i in (1, 2, 3):
            assert rates[f"{name}[{i}]"] == pytest.approx(rate, abs=1e-9)
    assert one.qd[0] > 0.8
    assert one.qd == pytest.approx(one.qd[0] * np.array([1.0, -1.0, 1.0]), abs=1e-9)
