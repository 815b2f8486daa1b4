"""Machines whose parts engage, lock and let go: an indexing drive, a flyback converter, braked planets, a yo-yo."""

from __future__ import annotations

from math import cos, exp, pi, sqrt

from attack.rows import Attack, check, model, rows
from scipy.integrate import quad

R = sqrt(0.5)  # of the pin of a Geneva drive with four slots, at the distance 1


def star(a: float) -> float:
    """The speed of the star by that of the driver."""
    return float(R * (cos(a) - R) / (1 - 2 * R * cos(a) + R * R))


ENGAGED = quad(lambda a: sqrt(1 + star(a) ** 2 / 2) / 3, -pi / 4, pi / 4, epsabs=1e-14)[0]  # at the energy 9/2
GENEVA = (
    "parameter Real r = sqrt(0.5); coordinate Real a(start = -2, der(start = 3)), b(start = -pi/4); "
    "kinetic 1/2*der(a)^2 + 1/4*der(b)^2; Real w = wrap(a); discrete Integer n(start = 0); "
    "constraint slot: b = (if abs(w) < pi/4 then pi/2*n + atan2(r*sin(w), 1 - r*cos(w)) else pi/2*n - pi/4);"
)


def flyback(stop: float, h: float = 0.05) -> tuple[float, float]:
    """Currents of coils of 0.1 and 0.4 with 0.15 in common: where one ends, the linkage of the other one stays."""
    i1, i2, t = 0.0, 0.0, 0.0
    while True:
        i1, i2 = i1 + 0.15 * i2 / 0.1, 0.0
        d = min(h / 2, stop - t)
        i1, t = 10 + (i1 - 10) * exp(-10 * d), t + h / 2
        if d < h / 2:
            return i1, i2
        i1, i2 = 0.0, 0.15 * i1 / 0.4
        d = min(h / 2, stop - t)
        i2, t = max(0.0, i2 - 3 / 0.4 * d), t + h / 2
        if d < h / 2:
            return i1, i2


# the ring is held, from 1 s on the carrier: sun' = 4 carrier', then sun' = -3 ring'
CARRIER = 8 / (16 * 0.1 + 0.3)
RING = -12 * 0.1 * CARRIER / (9 * 0.1 + 0.4) - 6 / (9 * 0.1 + 0.4)
UNWINDING = 9 * 0.01 / (0.02 + 0.01)  # the acceleration of a yo-yo

MACHINES = [
    Attack(
        "geneva_drive",
        model(GENEVA, "when w > pi/4 then n = pre(n) + 1; end when;"),
        (2 - pi / 4) / 3 + ENGAGED + pi / 2 + ENGAGED + 0.1,
        {"a": 2 * pi + pi / 4 + 0.3, "der(a)": 3.0, "b": pi - pi / 4},
    ),
    Attack(
        "flyback_converter",
        model(
            "coordinate Real p, s; kinetic 1/2*0.1*der(p)^2 + 1/2*0.4*der(s)^2 + 0.15*der(p)*der(s); "
            "dissipation 1/2*der(p)^2; discrete Boolean on(start = true), d(start = false); "
            "force (if on then 10 else 0) on p; force -3 on s; "
            "constraint switch: (if on then 0 else der(p)) = 0; constraint diode: (if d then 0 else der(s)) = 0;",
            "when sample(0, 0.05) then on = true; elsewhen sample(0.025, 0.05) then on = false; end when; "
            "when sample(0, 0.05) then d = false; elsewhen sample(0.025, 0.05) then d = true; "
            "elsewhen der(s) < 0 then d = false; end when;",
        ),
        0.515,
        dict(zip(("der(p)", "der(s)"), flyback(0.515), strict=True)),
    ),
    Attack(
        "planetary_gear_with_brakes",
        "model Brakes import Lag.Rotational.*; Planetary p(ratio = 3); Rotor s(J = 0.1 kg.m2), r(J = 0.4 kg.m2), "
        "c(J = 0.3 kg.m2); connect(p.sun, s.phi); connect(p.ring, r.phi); connect(p.carrier, c.phi); "
        "torque 2 N.m on s.phi; discrete Integer held(start = 1); "
        "constraint first: (if held == 1 then der(r.phi) else 0) = 0; "
        "constraint second: (if held == 2 then der(c.phi) else 0) = 0; "
        "equation when time > 1 s then held = 2; end when; end Brakes;",
        2.0,
        {"der(p.ring)": RING, "p.carrier": CARRIER / 2, "der(p.sun)": -3 * RING},
    ),
    Attack(
        # at the lower end of its string, where it begins to wind up, it keeps its energy
        "yo_yo",
        model(
            "coordinate Real y, a(start = -5); gravity = {0, -9, 0}; mass 1 at {0, y}; kinetic 1/2*0.02*der(a)^2; "
            "constraint string: y = 0.1*abs(a) - 0.5;"
        ),
        1.5 * sqrt(1 / UNWINDING),
        {"y": -0.5 + 0.375, "der(a)": 0.5 * sqrt(UNWINDING) / 0.1},
    ),
]


@rows(MACHINES)
def test_machines_with_events(row: Attack, engine: str) -> None:
    check(row, engine)
