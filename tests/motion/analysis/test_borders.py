"""Points between two sides: refused where the sides move differently, and only there. Slopes are read off the text."""

from __future__ import annotations

import numpy as np
import pytest
from choice import spread

import lagdsl
from lagdsl.foundation.diagnostics import CompilationFailed

SLIDER = "coordinate Length x; gravity = 0; mass 1 kg at {x, 0};"
PLANE = "coordinate Length x, y; gravity = {0, -10 m/s2}; mass 1 kg at {x, y};"
ROD = "coordinate Length x, y(start = -1 m); gravity = {0, -10 m/s2}; mass 1 kg at {x, y}; "
BLEND = "table(x, {-1 m, 0 m, 1 m}, {-1 N, 0 N, 3 N}, "


def model(body: str) -> lagdsl.Model:
    return lagdsl.compile(f"model Point\n{body}\nend Point;\n")


# Entry that differs, its two values, and the switch that turns.
BETWEEN = {
    "spring": ("force -(3 N/m)*max(x, 0 m) on x;", "by `x`", [-3, 0], "`max(x, 0 m)`"),
    "energy": ("potential (2 N/m)*min(x, 0 m)^2;", "by `x`", [-4, 0], "`min(x, 0 m)`"),
    "relation": ("force (if x < 0 m then -(8 N/m)*x else -(4 N/m)*x) on x;", "by `x`", [-8, -4], "`x < 0 m`"),
    "friction": ("force -(2 N)*sign(der(x)) on x;", "`der(der(x))` is", [-2, 2], "`der(x) > 0`, `der(x) < 0`"),
    "table": (f'force -{BLEND}"linear") on x;', "by `x`", [-3, -1], "`table("),
    "turns": ("force (2 N)*floor(x/(1 m)) on x;", "`der(der(x))` is", [-2, 0], "`floor(x/(1 m))`"),
    "unlocated": ("force noEvent(if x > 0 m then -(3 N/m)*x else 0) on x;", "by `x`", [-3, 0], "`x > 0 m`"),
    "cut": ("force -(1 N)*atan2(x/(1 m), -1) on x;", "`der(der(x))` is", [-3.14159, 3.14159], "`atan2(x/(1 m), -1)`"),
    "state": ("state Real z; equation der(z) = -abs(z)*(1 Hz);", "`der(z)` by `z`", [-1, 1], "`abs(z)`"),
    "output": ("output Length far = abs(x);", "`far` by `x`", [-1, 1], "`abs(x)`"),
    "input": ("input Force u; force max(u, 0 N) on x;", "by `u`", [0, 1], "`max(u, 0 N)`"),
    "acceleration": (
        "force -(4 N/m)*x on x; output Acceleration a = abs(der(der(x)));",
        "`a` by `x`",
        [-4, 4],
        "`abs(der(der(x)))`",
    ),
}


@pytest.mark.parametrize("name", spread(BETWEEN, 6))
def test_a_point_between_two_sides_is_refused(name: str) -> None:
    text, what, values, names = BETWEEN[name]
    with pytest.raises(CompilationFailed) as failure:
        model(SLIDER + text).linearize()
    (found,) = failure.value.diagnostics
    assert found.code == "E0860"
    before, _, after = found.message.partition(" on the two sides of ")
    assert what in before and after.startswith(names)
    assert [float(value) for value in before.rpartition(" is ")[2].split(" and ")] == values
    assert found.labels[0].span.text in text


@pytest.mark.parametrize(("beside", "slope"), [(1e-9, -3.0), (-1e-9, 0.0)])
def test_beside_it_the_side_is_that_of_the_point(beside: float, slope: float) -> None:
    found = model(SLIDER + BETWEEN["spring"][0]).linearize(q={"x": beside})
    np.testing.assert_array_equal(found.A, [[0, 1], [slope, 0]])


