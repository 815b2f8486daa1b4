"""Accelerations, equilibria and natural frequencies in symbols against closed forms of textbooks and against the modes
that the other derivation computes in numbers."""

from __future__ import annotations

from collections.abc import Callable
from math import acos, pi, sqrt
from pathlib import Path

import numpy as np
import pytest
import sympy
from choice import chosen, spread
from sympy import Expr, Float, Symbol

import lagdsl
from lagdsl.derivation.textbook.recipe import recipe
from lagdsl.derivation.textbook.small_motions.study import Study, study
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import flatten_file, read

_ROOT = Path(__file__).parents[3]
_MODELS = sorted(
    str(path.relative_to(_ROOT / "models").with_suffix(""))
    for folder in ("", "library")
    for path in (_ROOT / "models" / folder).glob("*.lag")
)
_SOME = ["coupled_oscillators", "elastic_pendulum", "three_masses"]
_CONSTRAINED = ["bead_on_circular_wire_redundant", "pendulum_two_dependent_constraints"]
EQUAL_PENDULA = """
model EqualPendula
  parameter Mass m = 2 kg;
  parameter Length l = 0.7 m;
  coordinate Angle a, b;
  point P = {l*sin(a), -l*cos(a)};
  gravity = {0, -9.81 m/s2};
  mass m at P;
  mass m at P + {l*sin(b), -l*cos(b)};
end EqualPendula;
"""


def studied(source: str | Path) -> Study:
    sink = Sink()
    file = read(source, sink) if isinstance(source, Path) else SourceFile("<text>", source)
    assert file is not None
    flat = flatten_file(file, sink)
    assert flat is not None, sink.diagnostics
    found = recipe(flat)
    assert found.derivation is not None
    return study(found.flat, found.derivation)


def number(expression: Expr, values: dict[str, float]) -> float:
    return float(expression.xreplace({Symbol(name): Float(value, 17) for name, value in values.items()}))


Closed = Callable[[dict[str, float]], list[tuple[list[float], list[float]]]]


def pendulum(v: dict[str, float]) -> list[tuple[list[float], list[float]]]:
    return [([0], [v["g"] / v["l"]]), ([pi], [-v["g"] / v["l"]])]


def bead(v: dict[str, float]) -> list[tuple[list[float], list[float]]]:
    """Taylor, Classical Mechanics (2005), the bead on a spinning hoop: cos θ = g/(R Ω²) beyond the critical speed."""
    slow, square = v["g_n"] / v["R"], v["Omega"] ** 2
    tilted = acos(slow / square)
    return [
        ([0], [slow - square]),
        ([pi], [-slow - square]),
        ([tilted], [square - slow**2 / square]),
        ([-tilted], [square - slow**2 / square]),
    ]


def pendula(v: dict[str, float]) -> list[tuple[list[float], list[float]]]:
    """Equal double pendulum: ω² = (2 ± √2) g/l hanging; with one rod up the product of both is negative."""
    unit = v["g"] / v["l"]
    hanging = [(2 - sqrt(2)) * unit, (2 + sqrt(2)) * unit]
    mixed = [-sqrt(2) * unit, sqrt(2) * unit]
    return [([0, 0], hanging), ([0, pi], mixed), ([pi, 0], mixed), ([pi, pi], [-x for x in reversed(hanging)])]


def coupled(v: dict[str, float]) -> list[tuple[list[float], list[float]]]:
    return [([0, 0], [v["k"] / v["m"], (v["k"] + 2 * v["kc"]) / v["m"]])]


def three(v: dict[str, float]) -> list[tuple[list[float], list[float]]]:
    """A loaded string of three masses: ω² = 4 k/m sin²(n π/8)."""
    return [([0, 0, 0], [4 * v["k"] / v["m"] * np.sin(n * pi / 8) ** 2 for n in (1, 2, 3)])]


def elastic(v: dict[str, float]) -> list[tuple[list[float], list[float]]]:
    sag = v["m"] * v["g_n"] / v["k"]
    down, up = v["l0"] + sag, v["l0"] - sag
    spring = v["k"] / v["m"]
    return [
        ([down, 0], sorted([spring, v["g_n"] / down])),
        ([up, pi], sorted([spring, -v["g_n"] / up])),
    ]


