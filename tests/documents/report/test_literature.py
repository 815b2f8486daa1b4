"""Printed equations against those of textbooks or of a formulation by hand, typed and evaluated at random values.

The left column is read from the text that people see; the right column is the equation of the book in Python.
"""

from __future__ import annotations

from collections.abc import Callable
from math import cos, sin
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from choice import chosen, spread

from lagdsl.derivation.textbook.recipe import recipe
from lagdsl.documents.report.derivation import render
from lagdsl.foundation.diagnostics import Sink
from lagdsl.motion.pipeline import flatten_file, read
from report.printed import equations, residual

_ROOT = Path(__file__).parents[3]


def pendulum(v: Any) -> list[float]:
    """The simple pendulum, in every textbook: m l² θ̈ + m g l sin θ = 0."""
    return [v.m * v.l**2 * v.dd + v.m * v.g * v.l * sin(v.a)]


def bead_on_hoop(v: Any) -> list[float]:
    """Taylor, Classical Mechanics (2005), the bead on a spinning hoop: θ̈ = (w^2 cos θ - g/R) sin θ, times m R^2."""
    return [v.m * v.R**2 * (v.dd - (v.w**2 * cos(v.a) - v.g / v.R) * sin(v.a))]


def double_pendulum(v: Any) -> list[float]:
    """The Lagrangian of the coplanar double pendulum in Landau, Lifshitz, Mechanics, differentiated by hand."""
    m, a, b = v.m1 + v.m2, v.a, v.b
    first = (
        m * v.l1**2 * v.add + v.m2 * v.l1 * v.l2 * (v.bdd * cos(a - b) + v.bd**2 * sin(a - b)) + m * v.g * v.l1 * sin(a)
    )
    second = v.m2 * v.l2**2 * v.bdd + v.m2 * v.l1 * v.l2 * (v.add * cos(a - b) - v.ad**2 * sin(a - b))
    return [first, second + v.m2 * v.g * v.l2 * sin(b)]


def wedge(v: Any) -> list[float]:
    """Taylor, Classical Mechanics (2005), the block on a sliding wedge; with a dashpot under the wedge."""
    return [
        (v.M + v.m) * v.xdd + v.m * v.sdd * cos(v.al) + v.D * v.xd,
        v.m * v.xdd * cos(v.al) + v.m * v.sdd - v.m * v.g * sin(v.al),
    ]


def gyroscope(v: Any) -> list[float]:
    """Angular momentum about the outer and the inner axis, by hand: n is the spin of the rotor in space, I3 its polar
    moment; the weight adds m c^2 across and m g c sin."""
    across = v.I1 + v.mw * v.c**2  # transverse moment of rotor and weight about the pivot
    n, nd = v.ad * cos(v.b) + v.sd, v.add * cos(v.b) - v.ad * v.bd * sin(v.b) + v.sdd
    outer = v.Io * v.add + (across + v.Iy) * (v.add * sin(v.b) ** 2 + 2 * v.ad * v.bd * sin(v.b) * cos(v.b))
    outer += v.Iz * (v.add * cos(v.b) ** 2 - 2 * v.ad * v.bd * sin(v.b) * cos(v.b))
    outer += v.I3 * (nd * cos(v.b) - n * v.bd * sin(v.b))
    inner = (v.Ix + across) * v.bdd - (v.Iy + across - v.Iz) * v.ad**2 * sin(v.b) * cos(v.b)
    inner += v.I3 * n * v.ad * sin(v.b) - v.mw * v.g * v.c * sin(v.b)
    return [outer, inner, v.I3 * nd]


