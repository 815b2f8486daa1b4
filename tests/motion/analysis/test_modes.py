"""Eigenvalues and thresholds against closed forms."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from choice import spread

import lagdsl
from lagdsl.foundation.diagnostics import Sink

MODELS = Path(__file__).parents[3] / "models"
G_N = 9.80665


def compiled(name: str) -> lagdsl.Model:
    return lagdsl.compile(MODELS / f"{name}.lag")


def test_three_masses_between_walls() -> None:
    modes = compiled("three_masses").modes(trim=True)
    expected = 2 * np.sqrt(30 / 0.4) * np.sin(np.arange(1, 4) * np.pi / 8)
    np.testing.assert_allclose(modes.eigenvalues[::2], 1j * expected, rtol=1e-13, atol=1e-12)
    np.testing.assert_allclose(modes.frequencies[::2], expected / (2 * np.pi), rtol=1e-13)
    root = np.sqrt(0.5)
    np.testing.assert_allclose(modes.shapes[::2], [[root, 1, root], [1, 0, -1], [-root, 1, -root]], atol=1e-12)
    np.testing.assert_allclose(modes.damping, 0, atol=1e-13)
    assert np.all(np.isinf(modes.time_constants))
    assert modes.steadiness.kind == "equilibrium"
    assert "6 on the imaginary axis" in modes.stability


def test_double_pendulum() -> None:
    """(m1 + m2) l1 l2 w^4 - (m1 + m2)(l1 + l2) g w^2 + ... (Landau, Lifshitz, Mechanics, section 23, problem 2)."""
    m1, m2, l1, l2 = 1.0, 0.5, 0.5, 0.3
    modes = compiled("double_pendulum").modes(trim=True)
    np.testing.assert_allclose(modes.point.q, 0, atol=1e-15)
    sum_ = (m1 + m2) * (l1 + l2)
    root = np.sqrt(sum_**2 - 4 * (m1 + m2) * m1 * l1 * l2)
    expected = np.sqrt(G_N / (2 * m1 * l1 * l2) * (sum_ + np.array([-1, 1]) * root))
    np.testing.assert_allclose(modes.eigenvalues[::2].imag, expected, rtol=1e-12)


def test_sleeping_top() -> None:
    """Awake below C^2 n^2 = 4 A m g l."""
    model, (a, c, m, l) = compiled("sleeping_top"), (2.05e-3, 1e-3, 0.5, 0.05)
    modes = model.modes(q=[0, 0, 0])
    assert modes.steadiness.kind == "steady motion"
    assert modes.steadiness.running == ("phi",)
    root = np.sqrt((c * 60) ** 2 - 4 * a * m * G_N * l)
    # in turning coordinates (C n +- root)/(2 A); in space as they are, in angles that do not turn
    np.testing.assert_allclose(np.sort(modes.eigenvalues.imag)[-2:], np.sort([c * 60 - root, c * 60 + root]) / (2 * a))
    assert int(np.count_nonzero(modes.eigenvalues == 0)) == 2  # phi and its momentum keep their zeros
    variation = model.vary("n", np.linspace(5, 80, 12), q=[0, 0, 0])
    (threshold,) = variation.thresholds
    assert threshold.value == pytest.approx(np.sqrt(4 * a * m * G_N * l) / c, rel=1e-10)
    assert (threshold.kind, threshold.unstable_above) == ("flutter", False)
    assert threshold.frequency == pytest.approx(c * threshold.value / (2 * a) / (2 * np.pi), rel=1e-3)


def test_flutter_of_a_column_under_a_follower_force() -> None:
    (threshold,) = compiled("ziegler_column").vary("P", np.linspace(0, 3, 16), q=[0, 0]).thresholds
    assert threshold.value == pytest.approx(3.5 - np.sqrt(2), rel=1e-10)
    assert (threshold.kind, threshold.unstable_above) == ("flutter", True)


def test_a_column_under_a_dead_load_buckles() -> None:
    """The same column with a vertical load: P l/c = (3 - sqrt(5))/2, by divergence."""
    text = (MODELS / "ziegler_column.lag").read_text().replace("force -P*upper.y", "force -P*world.y")
    (threshold,) = lagdsl.compile(text).vary("P", np.linspace(0, 2, 6), q=[0, 0]).thresholds
    assert threshold.value == pytest.approx((3 - np.sqrt(5)) / 2, rel=1e-10)
    assert (threshold.kind, threshold.eigenvalue) == ("divergence", 0)


@pytest.mark.parametrize("k", spread([0.5, 1.0], 1))
def test_a_wheel_stays_upright_above_a_speed(k: float) -> None:
    """omega^2 > g A / (C (C + m R^2)/(m R)) with A = k m R^2/2, C = k m R^2: g/(3 R) for a disc, g/(4 R) for a hoop."""
    model, radius = compiled("rolling_hoop"), 0.3
    modes = model.modes(q={"lean": 0.0}, p={"k": k})
    assert modes.steadiness.kind == "steady motion"
    assert modes.steadiness.running == ("x", "spin")
    assert modes.dropped == 0
    assert int(np.count_nonzero(modes.eigenvalues == 0)) == 6
    # lean: (A + m R^2) s^2 + C (C + m R^2)/A w^2 - m g R = 0
    inertia, c = k / 2, k
    lean = np.sqrt((c * (c + 1) / inertia * 25 - G_N / radius) / (inertia + 1))
    assert modes.eigenvalues[0] == pytest.approx(1j * lean, rel=1e-12)
    (threshold,) = model.vary("w", np.linspace(0.5, 8, 9), q={"lean": 0.0}, p={"k": k}).thresholds
    assert threshold.value == pytest.approx(np.sqrt(G_N / radius / (2 * (k + 1))), rel=1e-10)
    assert not threshold.unstable_above


def test_bicycle_of_the_benchmark() -> None:
    """Table 2 and section 6 of Meijaard, Papadopoulos, Ruina and Schwab (2007)."""
    model = compiled("bicycle")
    modes = model.modes(q={"phi": 0.0})
    weave = -0.77534188219585 + 4.46486771378823j
    expected = [-0.32286642900409, weave, weave.conjugate(), -14.07838969279822]
    np.testing.assert_allclose(modes.eigenvalues[:4], expected, rtol=1e-11)
    assert np.all(modes.eigenvalues[4:] == 0)
    assert modes.stability.startswith("stable steady motion but for drift")
    at_rest = model.modes(q={"phi": 0.0}, p={"v": 0.0})
    rates = [3.13164324790656, 5.53094371765393]
    np.testing.assert_allclose(np.sort(at_rest.eigenvalues.real), np.sort([*rates, *np.negative(rates), *[0] * 6]))
    flutter, divergence = model.vary("v", np.linspace(1, 9, 9), q={"phi": 0.0}).thresholds
    assert flutter.value == pytest.approx(4.29238253634111, rel=1e-11)
    assert divergence.value == pytest.approx(6.02426201538837, rel=1e-11)
    assert (flutter.kind, divergence.kind) == ("flutter", "divergence")
    assert (flutter.unstable_above, divergence.unstable_above) == (False, True)


def test_a_chain_with_redundant_constraints() -> None:
    """Every rod stated twice: the modes are those of the chain in angles."""
    text = """model Rods
      structural parameter Integer N = 4;
      coordinate Length x[N](start = {0.1*i*(1 m) for i in 1:N}), y[N](start = {-0.9*i*(1 m) for i in 1:N});
      gravity = -g_n*world.y;
      for i in 1:N loop
        mass 1 kg at {x[i], y[i]};
        constraint (x[i] - (if i == 1 then 0 else x[i-1]))^2 + (y[i] - (if i == 1 then 0 else y[i-1]))^2 = (1 m)^2;
        constraint norm({x[i] - (if i == 1 then 0 else x[i-1]), y[i] - (if i == 1 then 0 else y[i-1])}) = 1 m;
      end for;
    end Rods;
    """
    text = text.replace("start = {0.1*i*(1 m) for i in 1:N}", "each start = 0").replace(
        "start = {-0.9*i*(1 m) for i in 1:N}", "start = {-1 m, -2 m, -3 m, -4 m}"
    )
    rods = lagdsl.compile(text).modes()
    links = compiled("chain")
    p = {"l": 1.0, "m": 1.0}
    angles = lagdsl.compile(
        (MODELS / "chain.lag").read_text().replace("1e-4 N.m.s/rad", "0 N.m.s/rad"), structural={"N": 4}
    ).modes(q=np.zeros(4), p=p)
    assert links.constraints == []
    assert rods.steadiness.kind == "equilibrium"
    np.testing.assert_allclose(rods.eigenvalues, angles.eigenvalues, atol=1e-9)


def test_a_four_bar_about_its_equilibrium() -> None:
    """Against one angle with the loop solved by hand: w^2 = V''/M, by differences of high order."""
    model = compiled("four_bar_angles")
    found = model.trim(free=["a"], q={"a": -1.2, "b": 0.9, "c": 0.9})
    modes = model.modes(q=found.point.q, qd=np.zeros(3))
    assert modes.steadiness.kind == "equilibrium"
    import mpmath

    l1, l2, l3, d, m1, m2, m3 = 0.4, 1.0, 0.8, 1.0, 1.0, 2.0, 1.5

    def angles(a: mpmath.mpf) -> tuple[mpmath.mpf, mpmath.mpf]:
        guess = (found.point.q[1], found.point.q[2])
        rows = [
            lambda b, c: l1 * mpmath.cos(a) + l2 * mpmath.cos(b) - d - l3 * mpmath.cos(c),
            lambda b, c: l1 * mpmath.sin(a) + l2 * mpmath.sin(b) - l3 * mpmath.sin(c),
        ]
        b, c = mpmath.findroot(rows, guess)
        return b, c

    def potential(a: mpmath.mpf) -> mpmath.mpf:
        b, c = angles(a)
        crank, rocker = m1 * l1 / 2 * mpmath.sin(a), m3 * l3 / 2 * mpmath.sin(c)
        return G_N * (crank + m2 * (l1 * mpmath.sin(a) + l2 / 2 * mpmath.sin(b)) + rocker)

    with mpmath.workdps(40):
        a = mpmath.findroot(lambda x: mpmath.diff(potential, x), float(found.point.q[0]))
        b, _ = angles(a)
        kb, kc = (mpmath.diff(lambda x, i=i: angles(x)[i], a) for i in (0, 1))
        inertia = m1 * l1**2 / 3 + m3 * l3**2 / 3 * kc**2
        inertia += m2 * (l1**2 + l1 * l2 * kb * mpmath.cos(a - b) + l2**2 / 3 * kb**2)
        square = float(mpmath.diff(potential, a, 2) / inertia)
    expected = np.sqrt(complex(-square))
    assert modes.point.q[0] == pytest.approx(float(a), abs=1e-10)
    assert min(abs(modes.eigenvalues - expected)) < 1e-8 * abs(expected)


def test_integrable_rows_drop_their_zeros() -> None:
    """A constraint in rates that says x1 = x2 + const: three positions, two rates; the zero of the constant goes."""
    text = """model Coupled
      coordinate Length x[2], s(start = 0.1 m);
      gravity = 0;
      mass 1 kg at {x[1], 0};
      mass 2 kg at {x[2], 1 m};
      mass 1 kg at {s, 2 m};
      potential 1/2*(12 N/m)*x[1]^2;
      potential 1/2*(4 N/m)*s^2;
      constraint same: der(x[1]) = der(x[2]);
    end Coupled;
    """
    model = lagdsl.compile(text)
    assert len(model.linearize().states) == 5
    modes = model.modes(trim=True)
    assert (modes.dropped, modes.integrable) == (1, ("same",))
    np.testing.assert_allclose(np.sort(modes.eigenvalues.imag), [-2, -2, 2, 2], atol=1e-7)


def test_ignorable_coordinates_keep_their_zeros() -> None:
    text = """model Cars
      coordinate Length x[2];
      gravity = 0;
      mass 1 kg at {x[1], 0};
      mass 1 kg at {x[2], 0};
      potential 1/2*(2 N/m)*(x[2] - x[1])^2;
    end Cars;
    """
    modes = lagdsl.compile(text).modes()
    np.testing.assert_array_equal(modes.eigenvalues[2:], [0, 0])
    np.testing.assert_allclose(modes.eigenvalues[:2], [2j, -2j], rtol=1e-13, atol=1e-13)
    assert modes.dropped == 0


def test_w0854_beside_the_equilibrium() -> None:
    sink = Sink()
    modes = compiled("pendulum").modes(sink=sink)
    assert [d.code for d in sink.diagnostics if d.code == "W0854"] == ["W0854"]
    assert modes.steadiness.kind == "neither"
    assert modes.stability.startswith("no statement")


def test_a_force_that_depends_on_the_time_is_no_equilibrium() -> None:
    text = """model Driven
      coordinate Length x;
      gravity = 0;
      mass 1 kg at {x, 0};
      potential 1/2*(1 N/m)*x^2;
      force (1 N)*sin(time*(1 rad/s)) on x;
    end Driven;
    """
    assert lagdsl.compile(text).modes().steadiness.kind == "neither"


def test_rest_in_equations_that_change_with_time_is_told_as_such() -> None:
    text = """model Shaken
      coordinate Angle th(start = 170 deg);
      gravity = -g_n*world.y;
      mass 1 kg at {(1 m)*sin(th), (1 cm)*cos(time*(50 rad/s)) - (1 m)*cos(th)};
    end Shaken;
    """
    sink = Sink()
    modes = lagdsl.compile(text).modes(trim=True, sink=sink)
    assert modes.steadiness.unbalanced == (("der(der(th))", 0.0),)
    [diagnostic] = [d for d in sink.diagnostics if d.code == "W0854"]
    assert "nothing accelerates, but the linear equations of der(der(th)) change along the motion" in diagnostic.message


def test_a_coordinate_that_runs_and_matters_is_no_steady_motion() -> None:
    text = """model Runs
      parameter Stiffness k = 1 N/m;
      coordinate Length x(start = 0), y(der(start = 1 m/s));
      gravity = 0;
      mass 1 kg at {x, y};
      potential 1/2*k*x^2*(1 + (y/(1 m))^2);
    end Runs;
    """
    model = lagdsl.compile(text)
    assert model.modes().steadiness.kind == "neither"
    assert model.modes(p={"k": 0.0}).steadiness.kind == "steady motion"


def test_damped_modes() -> None:
    text = """model Damped
      parameter Real zeta = 0.2;
      coordinate Length x;
      gravity = 0;
      mass 1 kg at {x, 0};
      potential 1/2*(9 N/m)*x^2;
      dissipation 1/2*2*zeta*(3 kg/s)*der(x)^2;
    end Damped;
    """
    model = lagdsl.compile(text)
    modes = model.modes()
    np.testing.assert_allclose(modes.damping, 0.2, rtol=1e-13)
    np.testing.assert_allclose(modes.frequencies, 3 / (2 * np.pi), rtol=1e-13)
    np.testing.assert_allclose(modes.time_constants, 1 / 0.6, rtol=1e-13)
    assert modes.stability.startswith("asymptotically stable")
    (threshold,) = model.vary("zeta", np.linspace(-1.1, 0.9, 8)).thresholds
    assert threshold.value == pytest.approx(0, abs=1e-12)
    assert threshold.kind == "flutter"


def test_values_of_a_start_value_and_an_unknown_name() -> None:
    model = compiled("rolling_hoop")
    (threshold,) = model.vary("der(spin).start", np.linspace(1, 8, 8), q={"lean": 0.0}).thresholds
    assert threshold.value == pytest.approx(np.sqrt(G_N / 0.9), rel=1e-10)
    with pytest.raises(lagdsl.CompilationFailed) as failure:
        model.vary("speed", [1, 2])
    assert [d.code for d in failure.value.diagnostics] == ["E0853"]