CASES: list[tuple[str | Path, Closed, dict[str, tuple[float, float]]]] = [
    (_ROOT / "models/pendulum.lag", pendulum, {"m": (1, 2), "l": (1, 2), "g": (1, 10)}),
    (_ROOT / "models/bead_on_hoop.lag", bead, {"m": (1, 2), "R": (1, 2), "g_n": (1, 9), "Omega": (4, 8)}),
    (EQUAL_PENDULA, pendula, {"m": (1, 2), "l": (1, 2), "g": (1, 10)}),
    (_ROOT / "models/coupled_oscillators.lag", coupled, {"m": (1, 2), "k": (1, 9), "kc": (1, 9)}),
    (_ROOT / "models/three_masses.lag", three, {"m": (1, 2), "k": (1, 9)}),
    (_ROOT / "models/elastic_pendulum.lag", elastic, {"m": (1, 2), "k": (60, 90), "l0": (1, 2), "g_n": (1, 9)}),
]


@pytest.mark.parametrize(("source", "closed", "ranges"), CASES, ids=[case[1].__name__ for case in CASES])
def test_closed_forms(source: str | Path, closed: Closed, ranges: dict[str, tuple[float, float]]) -> None:
    found = studied(source)
    assert found.reason is None
    rng = np.random.default_rng(5)
    for _ in range(3):
        values = {name: float(rng.uniform(low, high)) for name, (low, high) in ranges.items()}
        expected = closed(values)
        assert len(found.equilibria) == len(expected)
        for each, (at, squares) in zip(found.equilibria, expected, strict=True):
            assert each.linear is not None and not each.linear.coupled
            np.testing.assert_allclose([number(value, values) for _, value in each.at], at, rtol=1e-12, atol=1e-14)
            own = sorted(number(frequency.square, values) for frequency in each.linear.frequencies)
            np.testing.assert_allclose(own, squares, rtol=1e-11)


def test_a_root_that_is_not_real_here_says_so() -> None:
    """Below the critical speed the bead has the two equilibria on the axis only; the others keep their condition."""
    slow = (_ROOT / "models/bead_on_hoop.lag").read_text().replace("Omega = 8 rad/s", "Omega = 2 rad/s")
    found = studied(slow)
    assert [each.exists for each in found.equilibria] == [True, True, False, False]
    [condition] = found.equilibria[2].conditions
    assert condition.kind == "unit"
    assert str(condition.value) == "g_n/(Omega**2*R)"


REASONS = [
    (
        "coordinate Length x; mass 1 kg at {x, 0}; gravity = -g_n*world.y; force cos(time/(1 s))*(1 N) on x;",
        "Time occurs",
    ),
    ("coordinate Length x; mass 1 kg at {x, 0}; gravity = -g_n*world.y; force -sign(der(x))*(1 N) on x;", "corners"),
    ("coordinate Length x, y; mass 1 kg at {x, y}; gravity = -g_n*world.y; constraint c: der(y) = 0;", "of rates"),
    ("coordinate Angle x; kinetic (1 kg.m2)*der(x)^2; potential (1 J)*(x*sin(x) + cos(2*x + 1));", "short roots"),
]


@pytest.mark.parametrize(("body", "words"), REASONS, ids=[words for _, words in REASONS])
def test_what_is_not_looked_for_has_a_reason(body: str, words: str) -> None:
    found = studied(f"model X {body} end X;")
    assert found.reason is not None
    assert words in found.reason
    assert not found.equilibria


