"""Forces that jump along the motion, with `floor`, `ceil`, `mod` and `wrap`: starts and stops at rest on an edge, and
motions over many edges. On each stair the motion is harmonic."""

from __future__ import annotations

from math import atan2, cos, floor, hypot, pi, sin

import pytest
from attack.rows import Attack, Later, check, model, rows

import lagdsl

RATE, STAIR = 10.0, 0.01  # of der(der(x)) = -RATE^2*(x + STAIR*number)
ON_STAIRS = "coordinate Real x(start = {}); kinetic 1/2*der(x)^2; force -100*(x + {}) on x;"


def moved(x: float, number: int, stop: float) -> tuple[float, float]:
    """Place and rate after `stop` of rest at x on the stair of this number, which reaches from number*STAIR to the
    next. It turns round where it does not reach an edge."""
    v = t = 0.0
    while True:
        middle = -number * STAIR
        size, phase = hypot(x - middle, v / RATE), atan2(-v / RATE, x - middle)
        found = []
        for edge, way in ((number * STAIR, -1), ((number + 1) * STAIR, 1)):
            part = (edge - middle) / size
            if abs(part) < 1 - 1e-15:
                angle = -way * abs(atan2((1 - part * part) ** 0.5, part))  # there it goes that way
                found.append(((angle - phase) % (2 * pi) / RATE, edge, way, angle))
        found = [each for each in found if each[0] > 1e-12]
        ahead = min(found)
        if t + ahead[0] > stop:
            angle = RATE * (stop - t) + phase
            return middle + size * cos(angle), -RATE * size * sin(angle)
        t, x, v, number = t + ahead[0], ahead[1], -RATE * size * sin(ahead[3]), number + ahead[2]


def ends(start: float, number: int, stop: float) -> Later:
    def compute() -> dict[str, float]:
        return dict(zip(("x", "der(x)"), moved(start, number, stop), strict=True))

    return Later(compute)


STAIRS = {
    "floor": "0.01*floor(100*x)",
    "ceil": "0.01*(ceil(100*x) - 1)",
    "mod": "x - mod(x, 0.01)",
    "wrap": "x - (wrap(200*pi*x - pi) + pi)/(200*pi)",
}
STOPS = (
    "coordinate Real x(start = 0.9, der(start = 1)); kinetic 1/2*der(x)^2; discrete Real on(start = 0);"
    "force -100*on*(x + 0.01*floor(100*x)) on x;"
)
# They come back to rest on their edge at about 0.44 later: what follows depends on digits.
EDGES = [
    *(
        Attack(
            f"{name}_by_{solver}_{tolerance:g}",
            model(ON_STAIRS.format(1, text)),
            0.4,
            ends(1.0, 99, 0.4),
            {},
            solver=solver,
            tolerance=tolerance,
        )
        for name, text in STAIRS.items()
        for solver in ("auto", "dop853", "radau")
        for tolerance in (1e-4, 1e-8, 1e-10)
    ),
    *(
        Attack(
            f"between_edges_{tolerance:g}",
            model(ON_STAIRS.format(0.995, STAIRS["floor"])),
            1.0,
            ends(0.995, 99, 1.0),
            tolerance=tolerance,
        )
        for tolerance in (1e-6, 1e-10)
    ),
    Attack(
        "stopped_on_an_edge",
        model(STOPS, "when x >= 1 then reinit(der(x), 0); on = 1; end when;"),
        0.5,
        ends(1.0, 99, 0.4),
        near=1e-7,
    ),
]


@rows(EDGES)
def test_a_motion_on_stairs_is_harmonic_on_each(row: Attack, engine: str) -> None:
    check(row, engine)


@pytest.mark.parametrize("start", [0.995, 1.0])
def test_stairs_keep_the_energy_and_cost_few_steps(start: float) -> None:
    """The work of the stairs to x is STAIR times the area below them."""
    text = ON_STAIRS.format(start, STAIRS["floor"]) + " output Real e = 1/2*der(x)^2 + 50*x^2;"
    motion = lagdsl.compile(model(text)).simulate(stop=0.4, tolerance=1e-9)

    def work(x: float) -> float:
        number = floor(x / STAIR)
        return number * (x - number * STAIR) + STAIR * number * (number - 1) / 2

    kept = [e + work(x) for e, x in zip(motion["e"], motion["x"], strict=True)]
    assert max(kept) - min(kept) <= 1e-8
    assert motion.statistics.steps <= 6 * len(motion.events)


@pytest.mark.parametrize("angle", ["{}", "2*({}) + 1", "1 - {}"])
def test_whole_turns_in_a_sine_are_no_events(angle: str) -> None:
    text = "coordinate Real a(der(start = 20)); Real w = {}; kinetic 1/2*der(a)^2; force -9*sin({}) on a;"
    smooth, wrapped = (
        lagdsl.compile(model(text.format(name, angle.format("w")))).simulate(stop=20, tolerance=1e-9)
        for name in ("a", "wrap(a)")
    )
    assert not wrapped.events
    assert len(wrapped.time) == len(smooth.time)
    assert abs(wrapped["a"][-1] - smooth["a"][-1]) <= 1e-6


def test_a_force_that_holds_a_rate_on_its_edge_is_refused() -> None:
    held = lagdsl.compile(
        model("coordinate Real x(start = 1); kinetic 1/2*der(x)^2; force -100*x - floor(10*der(x)) on x;")
    )
    with pytest.raises(lagdsl.SimulationFailed, match="E0804"):
        held.simulate(stop=1)
