"""A start does not depend on what nothing ties to it: positions, rates and initial equations beside strangers."""

from __future__ import annotations

import numpy as np
import pytest
from choice import engines, paired

import lagdsl

SIZES = (1e-9, 1e-7, 1e7, 1e9)
ENGINES = engines(("tape", "numpy"))

# Links 2, 3, 4 and ground 5 m: placed from guesses, moved by one rate.
LINKAGE = """
  coordinate Length x(start = 1.2 m, der(start = 1 m/s)), y(start = 1.4 m), u(start = 4.1 m), v(start = 2.3 m);
  kinetic 1/2*(1 kg)*(der(x)^2 + der(y)^2) + 1/2*(3 kg)*(der(u)^2 + der(v)^2);
  constraint crank: x^2 + y^2 = (2 m)^2;
  constraint coupler: (x - u)^2 + (y - v)^2 = (3 m)^2;
  constraint rocker: (u - 5 m)^2 + v^2 = (4 m)^2;
"""
# c + d is a speed of 1 m/s, shared 5 : 1 by least kinetic energy.
PAIR = """
  coordinate Length c, d;
  kinetic 1/2*(1 kg)*der(c)^2 + 1/2*(5 kg)*der(d)^2;
  constraint total: der(c) + der(d) = 1 m/s;
"""
STRANGER = "coordinate Length far(start = {0} m, der(start = {0} m/s)); kinetic 1/2*({1} kg)*der(far)^2;"
TIED = STRANGER + "coordinate Length off(start = 2*{0} m); kinetic 1/2*({1} kg)*der(off)^2; constraint tie: off = far;"


def _start(items: str, engine: str) -> dict[str, float]:
    model = lagdsl.compile(f"model Beside gravity = 0; {items} end Beside;", engine=engine)
    state = model.initial_state()
    names = [*model.coordinates, *(f"der({name})" for name in model.coordinates)]
    return dict(zip(names, np.concatenate([state.q, state.qd]).tolist(), strict=True))


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize(("size", "stranger"), paired(SIZES, [STRANGER, TIED]))
def test_linkage(engine: str, size: float, stranger: str) -> None:
    alone = _start(LINKAGE, engine)
    beside = _start(LINKAGE + stranger.format(size, 1.0), engine)
    for name, value in alone.items():
        # which of the positions is the nearest is found to 1e-11 of the sizes
        assert beside[name] == pytest.approx(value, rel=0.0, abs=5e-11), name
    x, y, u, v = (beside[name] for name in "xyuv")
    assert x * x + y * y == pytest.approx(4.0, abs=1e-14)
    assert (x - u) ** 2 + (y - v) ** 2 == pytest.approx(9.0, abs=1e-14)
    assert (u - 5.0) ** 2 + v * v == pytest.approx(16.0, abs=1e-14)
    assert beside["der(x)"] == pytest.approx(1.0, abs=1e-14)


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize(
    ("mass", "size", "stranger"), paired([1e-18, 1e-9, 1e9, 1e20], [1e-9, 1.0, 1e9], [STRANGER, TIED])
)
def test_least_kinetic_energy(engine: str, mass: float, size: float, stranger: str) -> None:
    beside = _start(PAIR + stranger.format(size, mass), engine)
    assert beside["der(c)"] == pytest.approx(5.0 / 6.0, abs=1e-14)
    assert beside["der(d)"] == pytest.approx(1.0 / 6.0, abs=1e-14)


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize("size", SIZES)
def test_initial_equations(engine: str, size: float) -> None:
    """A spring's rest under a force, 10 N over 40 N/m, beside a pair whose rates follow least kinetic energy."""
    spring = (
        "coordinate Length s(start = 0.1 m); kinetic 1/2*(2 kg)*der(s)^2; potential 1/2*(40 N/m)*s^2; force 10 N on s;"
    )
    stranger = STRANGER.format(size, 1.0)
    beside = _start(f"{PAIR} {spring} {stranger} initial equation der(s) = 0; der(der(s)) = 0;", engine)
    assert beside["s"] == pytest.approx(0.25, abs=1e-10)
    assert beside["der(s)"] == pytest.approx(0.0, abs=1e-10)
    assert beside["der(c)"] == pytest.approx(5.0 / 6.0, abs=1e-14)
    assert beside["far"] == size
    assert beside["der(far)"] == size
