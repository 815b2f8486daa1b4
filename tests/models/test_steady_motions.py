"""Steady motions of the models that have one, against their closed forms."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.optimize import brentq

import lagdsl
from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine
from lagdsl.foundation.diagnostics import Sink
from lagdsl.motion.analysis.modes import modes_at
from lagdsl.motion.analysis.point import System, point_of
from models.corpus import compiled, path_of
from models.references.components_with_friction import _stribeck
from models.references.integrate import G_N


@cache
def _model(name: str) -> lagdsl.Model:
    return lagdsl.compile(path_of(name), engine="tape")


def _parameters(name: str) -> dict[str, float]:
    model = _model(name)
    return dict(zip(model.parameters, model.defaults, strict=True))


def _eigenvalues(name: str, start: dict[str, float], **parameters: float) -> np.ndarray:
    """About the steady motion that `start` is part of; `der(x)` are rates."""
    flat, program = compiled(name).flat, compiled(name).graph
    system = System(flat, program, NumpyEngine(program))
    p = np.array(
        [
            parameters.get(slot.name.replace(".", "_"), value)
            for slot, value in zip(program.layout.parameters, program.layout.defaults, strict=True)
        ]
    )
    sink = Sink()
    found = modes_at(system, point_of(system, start=start, p=p, given=True, sink=sink), sink)
    assert found is not None and found.steadiness.kind == "steady motion", sink.diagnostics
    return np.asarray(found.eigenvalues)


@pytest.mark.parametrize("which", [0, 1])
def test_the_gyroscope_precesses_steadily_at_both_rates(which: int) -> None:
    """(B - C1) cos(theta) W^2 - C n W + m g l = 0: the slow and the fast precession (Magnus, Kreisel, 5)."""
    p = _parameters("gyroscope_in_gimbals")
    angle, spin, arm = np.radians(60), 200.0, p["weight.com[3]"]
    across = p["inner_ring.I[2]"] + p["rotor.I[1]"] + p["weight.m"] * arm**2
    weight = p["weight.m"] * G_N * arm
    roots = np.sort(np.roots([(across - p["inner_ring.I[3]"]) * np.cos(angle), -p["rotor.I[3]"] * spin, weight]))
    rate = float(roots[which])
    start = {
        "outer.q": 0.0,
        "inner.q": angle,
        "der(inner.q)": 0.0,
        "der(outer.q)": rate,
        "der(axle.q)": spin - rate * np.cos(angle),
    }
    motion = _model("gyroscope_in_gimbals").simulate(stop=20 / rate, start=start, tolerance=1e-11)
    np.testing.assert_allclose(motion["inner.q"], angle, rtol=1e-8)
    np.testing.assert_allclose(motion["outer.q"], rate * motion.time, atol=1e-7)


def test_the_lubricated_shaft_reaches_the_speed_where_friction_balances_the_drive() -> None:
    p = _parameters("library/stribeck_bearing")
    law = [p[f"bearing.{name}"] for name in ("tau_b", "tau_c", "w_s", "c")]
    expected = brentq(lambda w: 3 - _stribeck(w, *law), 20, 60, xtol=1e-13)
    motion = _model("library/stribeck_bearing").simulate(stop=40, tolerance=1e-11)
    assert motion["der(shaft.phi)"][-1] == pytest.approx(expected, rel=1e-9)


def test_the_skateboard_rights_itself_above_its_critical_speed() -> None:
    """(Ix + m h^2) s^2 + m h u (tan f - tan r)/2 s + k - m g h + m h u^2 (tan f + tan r)/(2 a) = 0 for the lean."""
    p = _parameters("skateboard")
    m, h, k, a, front, rear = p["m"], p["h"], p["k"], p["a"], np.tan(p["front"]), np.tan(p["rear"])
    critical = np.sqrt((m * G_N * h - k) * 2 * a / (m * h * (front + rear)))
    rest = {f"{word}": 0.0 for word in ("x", "y", "heading", "lean", "der(y)", "der(heading)", "der(lean)")}
    for speed, stable in ((1.02 * critical, True), (0.98 * critical, False), (3.0, True)):
        stiffness = k - m * G_N * h + m * h * speed**2 * (front + rear) / (2 * a)
        expected = np.roots([p["I[1]"] + m * h**2, m * h * speed * (front - rear) / 2, stiffness])
        assert (max(expected.real) < 0) == stable
        found = _eigenvalues("skateboard", rest | {"der(x)": float(speed)})
        for root in expected:
            assert np.min(np.abs(found - root)) < 1e-8


@pytest.mark.parametrize(("damping", "stable"), [(0.5, False), (2.0, True), (40.0, True)])
def test_the_governor_hunts_without_enough_damping(damping: float, stable: bool) -> None:
    """A a'' + C a' + B a = D w, J w' = -K a - D a' about the steady motion: the cubic of Vyshnegradskii (Pontryagin,
    Ordinary Differential Equations, 27), here with the inertia of sleeve and balls."""
    p = _parameters("watt_governor")
    l, m, collar, steam = p["l"], p["ball1.m"], p["collar.m"], p["steam"]
    co = p["load"] / steam
    s, angle = np.sqrt(1 - co**2), float(np.arccos(co))
    turn = float(np.sqrt((m + collar) * G_N / (m * l * co)))
    drift = 4 * m * l**2 * s * co * turn
    a = np.array(
        [[0, 1, 0], [-2 * m * (l * s * turn) ** 2, -4 * damping * (l * s) ** 2, drift], [-steam * s, -drift, 0]]
    )
    a[1] /= 2 * m * l**2 + 4 * collar * l**2 * s**2
    a[2] /= p["flywheel.J"] + 2 * m * l**2 * s**2
    expected = np.linalg.eigvals(a)
    assert (max(expected.real) < 0) == stable
    start = {"spindle.q": 0.0, "arm1.q": angle, "arm2.q": -angle, "elbow1.q": -2 * angle, "elbow2.q": 2 * angle}
    start |= {f"der({name})": 0.0 for name in start} | {"sleeve.s": -2 * l * co, "der(sleeve.s)": 0.0}
    known = {text for c in _model("watt_governor").coordinates for text in (c, f"der({c})")}
    start = {name: value for name, value in start.items() if name in known} | {"der(spindle.q)": turn}
    found = _eigenvalues("watt_governor", start, dashpot_c=damping)
    for root in expected:
        assert np.min(np.abs(found - root)) < 1e-8 * np.max(np.abs(expected))