def test_a_bead_on_a_circle_rests_in_the_direction_of_its_loads() -> None:
    """On x² + y² = R² under (F, -m g): at ±R (F, -m g)/√(F² + m² g²)."""
    found = studied(_ROOT / "models/bead_on_circular_wire_redundant.lag")
    v = {"m": 0.3, "R": 0.7, "F": -2.0, "g_n": 9.81}
    size = sqrt(v["F"] ** 2 + (v["m"] * v["g_n"]) ** 2)
    along = np.array([v["F"], -v["m"] * v["g_n"]]) / size
    places = [[number(value, v) for _, value in each.at] for each in found.equilibria]
    # the wire's force λ ∂(x² + y² - R²)/∂r balances the loads: 2 λ r = -(F, -m g)
    expected = [[*(sign * v["R"] * along), -sign * size / (2 * v["R"])] for sign in (1, -1)]
    np.testing.assert_allclose(sorted(places), sorted(expected), rtol=1e-12)
    assert not any(each.conditions for each in found.equilibria)


def test_a_ladder_between_wall_and_ground_rests_upright_only() -> None:
    """Its ends slide on wall and ground: x = l/2 cos θ, y = l/2 sin θ. It stands up or hangs down, its weight on the
    ground and no force at the wall."""
    found = studied(_ROOT / "models/sliding_ladder.lag")
    v = {"m": 3.0, "l": 2.0, "g_n": 9.81}
    places = sorted([number(value, v) for _, value in each.at] for each in found.equilibria)
    weight = v["m"] * v["g_n"]
    np.testing.assert_allclose(places, [[0, -1, -pi / 2, 0, weight], [0, 1, pi / 2, 0, weight]], atol=1e-12)


@pytest.mark.parametrize("name", chosen(_MODELS, _CONSTRAINED))
def test_at_equilibria_under_constraints_nothing_accelerates(name: str) -> None:
    """In the other derivation: the constraints hold and f + J' λ = 0, whatever value a free multiplier has."""
    model, compared = lagdsl.compile(_ROOT / "models" / f"{name}.lag"), 0
    derivation = model.derive()
    if not any(each.level == "position" and not each.contact for each in model._compilation.flat.constraints):
        return
    names = [item.name for item in model._compilation.flat.coordinates]
    rows = [f"multiplier({row})" for each in model._compilation.flat.constraints for row in each.rows]
    for each in derivation.equilibria:
        if not each.exists:
            continue
        free = {symbol: Float(0.3, 17) for symbol in each.arbitrary}
        values = {symbol.name: model_number(model, value.xreplace(free)) for symbol, value in each.at}
        values |= {symbol.name: 0.3 for symbol in each.arbitrary}
        engine, p = model._engine, np.array(model._engine.layout.defaults, dtype=np.float64)
        _, _, z, u = engine.evaluate("start", 0.0, p)[:4]
        q, lam = np.array([values[x] for x in names]), np.array([values.get(x, 0.0) for x in rows])
        w = np.zeros(len(engine.layout.discretes))
        _, force, jacobian, _ = engine.evaluate("dynamics", 0.0, q, 0 * q, z, u, w, p)
        upheld = np.reshape(jacobian, (len(lam), len(q))).T @ lam
        np.testing.assert_allclose(force + upheld, 0.0, atol=1e-9 * (1 + np.abs(force).max()))
        residual = engine.evaluate("position_constraint", 0.0, q, 0 * q, z, u, w, p)[0]
        np.testing.assert_allclose(residual, 0.0, atol=1e-9)
        compared += 1
    assert compared or name not in _CONSTRAINED


OSCILLATOR = """
model Oscillator
  parameter Mass m = 2 kg;
  parameter Stiffness k = 50 N/m;
  parameter Damping c = 3 N.s/m;
  coordinate Length x(start = 0.1 m);
  kinetic 1/2*m*der(x)^2;
  potential 1/2*k*x^2;
  dissipation 1/2*c*der(x)^2;
end Oscillator;
"""
GOVERNOR = """
model Governor
  parameter Mass m = 1 kg, M = 2 kg;
  parameter Length l = 0.3 m;
  coordinate Angle phi, theta(start = 30 deg);
  gravity = {0, 0, -9.81 m/s2};
  mass m at {l*sin(theta)*cos(phi), l*sin(theta)*sin(phi), -l*cos(theta)};
  mass m at {-l*sin(theta)*cos(phi), -l*sin(theta)*sin(phi), -l*cos(theta)};
  mass M at {0, 0, -2*l*cos(theta)};
end Governor;
"""


