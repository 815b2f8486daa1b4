"""Conserved quantities that are found: closed forms, and none where a load, a contact or an input breaks them."""

from __future__ import annotations

from functools import cache

import pytest
from choice import spread
from models.corpus import path_of

import lagdsl
from lagdsl.interfaces.api.model import Model

PLANE = "coordinate Length x(start = 0.3 m, der(start = 0.2 m/s)), y(start = 0.5 m, der(start = -0.4 m/s));"
WELL = "potential 0.5*k*(x - 2*y)^2;"
HEAD = "model A parameter Mass m = 2 kg, m2 = 3 kg; parameter Stiffness k = 5 N/m;"
PAIR = (
    "coordinate Length x1(der(start = 0.2 m/s)), y1, x2(start = 1 m), y2(start = 0.1 m, der(start = -0.4 m/s));"
    "point P = {x1, y1}; point S = {x2, y2}; mass m at P; mass m2 at S;"
)
HOLD = "potential 0.5*k*(norm(S - P) - 1 m)^2;"


@cache
def model(body: str, head: str = HEAD) -> Model:
    return lagdsl.compile(f"{head} {body} end A;\n")


def found(body: str, head: str = HEAD) -> set[str]:
    return {each.expression for each in model(body, head).conserved_quantities}


def of_file(name: str) -> set[str]:
    return {each.expression for each in lagdsl.compile(path_of(name)).conserved_quantities}


def test_a_hidden_linear_symmetry() -> None:
    """V(x - 2 y) does not change along (2, 1)."""
    assert found(f"{PLANE} mass m at {{x, y}}; {WELL}") == {"energy()", "2*momentum(x) + momentum(y)"}


def test_a_symmetry_with_a_parameter() -> None:
    """V(x - a y) does not change along (a, 1), whatever a is."""
    (energy, momentum) = model(
        f"parameter Real a = 1.7; {PLANE} mass m at {{x, y}}; potential 0.5*k*(x - a*y)^2;"
    ).conserved_quantities
    assert energy.expression == "energy()"
    assert momentum.expression == "momentum(x) + momentum(y)/a"
    assert momentum.for_all_parameters
    assert "x -> x + eps" in momentum.because


def test_a_symmetry_of_equal_springs_is_told_as_such() -> None:
    """kx = ky: the angular momentum is constant for these values only."""
    body = f"parameter Stiffness c = 5 N/m; {PLANE} mass m at {{x, y}}; potential 0.5*k*x^2 + 0.5*c*y^2;"
    quantities = {each.expression: each for each in model(body).conserved_quantities}
    assert set(quantities) == {"energy()", "angular_momentum(about = world.origin).z"}
    assert quantities["energy()"].for_all_parameters
    assert not quantities["angular_momentum(about = world.origin).z"].for_all_parameters


def test_two_bodies_in_free_space() -> None:
    quantities = model(PAIR + HOLD).conserved_quantities
    assert {each.expression for each in quantities if each.for_all_parameters} == {
        "energy()",
        "linear_momentum().x",
        "linear_momentum().y",
        "angular_momentum(about = world.origin).z",
    }


def test_a_central_force_keeps_the_angular_momentum() -> None:
    polar = "coordinate Length r(start = 1 m); coordinate Angle phi(der(start = 2 rad/s));"
    quantities = model(f"{polar} mass m at {{r*cos(phi), r*sin(phi)}}; potential -k*(1 m)^3/r;").conserved_quantities
    assert [each.expression for each in quantities] == ["energy()", "momentum(phi)"]
    assert quantities[1].also == ("angular_momentum(about = world.origin).z",)
    assert quantities[1].unit == "kg.m2/s"
    assert "phi is ignorable" in quantities[1].because
    assert all(text.startswith("<text>:1: ") and "coordinate Angle phi" in text for text in quantities[1].statements)


def test_a_symmetric_top_has_three() -> None:
    assert of_file("heavy_top") >= {"energy()", "momentum(psi)", "momentum(phi)"}