def rolling_coin(v: Any) -> list[float]:
    """Newton's and Euler's equations by hand: forces of contact are m times the acceleration of the center; the
    moments follow from the angular velocity in axes that do not spin with the coin."""
    s, c, sl, cl = sin(v.psi), cos(v.psi), sin(v.th), cos(v.th)
    # r = (x + R s sl, y - R c sl), differentiated twice
    ax = v.xdd + v.R * (
        v.psidd * c * sl - v.psid**2 * s * sl + 2 * v.psid * v.thd * c * cl + v.thdd * s * cl - v.thd**2 * s * sl
    )
    ay = v.ydd + v.R * (
        v.psidd * s * sl + v.psid**2 * c * sl + 2 * v.psid * v.thd * s * cl - v.thdd * c * cl + v.thd**2 * c * sl
    )
    az = -v.R * (v.thdd * sl + v.thd**2 * cl)
    A, C = v.m * v.R**2 / 4, v.m * v.R**2 / 2
    n, nd = v.psid * sl + v.spd, v.psidd * sl + v.psid * v.thd * cl + v.spdd
    heading = A * (v.psidd * cl**2 - 2 * v.psid * v.thd * sl * cl) + C * (nd * sl + n * v.thd * cl)
    heading += v.m * v.R * sl * (ax * c + ay * s)
    lean = A * (v.thdd + v.psid**2 * sl * cl) - C * n * v.psid * cl
    lean += v.m * v.R * (cl * (ax * s - ay * c) - sl * az) - v.m * v.g * v.R * sl
    return [v.m * ax - v.l1, v.m * ay - v.l2, heading, lean, C * nd + v.R * (v.l1 * c + v.l2 * s)]


def four_bar(v: Any) -> list[float]:
    """Three links in a row by Jourdain's principle: the sum over links of m a . dv/dqd + J alpha, with the closing
    force at the end of the third."""
    angles = np.cumsum([v.a, v.b, v.c])
    rates = np.cumsum([v.ad, v.bd, v.cd])
    seconds = np.cumsum([v.add, v.bdd, v.cdd])
    l, m = [v.l1, v.l2, v.l3], [v.m1, v.m2, v.m3]
    along = [np.array([cos(x), sin(x)]) for x in angles]
    across = [np.array([-sin(x), cos(x)]) for x in angles]
    results = []
    for j in range(3):
        total = 0.0
        for i in range(3):
            weights = [l[k] if k < i else l[k] / 2 if k == i else 0.0 for k in range(3)]
            terms = zip(weights, seconds, rates, across, along, strict=True)
            place = sum(w * (dd * n - d**2 * e) for w, dd, d, n, e in terms)
            moved = sum(w * n for k, (w, n) in enumerate(zip(weights, across, strict=True)) if k >= j)
            total += m[i] * float((place + np.array([0, v.g])) @ moved) if i >= j else 0.0
            total += m[i] * l[i] ** 2 / 12 * seconds[i] if i >= j else 0.0
        end = sum(length * n for k, (length, n) in enumerate(zip(l, across, strict=True)) if k >= j)
        results.append(total - (v.tau if j == 0 else 0.0) + float(np.array([v.L1, v.L2]) @ end))
    return results


_G = {"g": "g_n"}
CASES: list[tuple[str, Callable[[Any], list[float]], dict[str, str]]] = [
    ("models/pendulum.lag", pendulum, {"m": "m", "l": "l", "a": "θ", "dd": "θ̈", "g": "g"}),
    ("models/bead_on_hoop.lag", bead_on_hoop, {"m": "m", "R": "R", "w": "Ω", "a": "θ", "dd": "θ̈", **_G}),
    (
        "models/double_pendulum.lag",
        double_pendulum,
        {"m1": "m₁", "m2": "m₂", "l1": "l₁", "l2": "l₂", "a": "a", "b": "b",
         "ad": "ȧ", "bd": "ḃ", "add": "ä", "bdd": "b̈", **_G},
    ),
    (
        "tests/corpus/derive/wedge.lag",
        wedge,
        {"M": "M", "m": "m", "al": "α", "D": "D", "g": "g", "xd": "ẋ", "xdd": "ẍ", "sdd": "s̈"},
    ),
    (
        "models/gyroscope_in_gimbals.lag",
        gyroscope,
        {
            "Io": "I_outer_ring,3", "Ix": "I_inner_ring,1", "Iy": "I_inner_ring,2", "Iz": "I_inner_ring,3",
            "I1": "I_rotor,1", "I3": "I_rotor,3", "mw": "m_weight", "c": "com_weight,3", "b": "q_inner",
            "ad": "q̇_outer", "bd": "q̇_inner", "sd": "q̇_axle", "add": "q̈_outer", "bdd": "q̈_inner", "sdd": "q̈_axle", **_G,
        },
    ),
    (
        "models/rolling_coin.lag",
        rolling_coin,
        {
            "m": "m", "R": "R", "psi": "ψ", "th": "θ_lean", "psid": "ψ̇", "thd": "θ̇_lean", "spd": "θ̇_spin",
            "xdd": "ẍ", "ydd": "ÿ", "psidd": "ψ̈", "thdd": "θ̈_lean", "spdd": "θ̈_spin", "l1": "λ_rolling,1",
            "l2": "λ_rolling,2", **_G,
        },
    ),
    (
        "models/four_bar.lag",
        four_bar,
        {
            "l1": "l_crank", "l2": "l_coupler", "l3": "l_rocker", "m1": "m_crank", "m2": "m_coupler", "m3": "m_rocker",
            "a": "q_A", "b": "q_B", "c": "q_C", "ad": "q̇_A", "bd": "q̇_B", "cd": "q̇_C", "add": "q̈_A", "bdd": "q̈_B",
            "cdd": "q̈_C", "tau": "τ", "L1": "λ_D,1", "L2": "λ_D,2", **_G,
        },
    ),
]  # fmt: skip