def test_damping_ratio_and_damped_frequency_are_those_of_the_eigenvalues() -> None:
    """s = -ζ ω ± i ω √(1 - ζ²); Meirovitch (2001), 2.2. Beyond ζ = 1 the square of the damped frequency is negative."""
    chance = np.random.default_rng(11)
    [place] = studied(OSCILLATOR).equilibria
    assert place.linear is not None
    [frequency] = place.linear.frequencies
    damped = frequency.damped
    assert damped is not None and str(damped.ratio) == "c/(2*sqrt(k*m))"
    model = lagdsl.compile(OSCILLATOR)
    for drag in (1.0, 5.0, 90.0):
        values = {"m": chance.uniform(1, 3), "k": chance.uniform(20, 80), "c": drag * chance.uniform(1, 2)}
        first, second = np.roots([values["m"], values["c"], values["k"]])
        ratio, square = number(damped.ratio, values), number(damped.square, values)
        assert ratio == pytest.approx(float((-first - second).real / 2 / sqrt(values["k"] / values["m"])))
        assert square == pytest.approx(float(-(((first - second) / 2) ** 2).real))
        eigenvalues = model.modes(p=values).eigenvalues
        assert sorted(eigenvalues, key=lambda s: (s.real, s.imag)) == pytest.approx(
            sorted((first, second), key=lambda s: (s.real, s.imag))
        )


@pytest.mark.parametrize(
    ("source", "closed"),
    spread(
        [
            (_ROOT / "models/spherical_pendulum.lag", lambda v, w: v["g_n"] / (v["l"] * w["phi"] ** 2)),
            (GOVERNOR, lambda v, w: (v["m"] + v["M"]) * v["g"] / (v["m"] * v["l"] * w["phi"] ** 2)),
            (
                _ROOT / "models/heavy_top.lag",
                lambda v, w: (
                    (v["m"] * v["g_n"] * v["l"] - v["C"] * w["psi"] * w["phi"])
                    / ((v["C"] - v["A"] - v["m"] * v["l"] ** 2) * w["psi"] ** 2)
                ),
            ),
        ],
        2,
    ),
)
def test_steady_motions(source: str | Path, closed: Callable[..., float]) -> None:
    """The conical pendulum, Watt's governor, the regular precession of a top: cosines of textbooks (Goldstein 5.7 for
    the top). At these values nothing but the ignorable coordinates moves: no acceleration in the other derivation."""
    found = studied(source).steady
    assert found is not None
    tilted = next(place for place in found.places if place.conditions)
    [(theta, value)] = tilted.at.items()
    model, chance = lagdsl.compile(source), np.random.default_rng(3)
    assert model.derive().steady == found
    defaults = {
        item.name: item.value for item in model.derive()._recipe.flat.parameters if item.name in model.parameters
    }
    tried = 0
    while tried < 5:
        p = {name: size * chance.uniform(0.8, 1.25) for name, size in defaults.items()}
        rates = {rate.name.removeprefix("der(").removesuffix(")"): chance.uniform(8.0, 20.0) for rate in found.rates}
        known = {**p, "g_n": 9.80665, "g": 9.81, **{f"der({name})": rate for name, rate in rates.items()}}
        cosine = closed(known, rates)
        if not abs(cosine) < 0.95:
            continue
        tried += 1
        angle = number(value, known)
        assert np.cos(angle) == pytest.approx(cosine, rel=1e-12)
        q = [angle if name == theta.name else 0.3 for name in model.coordinates]
        qd = [rates.get(name, 0.0) for name in model.coordinates]
        accelerations = np.asarray(model.forward_dynamics(0.0, q, qd, p=p))
        assert np.all(np.abs(accelerations) < 1e-9 * max(rates.values()) ** 2)


def test_nothing_is_steady_where_a_rate_is_damped() -> None:
    assert studied(GOVERNOR.replace("end Gov", "  dissipation 0.1 N.m.s*der(phi)^2;\nend Gov")).steady is None


