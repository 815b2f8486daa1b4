"""Thin beams and other motions that take millions of steps have a certificate in seconds."""

from __future__ import annotations

import pytest

import lagdsl
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.exchange.verify import motion as motion_module
from lagdsl.exchange.verify.certify import certify
from lagdsl.exchange.verify.conserved.find import conserved_quantities
from lagdsl.exchange.verify.first_steps import first_steps
from lagdsl.exchange.verify.states import random_states
from lagdsl.motion.pipeline import Compilation

FAST = """model Fast
  coordinate Length x(start = 1 m);
  kinetic 1/2*(1 kg)*der(x)^2;
  potential 1/2*(1e8 N/m)*x^2;
  invariant E: energy();
  annotation(experiment(StopTime = 10, Tolerance = 1e-8));
end Fast;
"""


def _compiled(text: str) -> Compilation:
    return lagdsl.compile(text)._compilation


def _thin(beam: str, section: str, n: int = 1) -> Compilation:
    return _compiled(
        f"model Thin import Lag.Flexible.{beam};"
        f"{beam} arm(n = {n}, L = 1 m, A = 60 mm^2, {section} = 45 mm^4, density = 2700 kg/m3, zeta = 0.02);"
        "gravity = -g_n*world.y; connect(world, arm); end Thin;"
    )


def test_a_long_motion_is_looked_at_for_its_first_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    """An oscillator with 16000 periods: the part that is looked at is told, and its lines hold."""
    monkeypatch.setattr(motion_module, "_MOST_STEPS", 500)
    found = {line.name: line for line in certify(_compiled(FAST)).lines}
    assert found["motion"].verdict == "left out"
    assert "more than 500 steps" in found["motion"].note
    held = {name for name, line in found.items() if line.verdict == "held"}
    assert {"invariant E", "tangents of the motion", "order of the steps"} <= held
    assert not any(line.verdict == "failed" for line in found.values())


def test_ticks_of_clocks_are_steps() -> None:
    """A clock that ticks 10000 times: its first 100 ticks are within 0.1 s."""
    text = FAST.replace("1e8 N/m", "1 N/m").replace(
        "  invariant",
        "  discrete Real n;\nequation\n  when sample(0 s, 1 ms) then n = pre(n) + 1; end when;\n  invariant",
    )
    compilation = _compiled(text)
    end = first_steps(engine_of(compilation.program, "tape"), compilation.flat, 100, 1e-8)
    assert 0.0 < end <= 0.1


def test_a_thin_rod_turned_by_quaternions_has_regular_states() -> None:
    """The inertia of its turns is 1e-8 of a constraint between them."""
    compilation = _thin("SpatialExactBeam", "Iy", 3)
    assert random_states(compilation.flat, compilation.program)


def test_a_damped_thin_beam_keeps_no_energy() -> None:
    """Its dissipation is a ten-thousand-millionth of the power of its strains at random states."""
    assert conserved_quantities(_thin("ExactBeam", "I")) == ()