def test_jacobis_integral_is_not_the_energy() -> None:
    """A bead on a hoop that turns at a given speed."""
    assert of_file("bead_on_hoop") == {"jacobi_integral()"}
    assert of_file("foucault_pendulum") == {"jacobi_integral()"}


def test_the_energy_less_the_work_of_a_driven_frame() -> None:
    """The same with the angle of the hoop as a coordinate that a constraint drives: E - Omega p."""
    bead = (
        "parameter AngularVelocity w = 4 rad/s; parameter Length R = 0.5 m; coordinate Angle theta(start = 1 rad);"
        "coordinate Angle phi; frame hoop = world.rotz(phi); gravity = -g_n*world.z;"
        "mass m at hoop.point({R*sin(theta), 0, -R*cos(theta)}); constraint drive: phi = w*time;"
    )
    assert found(bead) == {"energy() - w*momentum(phi)"}


def test_a_gauge() -> None:
    """Uniform magnetic field: m x' - B y is constant (Landau and Lifshitz, *Theory of Fields*, section 21)."""
    field = f'parameter Real B(unit = "kg/s") = 3; {PLANE} mass m at {{x, y}}; lagrangian 0.5*B*(x*der(y) - y*der(x));'
    quantities = found(field)
    assert "energy()" in quantities
    assert any("momentum(x)" in text and "B*y" in text for text in quantities), quantities
    assert any("momentum(y)" in text and "B*x" in text for text in quantities), quantities


def test_nonholonomic() -> None:
    """A knife edge on a plane turns evenly, and keeps its energy; no momentum of the whole is constant."""
    assert of_file("knife_edge") == {"energy()", "momentum(phi)"}


BREAKERS = {
    "force 1 N*time/(1 s) on x1;": {"linear_momentum().y"},
    "force {1 N, 0} at P;": {"linear_momentum().y"},
    "gravity = -g_n*world.y;": {"energy()", "linear_momentum().x"},
    "input Force F; force F on y1;": {"linear_momentum().x"},
    "input Length d; potential k*d*x1;": {"linear_momentum().y"},
    "dissipation 0.5*(1 N.s/m)*(der(x1)^2 + der(y1)^2);": set(),
    "dissipation 0.5*(1 N.s/m)*((der(x1) - der(x2))^2 + (der(y1) - der(y2))^2);": {
        "linear_momentum().x",
        "linear_momentum().y",
    },
    "contact floor: y1 >= -(1 m) with restitution = 0.5;": {"linear_momentum().x"},
    "when x1 > 5 m then reinit(der(x1), 0); end when;": set(),
    "potential if x1 > 8 m then k*(x1 - 8 m)^2 else 0*k*(1 m)^2;": {"linear_momentum().y"},
    "potential k*max(0, x1 - 8 m)^2;": set(),
    "potential noEvent(if x1 < 2 m then 0 J else 2 J);": {
        "linear_momentum().x",
        "linear_momentum().y",
        "angular_momentum(about = world.origin).z",
    },
    "potential if x1 < 2 m then 0 J else 2 J;": {"linear_momentum().y"},
    "potential (2 J)*floor(y1/(3 m));": {"linear_momentum().x"},
    "potential if norm(P) < 2 m then 0 J else 2 J;": {"angular_momentum(about = world.origin).z"},
    "potential if norm(S - P) < 2 m then 0 J else 2 J;": {
        "linear_momentum().x",
        "linear_momentum().y",
        "angular_momentum(about = world.origin).z",
    },
}


@pytest.mark.parametrize("broken", spread(BREAKERS, 8))
def test_nothing_that_is_broken_appears(broken: str) -> None:
    """A pair of masses and a spring, with one thing more."""
    kept = found(PAIR + HOLD + broken)
    wholes = {"energy()", "linear_momentum().x", "linear_momentum().y", "angular_momentum(about = world.origin).z"}
    assert kept & wholes == BREAKERS[broken] & wholes, kept