def test_a_steady_motion_without_an_angle() -> None:
    """A particle circles in a cone at r = g/(tan(a) w^2)."""
    found = studied(
        """model Cone
          parameter Angle a = 30 deg;
          coordinate Length r(start = 1 m);
          coordinate Angle turn(der(start = 2 rad/s));
          gravity = -g_n*world.z;
          mass 1 kg at {r*cos(turn), r*sin(turn), r/tan(a)};
        end Cone;"""
    )
    assert found.steady is not None and not any(each.exists for each in found.equilibria) and not found.singular
    [place] = found.steady.places
    [(r, value)] = place.at.items()
    known = {"a": 0.6, "g_n": 9.80665, "der(turn)": 3.0}
    assert r.name == "r" and number(value, known) == pytest.approx(9.80665 / np.tan(0.6) / 9.0)


def test_rest_at_a_singular_place_of_the_coordinates_is_told() -> None:
    """A spherical pendulum hangs still, or stands, where its azimuth determines nothing."""
    source = _ROOT / "models/spherical_pendulum.lag"
    found = studied(source)
    assert not found.equilibria
    angles = [{q.name: value for q, value in place.at}["theta"] for place in found.singular]
    assert angles == [0, sympy.pi]
    assert "stays nowhere at rest" not in (text := str(lagdsl.compile(source).derive()))
    assert "They hold only where the matrix of the accelerations is singular" in text


def test_a_coordinate_without_mass_may_be_held() -> None:
    """Accelerations are determined though the mass matrix is singular: the block rests where its spring is at ease."""
    springs = "potential (1 N/m)*(x - y)^2; constraint held: y = 1 m;"
    found = studied(f"model X coordinate Length x, y; kinetic (1 kg)*der(x)^2; {springs} end X;")
    [place] = found.equilibria
    assert {q.name: float(value) for q, value in place.at if q.name in "xy"} == {"x": 1.0, "y": 1.0}
    assert not found.singular


def test_nowhere_at_rest() -> None:
    found = studied("model X coordinate Length y; mass 1 kg at {0, y}; gravity = -g_n*world.y; end X;")
    assert found.reason is None
    assert not found.equilibria
    assert [str(value) for value in found.statics] == ["g_n*m_1"]


def test_an_equation_of_high_degree_is_left_to_numbers() -> None:
    body = "coordinate Length x; kinetic (1 kg)*der(x)^2; potential (1 J/m6)*x^6 + (1 J/m5)*x^5 + (1 N)*x;"
    assert studied(f"model X {body} end X;").reason is not None


@pytest.mark.parametrize("name", chosen(_MODELS, _SOME))
def test_squares_are_those_of_the_modes(name: str) -> None:
    """Eigenvalues s of the other derivation are ±√(-ω²) for every equilibrium whose motions are neither damped nor
    left to numbers."""
    model, compared = lagdsl.compile(_ROOT / "models" / f"{name}.lag"), 0
    for each in model.derive().equilibria:
        linear = each.linear
        if linear is None or not each.exists or each.arbitrary or linear.coupled or linear.damped:
            continue
        if any(entry != 0 for row in linear.damping for entry in row):
            continue
        values = {symbol.name: model_number(model, value) for symbol, value in each.at}
        try:
            modes = model.modes(q=values, qd=dict.fromkeys(values, 0.0))
        except lagdsl.CompilationFailed as failure:  # a contact without force, whose modes are those of one side
            assert failure.diagnostics[0].code == "E0860"
            continue
        squares = sorted((-(modes.eigenvalues**2)).real.tolist())
        own = sorted(2 * [frequency.number for frequency in linear.frequencies])
        np.testing.assert_allclose(squares, own, rtol=1e-7, atol=1e-7 * max(map(abs, own)))
        compared += 1
    assert compared or name not in _SOME


def model_number(model: lagdsl.Model, value: Expr) -> float:
    parameters = model.derive()._recipe.flat.parameters
    values = {item.name: item.value for item in parameters} | {"g_n": 9.80665}
    return number(value, values)
