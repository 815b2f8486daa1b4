"""Machines whose events lie on loops, to be run at every tolerance, with fixed steps and from many starts.

The interpolant of a step is off the constraints by the tolerance; a projection moves the state at an event, and with
it gaps and relations. No event may be lost by that.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from math import cos, radians, sin, sqrt
from typing import Any

import numpy as np
from choice import spread

import lagdsl

G = 9.81
STARTS = 30
FEW = 6  # of them in `make check`


@dataclass(frozen=True)
class Regime:
    """Options of a run, and how exact it is, as a part of the largest values."""

    name: str
    options: Mapping[str, Any]
    near: float


REGIMES = [
    Regime("1e-2", {"tolerance": 1e-2}, 5e-2),
    Regime("1e-3", {"tolerance": 1e-3}, 5e-3),
    Regime("1e-6", {"tolerance": 1e-6}, 1e-5),
    Regime("default", {}, 1e-7),
    Regime("1e-10", {"tolerance": 1e-10}, 1e-9),
    Regime("radau", {"solver": "radau", "tolerance": 1e-6}, 1e-4),
    Regime("rk4", {"solver": "rk4", "step": 0.002}, 1e-6),
    Regime("ros2", {"solver": "ros2", "step": 0.002}, 5e-3),
    Regime("leapfrog", {"solver": "leapfrog", "step": 0.002}, 5e-3),
]

ROD = f"""
  coordinate Length x(start = 0.8 m), y(start = 0.6 m);
  gravity = -{G} m/s2*world.y;
  mass 1 kg at {{x, y}};
  constraint rod: x^2 + y^2 = 1 m2;
  output Energy E = energy();
"""

BOB = f"""
model Bob "A bob on a rod strikes a floor"
  parameter Real e = 0.6;
  {ROD}
  contact floor: y >= 0.1 m with restitution = e;
  output Length gap = y - 0.1 m;
  annotation(experiment(StopTime = 1.2));
end Bob;
"""

SLIDES = f"""
model Slides "A rod between two slides strikes a floor"
  coordinate Length x(start = 0.8 m), y(start = 0.6 m);
  gravity = -{G} m/s2*world.y;
  mass 1 kg at {{x, 0}};
  mass 1 kg at {{0, y}};
  constraint rod: x^2 + y^2 = 1 m2;
  contact floor: y >= 0.1 m with restitution = 0.6;
  output Length gap = y - 0.1 m;
  annotation(experiment(StopTime = 1.2));
end Slides;
"""

CRANK = f"""
model Crank "A slider-crank of components with a stop at the slider"
  import Lag.Planar.*;
  Link crank(l = 0.3 m, m = 1 kg), rod(l = 0.8 m, m = 1 kg);
  Revolute A(q(start = 60 deg, fixed = true)), B(q(start = -80 deg)), C;
  Prismatic P(s(start = 0.9 m));
  Body slider(m = 1 kg);
  gravity = -{G} m/s2*world.y;
  connect(world, A, crank, B, rod, C, slider);
  connect(world, P, slider);
  contact stop: P.s <= 1 m with restitution = 0.6;
  output Length gap = 1 m - P.s;
  annotation(experiment(StopTime = 1.2));
end Crank;
"""

CRANK_BY_ONE_ANGLE = f"""
model Crank "The same with one coordinate and no constraint"
  coordinate Angle a(start = 60 deg);
  Angle b = asin(0.3*sin(a)/0.8);
  Length s = (0.3 m)*cos(a) + (0.8 m)*cos(b);
  gravity = -{G} m/s2*world.y;
  frame K = world.rotz(a);
  frame Q = world.at({{s, 0}}).rotz(-b);
  body crank(m = 1 kg, com = {{0.15 m, 0}}, Izz = (1 kg)*(0.3 m)^2/12) on K;
  body rod(m = 1 kg, com = {{-0.4 m, 0}}, Izz = (1 kg)*(0.8 m)^2/12) on Q;
  mass 1 kg at {{s, 0}};
  contact stop: s <= 1 m with restitution = 0.6;
  output Length gap = 1 m - s;
  annotation(experiment(StopTime = 1.2));