@pytest.mark.parametrize(
    ("path", "book", "names"), spread(chosen(CASES, [case for case in CASES if case[1] is not gyroscope]), 3)
)
def test_printed_equations_are_those_of_the_books(
    path: str, book: Callable[[Any], list[float]], names: dict[str, str]
) -> None:
    sink = Sink()
    file = read(_ROOT / path, sink)
    assert file is not None
    flat = flatten_file(file, sink)
    assert flat is not None
    printed = equations(render(recipe(flat), "text"), "Equations of motion")
    rng = np.random.default_rng(11)
    for _ in range(5):
        values = dict(zip(names, rng.uniform(0.3, 1.7, len(names)).tolist(), strict=True))
        expected = book(SimpleNamespace(**values))
        found = [residual(line, {names[key]: value for key, value in values.items()}) for line in printed]
        np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-12)


SOLVED = [case for case in CASES if Path(case[0]).stem in ("pendulum", "bead_on_hoop", "double_pendulum", "wedge")]


@pytest.mark.parametrize(("path", "book", "names"), SOLVED, ids=[Path(path).stem for path, _, _ in SOLVED])
def test_printed_accelerations_fulfil_the_equations_of_the_books(
    path: str, book: Callable[[Any], list[float]], names: dict[str, str]
) -> None:
    """The right-hand sides, and the factors before the accelerations, hold no acceleration: at zero they leave it."""
    sink = Sink()
    file = read(_ROOT / path, sink)
    assert file is not None
    flat = flatten_file(file, sink)
    assert flat is not None
    printed = equations(render(recipe(flat), "text"), "Solved for the accelerations")
    unknown = [key for key in names if key.endswith("dd")]
    assert len(printed) == len(unknown)
    rng = np.random.default_rng(12)
    for _ in range(5):
        values = dict(zip(names, rng.uniform(0.3, 1.7, len(names)).tolist(), strict=True))
        for key, line in zip(unknown, printed, strict=True):
            at_zero, at_one = (
                residual(line, {names[k]: v for k, v in (values | {key: x}).items()}) for x in (0.0, 1.0)
            )
            values[key] = -at_zero / (at_one - at_zero)
        np.testing.assert_allclose(book(SimpleNamespace(**values)), 0, atol=1e-12)


def test_the_reader_of_printed_lines_sees_a_wrong_sign() -> None:
    values = {"m": 2.0, "θ̈": 3.0, "θ": 0.5, "l₁": 0.7}
    right = "½ m l₁² θ̈ + m (1 − 2 sin² θ) − ⅓ m/4 = 0"
    expected = 0.5 * 2 * 0.49 * 3 + 2 * (1 - 2 * sin(0.5) ** 2) - 2 / 12
    assert abs(residual(right, values) - expected) < 1e-14
    assert abs(residual(right.replace("+", "−"), values) - expected) > 0.1