def test_a_clutch_keeps_the_angular_momentum_only() -> None:
    """The energy that it dissipates when it closes is no fixed part of a momentum."""
    body = (
        "coordinate Angle a(der(start = 1 rad/s)), b; discrete Boolean on(start = false); kinetic "
        "1/2*(1 kg.m2)*der(a)^2 + 1/2*(2 kg.m2)*der(b)^2; constraint c: (if on then der(a) - der(b) else 0 rad/s) = 0; "
        "when time > 1 s then on = true; end when;"
    )
    assert found(body) == {"momentum(a) + momentum(b)"}


def test_what_no_rates_have_is_left_out() -> None:
    """Impulses at random lead beyond the speed of light, where there is no energy."""
    lagrangian = "lagrangian -m*(1 m/s)^2*sqrt(1 - (der(x)/(1 m/s))^2 - (der(y)/(1 m/s))^2)"
    step = " - (if y < 1 m then 0 J else 0.1 J);"
    assert found(PLANE + lagrangian + step) == {"momentum(x)"}


def test_balls_that_collide_keep_their_momentum() -> None:
    body = (
        "coordinate Length x1(der(start = 1 m/s)), x2(start = 1 m); mass m at {x1, 0}; mass m2 at {x2, 0};"
        "contact hit: x2 - x1 >= 0.1 m with restitution = 0.6;"
    )
    assert found(body) == {"linear_momentum().x"}


@pytest.mark.parametrize("name", ["rolling_coin", "two_masses_and_spring", "gyroscope_in_gimbals", "charged_particle"])
def test_expressions_are_claims_that_hold(name: str) -> None:
    """A quantity that is found can be written into the model, and the runtime sees no drift."""
    text = path_of(name).read_text()
    quantities = lagdsl.compile(path_of(name)).conserved_quantities
    assert quantities
    claims = "".join(f"  invariant found{k}: {each.expression};\n" for k, each in enumerate(quantities))
    at = text.rindex("  annotation(experiment")
    motion = lagdsl.compile(text[:at] + claims + text[at:]).simulate(stop=0.5)
    drifts = {each.name: (each.drift, each.limit) for each in motion.invariants if each.name.startswith("found")}
    assert len(drifts) == len(quantities)
    assert all(drift <= limit for drift, limit in drifts.values())


HELD = """
model Table "on two pins and a rail: nothing can move"
  parameter Mass m = 10 kg;
  coordinate Length x, y(start = 0.5 m);
  coordinate Angle q;
  frame plank = world.at({x, y, 0}).rotz(q);
  body b(m = m, com = {0.1 m, 0}, Izz = 0.8 kg.m2) on plank;
  gravity = -9.81 m/s2*world.y;
  point L = plank.point({-0.4 m, -0.5 m, 0}), R = plank.point({0.6 m, -0.5 m, 0});
  constraint {L.x, L.y} = {-0.4 m, 0};
  constraint R.y = 0;
end Table;
"""


def test_momenta_that_are_held_at_zero_are_no_quantities_of_interest() -> None:
    """None is constant because its coordinate is ignorable: constraint forces hold it."""
    assert lagdsl.compile(HELD).conserved_quantities == ()


def test_a_momentum_of_a_body_at_rest_keeps_its_value_but_for_round_off() -> None:
    """Two springs between bodies at 0.1 m and 0.7 m, with lengths that do not cancel to the bit."""
    text = """
    model Rest
      coordinate Length x(start = 0.1 m), y(start = 0.7 m);
      parameter Stiffness k = 700 N/m;
      mass 3 kg at {x, 0};
      mass 2 kg at {y, 0};
      gravity = 0;
      potential 1/2*k*(y - x - 0.3 m)^2 + 1/2*k*(y - x - 0.9 m)^2;
      annotation(experiment(StopTime = 5));
    end Rest;
    """
    certificate = lagdsl.compile(text).verify()
    lines = {line.name: line for line in certificate.lines}
    assert lines["conserved linear_momentum().x"].verdict == "held"
    assert lines["a tenth of the tolerance"].figure < 1e-9
    assert certificate.holds
