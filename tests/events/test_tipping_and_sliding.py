"""A box that is pulled at its top tips, or slides and then tips: by moments and by Newton's law, on both sides of
mu = b/(2 h)."""

from __future__ import annotations

from functools import cache

import pytest
from models.corpus import path_of

import lagdsl

G_N, M, RISE = 9.80665, 20.0, 20.0
OPTIONS = ({"tolerance": 1e-3}, {"tolerance": 1e-6}, {}, {"tolerance": 1e-10}, {"solver": "rk4", "step": 1e-2})


@cache
def _box() -> lagdsl.Model:
    return lagdsl.compile(path_of("tipping_box"))


def _told(b: float, h: float, mu: float, options: dict[str, float]) -> dict[str, list[float]]:
    """Times of what is told up to a tenth of a second behind the first of it."""
    stop = M * G_N * min(mu, b / (2 * h)) / RISE + 0.1
    motion = _box().simulate(parameters={"b": b, "h": h, "mu": mu}, start={"y": h / 2}, stop=stop, **options)
    told: dict[str, list[float]] = {}
    for event in motion.events:
        told.setdefault(event.kind, []).append(float(event.time))
    return told


@pytest.mark.parametrize("options", OPTIONS)
@pytest.mark.parametrize("above", [1e-6, 1e-3, 1.5])
@pytest.mark.parametrize(("b", "h"), [(0.4, 1.0), (0.4 * (1 - 1e-6), 1.0), (0.404, 1.0), (0.42, 1.0), (0.32, 0.81)])
def test_it_tips(b: float, h: float, above: float, options: dict[str, float]) -> None:
    """The foot that has no load has no friction: it opens, and nothing slips."""
    told = _told(b, h, b / (2 * h) * (1 + above), options)
    assert told == {"opened": [pytest.approx(M * G_N * b / (2 * h) / RISE, rel=1e-11)]}


@pytest.mark.parametrize("options", OPTIONS)
@pytest.mark.parametrize("below", [1e-7, 1e-5, 1e-3, 5e-3])
def test_it_slides_and_tips_while_it_slides(below: float, options: dict[str, float]) -> None:
    b, h = 0.4, 1.1
    mu = b / (2 * h) * (1 - below)
    told = _told(b, h, mu, options)
    assert told["slips"] == [pytest.approx(M * mu * G_N / RISE, rel=1e-11)] * 2
    assert told["opened"] == [pytest.approx(M * G_N * (b / h - mu) / RISE, rel=1e-11)]


@pytest.mark.parametrize("mu", [0.1, 0.3, 0.7])
def test_a_foot_that_friction_alone_presses(mu: float) -> None:
    """Half of the weight is lifted at the left foot of a box that slides to the left: it bears friction's moment."""
    b, h = 0.4, 1.0
    text = path_of("tipping_box").read_text(encoding="utf-8")
    text = text.replace("coordinate Length x,", "coordinate Length x(der(start = -1 m/s)),")
    text = text.replace("force {rise*time, 0, 0} at top", "force {0, m*g_n/2, 0} at left")
    motion = lagdsl.compile(text).simulate(parameters={"mu": mu}, stop=0.1)
    assert motion["N_left"][-1] == pytest.approx(mu * M * G_N * h / (4 * b), rel=1e-10)
    assert motion["N_right"][-1] == pytest.approx(M * G_N * (1 / 2 - mu * h / (4 * b)), rel=1e-10)
