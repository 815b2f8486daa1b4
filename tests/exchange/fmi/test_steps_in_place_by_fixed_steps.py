"""Events under `solver.step`: steps of energy, corners, contacts, clauses and clocks within steps of fixed length."""

from __future__ import annotations

from math import sqrt
from zlib import crc32

import pytest
from choice import spread
from fmpy.fmi1 import FMICallException

from fmi.importing import slave
from fmi.texts import exported_text

# Crosses with the energy that is left, or is thrown back where the energy does not suffice.
TEXT = """model PlaceOfAStep
  parameter Real speed = 0.9, push = 0;
  coordinate Real x(der(start = speed));
  kinetic 1/2*der(x)^2;
  potential if x < 0.3 then 0 else 0.5;
  force push on x;
  output Real v = der(x);
  annotation(units = "none", experiment(StopTime = 1));
end PlaceOfAStep;
"""
ACROSS = sqrt(1.2**2 - 2 * 0.5)
# From 0 at 0.5 under 1 it comes to 0.3 with sqrt(0.85) after 0.42195, and goes back with that.
BACK = sqrt(0.85)
LEFT = 1 - (BACK - 0.5)


@pytest.mark.parametrize("step", [1e-3, 3e-3, 0.01])
@pytest.mark.parametrize(
    ("speed", "push", "x", "v"),
    [
        (0.9, 0.0, -0.3, -0.9),
        (1.2, 0.0, 0.3 + (1 - 0.25) * ACROSS, ACROSS),
        (0.5, 1.0, 0.3 - BACK * LEFT + LEFT**2 / 2, -BACK + LEFT),
    ],
)
def test_fixed_steps_keep_the_energy_at_a_step_in_place(
    step: float, speed: float, push: float, x: float, v: float
) -> None:
    fmu = exported_text(TEXT, 2)
    with slave(fmu) as one:
        one.initialize({"speed": speed, "push": push, "solver.step": step}, stop=1.0)
        for k in range(10):
            one.step(k / 10, 0.1)
        found = one.get("x", "v")
    assert found == pytest.approx([x, v], abs=1e-9)


BEND = sqrt(0.5)
ON = (
    "coordinate Real x(start = -0.3037, der(start = 1)), y(start = {}); gravity = 0; mass 1 at {{x, y}}; "
    "constraint c: y = {};"
)
DRIVEN = (
    "coordinate Real x, y; kinetic 1/2*(der(x)^2 + der(y)^2 + der(x)*der(y)); constraint c: x = max(0, time - 0.5051);"
)
LOCKED = "coordinate Real x(der(start = 1)); discrete Boolean locked; kinetic 1/2*der(x)^2; constraint c: {} = 0;"
LOCK = "when x > 0.5051 then locked = true; end when;"
RAMP = (
    "coordinate Real x(start = -0.8, der(start = 1)), y(start = 0.1, der(start = 0.5)); "
    "kinetic 1/2*(der(x)^2 + der(y)^2); constraint c: y = limit((x + 1)/2, 0, 0.2511);"
)
CARRIED = "coordinate Real x; gravity = 0; mass 1 at {x + max(0, time - 0.5051), 0};"


def bent(body: str, clauses: str = "", **outputs: str) -> str:
    """A text that tells these quantities."""
    told = " ".join(f"output Real {name} = {value};" for name, value in outputs.items())
    free = 'annotation(units = "none", experiment(StopTime = 1));'
    equation = f"\nequation\n  {clauses}" if clauses else ""
    name = f"Bent{crc32((body + told + clauses).encode())}"
    return f"model {name}\n  {body}\n  {told}\n  {free}{equation}\nend {name};\n"


def moved(text: str, step: float, stop: float = 1.0) -> tuple[float, float]:
    """a and b at `stop`."""
    with slave(exported_text(text, 2)) as one:
        one.initialize({"solver.step": step}, stop=stop)
        for k in range(10):
            one.step(k * stop / 10, stop / 10)
        a, b = one.get("a", "b")
    return float(a), float(b)


PASSED = {
    # speed 1 along the track, before and behind its corner
    "valley": (bent(ON.format(0.3037, "abs(x)"), a="x", b="der(y)"), 0.6963, 1.0),
    "steep": (bent(ON.format(0.9111, "3*abs(x)"), a="x", b="der(y)"), 0.6963, 3.0),
    "ramp": (bent(ON.format(0, "max(0, x)"), a="x", b="der(x)"), 0.6963 * BEND, BEND),
    "bend": (bent(ON.format(0, "if x < 0 then 0 else x + x^2"), a="y - x - x^2", b="der(x)^2 + der(y)^2"), 0.0, 1.0),
    "level": (bent(RAMP, a="x", b="der(y)"), -0.4978 + 0.6978 * sqrt(1.25), 0.0),
    # corners of time: the momentum of y is zero all the time, that of a mass on the drive, too
    "drive": (bent(DRIVEN, a="x", b="y"), 0.4949, -0.4949 / 2),
    "carried": (bent(CARRIED, a="x", b="der(x)"), -0.4949, -1.0),
    # a clause closes a constraint where it is satisfied
    "lock": (bent(LOCKED.format("(if locked then x - 0.5051 else 0)"), LOCK, a="x", b="der(x)"), 0.5051, 0.0),
}


