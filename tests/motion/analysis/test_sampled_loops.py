"""Modes of models with clocks: the verdict is that of the loop, never that of a plant whose controller is held."""

from __future__ import annotations

import pytest

import lagdsl
from lagdsl.interfaces.api.model import Model

ROD = """model Rod "an inverted pendulum; {what}"
  coordinate Angle a;
  kinetic 1/2*(1 kg.m2)*der(a)^2;
  potential -1/2*(4 N.m/rad2)*a^2;
  dissipation 1/2*(1 N.m.s/rad)*der(a)^2;
  {discretes}
  {force}
equation
  {clause}
end Rod;
"""
HELD = "no statement on stability: the sampled controller is held"
STABLE, UNSTABLE = "stable: largest multiplier", "unstable: largest multiplier"


TYPES = {"u": "Torque u(start = 0)", "w": "Torque w(start = 0)", "on": "Boolean on(start = false)"}


def rod(force: str, clause: str) -> Model:
    discretes = " ".join(f"discrete {text};" for name, text in TYPES.items() if f"{name} = " in clause)
    return lagdsl.compile(ROD.format(what="held", discretes=discretes, force=force, clause=clause))


LAW = "-(20 N.m/rad)*a - (6 N.m.s/rad)*der(a);"


@pytest.mark.parametrize(
    ("force", "clause", "names", "verdict"),
    [
        ("torque u on a;", f"when sample(0, 10 ms) then u = {LAW} w = u; on = true; end when;", ("u",), STABLE),
        (
            "torque u on a;",
            f"when sample(0, 10 ms) then w = {LAW} on = not pre(on); end when; when change(on) then u = w; end when;",
            ("u",),
            STABLE,
        ),
        ("torque if on then -(1 N.m) else 0 on a;", "when sample(0, 10 ms) then on = a > 0; end when;", ("on",), HELD),
        ("torque 0 on a;", "when sample(0, 10 ms) then reinit(der(a), 0.5*der(a)); end when;", ("a",), UNSTABLE),
    ],
)
def test_the_verdict_is_that_of_the_loop(force: str, clause: str, names: tuple[str, ...], verdict: str) -> None:
    found = rod(force, clause).modes()
    assert found.held == names
    assert found.stability.startswith(verdict)
    assert found.unstable == 1  # of the rod alone


@pytest.mark.parametrize(
    ("force", "clause"),
    [
        ("torque 0 on a;", f"when sample(0, 10 ms) then w = {LAW} end when;"),  # a recorder
        ("torque if on then -(1 N.m) else 0 on a;", "when a > 1 then on = true; end when;"),  # no clock
        (
            "torque if on then -(1 N.m) else 0 on a;",
            f"when sample(0, 10 ms) then w = {LAW} end when; when time > 1 s then on = true; end when;",
        ),
    ],
)
def test_what_does_not_act_leaves_the_verdict(force: str, clause: str) -> None:
    found = rod(force, clause).modes()
    assert found.held == ()
    assert found.stability == "unstable equilibrium: 1 of 2 real parts are positive (monotonic growth)"


def test_thresholds_of_a_held_plant_are_told_as_such() -> None:
    model = rod("torque if on then -(1 N.m) else 0 on a;", "when sample(0, 10 ms) then on = a > 0; end when;")
    assert model.vary("der(a).start", "0:0.1:0.1 rad/s").held == ("on",)
