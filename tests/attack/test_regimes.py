"""No event is lost on a loop: every tolerance, fixed steps, thirty starts; six of them in `make check`."""

from __future__ import annotations

from functools import cache
from math import sqrt

import numpy as np
import pytest
from attack.regimes import BOB, FEW, LATCH, REGIMES, STARTS, STEP, STRIKERS, G, Machine, Regime, above, below, starts
from choice import paired, spread

import lagdsl
from lagdsl.interfaces.api.model import Model

RESTITUTION = 0.6


@cache
def compiled(text: str) -> Model:
    return lagdsl.compile(text, engine="tape")


def named(cases: list[tuple[Machine, Regime]]) -> pytest.MarkDecorator:
    ids = [f"{machine.name}-{regime.name}" for machine, regime in cases]
    return pytest.mark.parametrize(("machine", "regime"), cases, ids=ids)


in_regimes = pytest.mark.parametrize("regime", REGIMES, ids=lambda regime: regime.name)


@named(paired(STRIKERS, REGIMES))
def test_what_is_located_as_closing_strikes(machine: Machine, regime: Regime) -> None:
    """Newton's law at the first blow, whose speed is known: nothing closes without it."""
    model = compiled(machine.text)
    for start in starts(machine):
        motion = model.simulate(start=start, **regime.options)
        first = motion.events[0]
        assert first.kind == "impact", (start, motion.events[:3])
        row = int(np.searchsorted(motion.time, first.time))
        before, after = (_rate_of_gap(machine, motion, i) for i in (row, row + 1))
        assert after == pytest.approx(-RESTITUTION * before, rel=1e-9), start
        assert abs(motion["gap"][row]) < 1e-3 * regime.near + 1e-12, start
        if machine.approach is not None:
            assert before == pytest.approx(machine.approach(start), rel=regime.near), start


def _rate_of_gap(machine: Machine, motion: lagdsl.Trajectory, row: int) -> float:
    if machine.name == "crank":
        return -float(motion["der(P.s)"][row])
    if machine.name == "four_bar":
        return 0.4 * float(np.cos(motion["A.q"][row]) * motion["der(A.q)"][row])
    return float(motion["der(y)"][row])


@in_regimes
def test_a_plastic_landing_is_an_impact_too(regime: Regime) -> None:
    for i in range(0, STARTS, 6):
        motion = compiled(BOB).simulate(start=above(i), parameters={"e": 0}, **regime.options)
        assert [event.kind for event in motion.events] == ["impact", "closed"]
        assert motion.events[0].time == motion.events[1].time
        assert abs(motion["der(y)"][-1]) < 1e-9


@in_regimes
def test_a_latch_takes_hold_where_its_relation_turns(regime: Regime) -> None:
    for i in spread(range(STARTS), FEW):
        motion = compiled(LATCH).simulate(start=below(i), **regime.options)
        assert [event.kind for event in motion.events] == ["true"], (i, motion.events)
        assert motion["x"][-1] == pytest.approx(0.1, abs=1e-7)
        assert motion["der(x)"][-1] == pytest.approx(0.0, abs=1e-9)


@in_regimes
def test_a_step_of_energy_keeps_the_energy(regime: Regime) -> None:
    """A bob that is high enough passes the step, the others turn back: with all of their energy."""
    for i in spread(range(STARTS), FEW):
        start = below(i)
        motion = compiled(STEP).simulate(start=start, **regime.options)
        assert np.ptp(motion["E"]) < 10 * regime.near, (i, np.ptp(motion["E"]))
        passes = G * (start["y"] + sqrt(0.99)) > 0.5
        assert bool(motion.events) == passes, i