end Crank;
"""

FOUR_BAR = f"""
model FourBar "The coupler's end strikes a floor"
  import Lag.Planar.*;
  Link crank(l = 0.4 m, m = 1 kg), coupler(l = 1 m, m = 2 kg), rocker(l = 0.8 m, m = 1.5 kg);
  Revolute A(q(start = 60 deg, fixed = true)), B(q(start = -30 deg)), C(q(start = -110 deg)), D;
  Fixed pin(r = {{1 m, 0}});
  gravity = -{G} m/s2*world.y;
  connect(world, A, crank, B, coupler, C, rocker, D, pin);
  contact floor: crank.frame_b.origin.y >= 0.05 m with restitution = 0.6;
  output Length gap = crank.frame_b.origin.y - 0.05 m;
  annotation(experiment(StopTime = 0.8));
end FourBar;
"""

LATCH = f"""
model Latch "A clause holds the bob where it passes a height"
  {ROD}
  discrete Boolean held(start = false);
  constraint latch: (if held then 1 else 0)*(x - 0.1 m) = 0;
  annotation(experiment(StopTime = 1));
equation
  when x <= 0.1 m then
    held = true;
  end when;
end Latch;
"""

STEP = f"""
model Step "The bob passes a step of energy, to and fro"
  {ROD}
  potential if x > 0.1 m then 0 J else 0.5 J;
  annotation(experiment(StopTime = 2));
end Step;
"""

Values = Mapping[str, float]
Rows = Mapping[str, "np.ndarray[Any, Any]"]


def above(i: int) -> Values:
    angle = 0.15 + 1.0 * i / (STARTS - 1)
    return {"x": cos(angle), "y": sin(angle)}


def below(i: int) -> Values:
    angle = -1.2 + 2.1 * i / (STARTS - 1)
    return {"x": cos(angle), "y": sin(angle)}


def turned(i: int) -> Values:
    return {"A.q": radians(50 + 30 * i / (STARTS - 1))}


def lifted(i: int) -> Values:
    return {"A.q": radians(20 + 50 * i / (STARTS - 1))}


@cache
def crank_by_one_angle(angle: float) -> float:
    """The rate of the gap at the first blow."""
    motion = lagdsl.compile(CRANK_BY_ONE_ANGLE, engine="tape").simulate(start={"a": angle}, tolerance=1e-11)
    first = next(event.time for event in motion.events if event.kind == "impact")
    row = int(np.searchsorted(motion.time, first))
    q, qd = motion["a"][row], motion["der(a)"][row]
    b = np.arcsin(0.3 * sin(q) / 0.8)
    return float(qd * (0.3 * sin(q) + 0.8 * sin(b) * 0.3 * cos(q) / (0.8 * cos(b))))


@dataclass(frozen=True)
class Machine:
    """`approach` is the rate of the gap at the first blow from start i, where it is known."""

    name: str
    text: str
    start: Callable[[int], Values]
    approach: Callable[[Values], float] | None = None


def of_bob(start: Values) -> float:
    return -sqrt(2 * G * (start["y"] - 0.1)) * sqrt(0.99)


def of_slides(start: Values) -> float:
    """m (x'^2 + y'^2)/2 with x x' = -y y' at y = 0.1."""
    return -sqrt(2 * G * (start["y"] - 0.1) / (1 + 0.01 / 0.99))


STRIKERS = [
    Machine("bob", BOB, above, of_bob),
    Machine("slides", SLIDES, above, of_slides),
    Machine("crank", CRANK, turned, lambda start: crank_by_one_angle(start["A.q"])),
    Machine("four_bar", FOUR_BAR, lifted),
]


def starts(machine: Machine) -> Iterator[Values]:
    return map(machine.start, spread(range(STARTS), FEW))