@pytest.mark.parametrize("step", [1e-3, 3e-3, 0.01])
@pytest.mark.parametrize(
    ("text", "a", "b"),
    spread(PASSED.values(), 4),
    ids=spread(PASSED, 4),
)
def test_fixed_steps_pass_corners(step: float, text: str, a: float, b: float) -> None:
    assert moved(text, step) == pytest.approx((a, b), abs=1e-9)


@pytest.mark.parametrize("step", [1e-3, 3e-3, 0.01])
def test_fixed_steps_ride_on_a_ground_that_starts_and_stops(step: float) -> None:
    body = "coordinate Real y; gravity = {0, -8, 0}; mass 1 at {0, y}; "
    ground = "contact c: y >= limit(time - 0.6051, 0, 0.3) with restitution = 0;"
    thrown = 1 - 0.9051  # with the speed 1 from the height 0.3
    found = moved(bent(body + ground, a="y", b="der(y)"), step)
    assert found == pytest.approx((0.3 + thrown - 4 * thrown**2, 1 - 8 * thrown), abs=1e-9)


# Down the left side of a valley of 45 degrees with x' = 1 + t/2: at the bottom after FALL with DOWN, and thrown back.
DOWN = sqrt(2)
FALL = 2 * DOWN - 2
VALLEY = (
    "coordinate Real x(start = -1, der(start = 1)), y(start = 1, der(start = -1)); gravity = {0, -1, 0}; "
    "mass 1 at {x, y}; contact c: y >= abs(x) with restitution = 0.5;"
)
# From 1 under 2/s^2: on the ground after 1 with 2, back with 1.
BALL = "coordinate Real h(start = 1); kinetic 1/2*der(h)^2; force -2 on h;"
COUNT = "discrete Real n;"


LOCATED = {
    "valley": (bent(VALLEY, a="x", b="der(x)"), FALL + 0.6, 0.09 - 0.3 * DOWN, 0.3 - DOWN / 2),
    "reinit": (
        bent(BALL, "when h < 0 then reinit(der(h), -pre(der(h))/2); end when;", a="h", b="der(h)"),
        1.4,
        0.24,
        0.2,
    ),
    "impact": (bent(BALL, "when h < 0 then impact(h, 0.5); end when;", a="h", b="der(h)"), 1.4, 0.24, 0.2),
    "contact": (bent(BALL + "contact c: h >= 0 with restitution = 0.5;", a="h", b="der(h)"), 1.4, 0.24, 0.2),
    "clock": (
        bent(BALL + COUNT, "when sample(0, 0.004) then n = pre(n) + 1; end when;", a="n", b="der(h)"),
        0.9,
        226,
        -1.8,
    ),
}


@pytest.mark.parametrize("step", [1e-3, 0.01, 0.1])
@pytest.mark.parametrize(
    ("text", "stop", "a", "b"),
    spread(LOCATED.values(), 3),
    ids=spread(LOCATED, 3),
)
def test_fixed_steps_locate_events(step: float, text: str, stop: float, a: float, b: float) -> None:
    assert moved(text, step, stop) == pytest.approx((a, b), abs=1e-9)


def test_fixed_steps_do_not_let_a_ball_through_the_ground() -> None:
    """The bounces of a `reinit` accumulate at 3: no motion goes on from there."""
    with pytest.raises(FMICallException):
        moved(bent(BALL, "when h < 0 then reinit(der(h), -pre(der(h))/2); end when;", a="h", b="der(h)"), 0.01, 4.0)


REFUSED = {
    "step": bent(ON.format(0, "(if x > 0 then 0.0005 else 0)"), a="x", b="y"),
    "shifted": bent(ON.format(-0.3037, "x + (if x > 0 then 0.5 else 0)"), a="x", b="y"),
    "time": bent(DRIVEN.replace("max(0, time - 0.5051)", "if time > 0.5051 then 0.1 else 0"), a="x", b="x"),
    "lock": bent(LOCKED.format("(if locked then x - 0.55 else 0)"), LOCK, a="x", b="x"),
}


@pytest.mark.parametrize("step", [1e-3, 0.01])
@pytest.mark.parametrize(
    "text",
    spread(REFUSED.values(), 2),
    ids=spread(REFUSED, 2),
)
def test_fixed_steps_refuse_positions_that_jump(step: float, text: str) -> None:
    with pytest.raises(FMICallException):
        moved(text, step)