# Forces of x, and their slope at zero.
SMOOTH = {
    "-(3 N/m2)*max(x, 0 m)^2": 0.0,
    "-(3 N/m3)*abs(x)^3": 0.0,
    "-(3 N.s2/m2)*der(x)*abs(der(x))": 0.0,
    "if x > 0 m then -(3 N/m)*x else -(3 N/m)*x + (5 N/m2)*x^2": -3.0,
    "-(3 N/m)*max(x, 0 m) - (3 N/m)*min(x, 0 m)": -3.0,
    "-(3 N/m)*max(x, 0 m) + (1.5 N/m)*abs(x)": -1.5,
    "if time > 0 s then -(3 N/m)*x else -(1 N/m)*x": -3.0,
    f'-{BLEND}"cubic")': -2.0,
}


@pytest.mark.parametrize("force", spread(SMOOTH, 4))
def test_sides_that_agree_are_one(force: str) -> None:
    found = model(f"{SLIDER} force {force} on x;").linearize()
    np.testing.assert_allclose(found.A, [[0, 1], [SMOOTH[force], 0]], atol=1e-8)


def test_modes_need_no_outputs_and_no_inputs() -> None:
    text = "input Force u; force -(4 N/m)*x + max(u, 0 N) on x; output Length far = abs(x);"
    np.testing.assert_allclose(model(SLIDER + text).modes().frequencies, 2.0 / (2.0 * np.pi))


def test_an_equilibrium_between_two_springs_is_found_and_has_no_modes() -> None:
    """Newton's method comes near the corner, and not onto it."""
    springs = model(SLIDER + "force if x > 0.1 m then -(3 N/m)*(x - 0.1 m) else -(5 N/m)*(x - 0.1 m) on x;")
    assert springs.trim(q={"x": 7.3}).point.q == pytest.approx([0.1], abs=1e-11)
    with pytest.raises(CompilationFailed, match="is -5 and -3 on the two sides"):
        springs.modes(q={"x": 7.3}, trim=True)


def test_values_between_two_sides_have_no_eigenvalues() -> None:
    found = model(SLIDER + "parameter Length far = 0 m; force -(4 N/m)*max(x - far, 0 m) on x;").vary(
        "far", [-1.0, 0.0, 1.0]
    )
    np.testing.assert_allclose(found.eigenvalues.imag[0], [2.0, -2.0])
    assert np.all(np.isnan(found.eigenvalues[1])) and np.all(found.eigenvalues[2] == 0.0)


def test_a_taut_rope_holds_its_own_relation_at_zero() -> None:
    text = "constraint rope: (if norm({x, y}) >= 1 m then norm({x, y}) - 1 m else 0 m) = 0;"
    np.testing.assert_allclose(model(ROD + text).linearize().A, [[0, 1], [-10, 0]], atol=1e-12)


def test_a_corner_across_the_constraints_does_not_matter() -> None:
    """y + 1 m is of second order along the circle."""
    rod = ROD + "constraint rod: x^2 + y^2 = 1 m2;"
    along, across = (f"force -(3 N/m)*max({name}, 0 m) on x;" for name in ("x", "y + 1 m"))
    np.testing.assert_allclose(model(rod + across).linearize().A, [[0, 1], [-10, 0]], atol=1e-8)
    with pytest.raises(CompilationFailed, match="is -13 and -10 on"):
        model(rod + along).linearize()


@pytest.mark.parametrize("track", ["constraint track: y = abs(x);", ""])
def test_the_corner_of_a_track(track: str) -> None:
    """On each side a slope of 45 deg, g/2 along x."""
    body = PLANE + track if track else "coordinate Length x; gravity = {0, -10 m/s2}; mass 1 kg at {x, abs(x)};"
    with pytest.raises(CompilationFailed, match=r"is -5 and 5 on the two sides of `abs\(x\)`"):
        model(body).linearize()


def test_a_contact_that_touches_without_a_force() -> None:
    """It has the spring on one side only; one that is pressed together is a constraint."""
    stop = SLIDER + "contact stop: x >= 0 m with restitution = 0; potential 1/2*(4 N/m)*"
    with pytest.raises(CompilationFailed, match="number of states is 0 and 2 on the two sides of contact `stop`"):
        model(stop + "x^2;").modes()
    assert len(model(stop + "(x + 1 m)^2;").modes().eigenvalues) == 0
