"""States that carry masses or stand in kinetic energies are functions of time: forces of d'Alembert, and blows."""

from __future__ import annotations

from math import cos, exp, sin, sqrt

import pytest
from attack.rows import Attack, check, model, rows
from choice import spread

import lagdsl
from lagdsl.motion.simulate.failure import SimulationFailed

FOLLOWING = [
    Attack(
        "free_mass_on_a_carriage_that_follows_it",
        # no force acts: x' + p' = 1, however steep the carriage starts
        model(
            "coordinate Real x(der(start = 1)); state Real p; gravity = 0; mass 1 at {x + p, 0};",
            "der(p) = 0.25*(1 + tanh((x - 1.5)/0.02));",
        ),
        3.0,
        {"der(x)": 0.5},
    ),
    Attack(
        "mass_on_a_servo_and_one_on_the_ground",
        # 2 x'' + p'' = 0 with p' = x
        model(
            "coordinate Real x(der(start = 1)); state Real p; gravity = 0; mass 1 at {x + p, 0}; kinetic 1/2*der(x)^2;",
            "der(p) = x;",
        ),
        3.0,
        {"der(x)": exp(-1.5), "x": 2 * (1 - exp(-1.5))},
    ),
    Attack(
        "mass_on_a_servo_on_a_servo",
        # x' + p' + q' is kept, so that x'' + x' + x = 0
        model(
            "coordinate Real x(der(start = 1)); state Real p, q; gravity = 0; mass 1 at {x + p + q, 0};",
            "der(p) = x; der(q) = p;",
        ),
        2.0,
        {"x": 2 * exp(-1) * sin(sqrt(3)) / sqrt(3)},
    ),
    Attack(
        "rate_of_a_state_in_a_kinetic_energy",
        model(
            "coordinate Real x(der(start = 1)); state Real p; kinetic 1/2*(der(x) + der(p))^2;",
            "der(p) = x;",
        ),
        3.0,
        {"der(x)": exp(-3)},
    ),
    Attack(
        "body_on_a_turntable_that_follows_it",
        model(
            "coordinate Real a(der(start = 1)); state Real p; gravity = 0; frame F = world.rotz(p).rotz(a); "
            "body b(m = 1, com = {0.3, 0, 0}, Izz = 0.5) on F;",
            "der(p) = a;",
        ),
        3.0,
        {"der(a)": exp(-3)},
    ),
    Attack(
        "reactions_of_a_carriage_that_follows",
        # x as above; the lift h'' = 0.6 x x', and m (x'' + p'') = x'/2 along the slide
        model(
            "coordinate Real x(der(start = 1)); state Real p, h; gravity = 0; frame C = world.move({p, h, 0}); "
            "mass 1 at C.point({x, 0, 0}); kinetic 1/2*der(x)^2; "
            "output Real lift = reaction(C).force.y; output Real push = reaction(C).force.x;",
            "der(p) = x; der(h) = 0.3*x^2;",
        ),
        1.0,
        {"lift": 1.2 * (1 - exp(-0.5)) * exp(-0.5), "push": 0.5 * exp(-0.5)},
    ),
    Attack(
        "damper_to_a_carriage_that_follows_a_speed",
        # x'' = -(x' - p') with p' = x'/2
        model(
            "coordinate Real x(der(start = 1)); state Real p; kinetic 1/2*der(x)^2; "
            "dissipation 1/2*(der(x) - der(p))^2;",
            "der(p) = 1/2*der(x);",
        ),
        3.0,
        {"der(x)": exp(-1.5)},
    ),
    Attack(
        "mass_on_a_carriage_that_follows_a_speed",
        # x' + p' is kept; M would not be symmetric
        model(
            "coordinate Real x(der(start = 1)); state Real p; gravity = 0; mass 1 at {x + p, 0}; kinetic 1/2*der(x)^2;",
            "der(p) = der(x) + x;",
        ),
        3.0,
        {"der(x)": exp(-1.0)},
        refused=("E0308",),
    ),
    Attack(
        # the momentum at held p2 = der(der(p)) is der(x) + p2, and der(p2) follows der(der(x)): 2 der(der(x)) = -x
        "second_rate_of_a_state_in_a_kinetic_energy",
        model(
            "coordinate Real x(start = 1); state Real p; kinetic 1/2*(der(x) + der(der(p)))^2; potential x^2/2;",
            "der(p) = x;",
        ),
        1.0,
        {"x": cos(sqrt(0.5))},
        refused=("E0308",),
    ),
    Attack(
        # x follows y, which falls; the constraint pulls x alone
        "place_of_a_constraint_that_follows_a_speed",
        model(
            "coordinate Real x, y; state Real w; kinetic 1/2*(der(x)^2 + der(y)^2); force -2 on y; constraint d: x = w;"
            "output Real pull = multiplier(d);",
            "der(w) = der(y);",
        ),
        1.0,
        {"x": -1.0, "pull": -2.0},
        refused=("E0308",),
    ),
    Attack(
        # the edge turns with 0.7 + 0.2 x: the side force is m v times that
        "edge_that_follows_a_place",
        model(
            "coordinate Real x(der(start = 1)), y; state Real a, l(start = 0); kinetic 1/2*(der(x)^2 + der(y)^2);"
            "constraint k: der(y)*cos(a) - der(x)*sin(a) = 0; output Real off = multiplier(k) - 0.7 - 0.2*x;",
            "der(a) = 0.7 + 0.2*x; der(l) = der(x)*cos(a) + der(y)*sin(a);",
        ),
        2.0,
        {"off": 0.0, "l": 2.0},
    ),
]


def _carried() -> float:
    """x on a carriage whose speed is 1 from 1 to 2, with the spring 9."""
    x, v = 0.0, 1.0
    for jump, time in ((0.0, 1.0), (-1.0, 1.0), (1.0, 0.5)):
        v += jump
        x, v = x * cos(3 * time) + v / 3 * sin(3 * time), -3 * x * sin(3 * time) + v * cos(3 * time)
    return x


SET = [
    Attack(
        "mass_that_a_clause_sets",
        model(
            "coordinate Real x(der(start = 2)); state Real m(start = 1); kinetic 1/2*m*der(x)^2;",
            "der(m) = 0;\nwhen time >= 1 then reinit(m, 4); end when;",
        ),
        2.0,
        {"der(x)": 0.5, "x": 2.5},
    ),
    Attack(
        "mass_and_rate_that_a_clause_sets",
        model(
            "coordinate Real x(der(start = 2)); state Real m(start = 1); kinetic 1/2*m*der(x)^2;",
            "der(m) = 0;\nwhen time >= 1 then reinit(m, 4); reinit(der(x), 3); end when;",
        ),
        2.0,
        {"der(x)": 3.0, "x": 5.0},
    ),
    Attack(
        "mass_by_a_state_and_a_discrete",
        model(
            "coordinate Real x(der(start = 2)); state Real m(start = 1); discrete Real k(start = 1); "
            "kinetic 1/2*m*k*der(x)^2;",
            "der(m) = 0;\nwhen time >= 1 then reinit(m, 4); k = 2; end when;",
        ),
        2.0,
        {"der(x)": 0.25},
    ),
    Attack(
        "speed_of_a_carriage_that_clauses_set",
        model(
            "coordinate Real x(der(start = 1)); state Real p, w; gravity = 0; mass 1 at {x + p, 0}; "
            "potential 1/2*9*x^2;",
            "der(p) = w; der(w) = 0;\nwhen sample(1, 1) then reinit(w, 1 - pre(w)); end when;",
        ),
        2.5,
        {"x": _carried()},
    ),
    Attack(
        "magnetic_field_that_a_clause_sets",
        # the field that appears at 1 s, at x = 1, turns the charge: y' = -B x/2
        model(
            "coordinate Real x(start = 1), y; kinetic 1/2*(der(x)^2 + der(y)^2); state Real B; "
            "lagrangian B/2*(x*der(y) - y*der(x));",
            "der(B) = 0;\nwhen time >= 1 then reinit(B, 2); end when;",
        ),
        1.5,
        {"der(x)": -sin(1), "der(y)": -cos(1), "y": -sin(1) / 2},
    ),
    Attack(
        "edge_that_a_clause_turns",
        model(
            "coordinate Real x(der(start = 1)), y; state Real th; kinetic 1/2*(der(x)^2 + der(y)^2); "
            "constraint k: der(y)*cos(th) - der(x)*sin(th) = 0;",
            "der(th) = 0;\nwhen time >= 1 then reinit(th, 1); end when;",
        ),
        2.0,
        {"x": 1 + cos(1) ** 2, "y": cos(1) * sin(1)},
    ),
    Attack(
        "counter_of_a_way_set_back",
        # what the state loses the discrete takes: the mass stays where it is
        model(
            "coordinate Real x(der(start = 1)); state Real p(start = 0.5); discrete Real o(start = 0); gravity = 0; "
            "mass 1 at {x + o + p, 0}; potential 1/2*4*x^2;",
            "der(p) = 0;\nwhen time >= 1 then o = pre(o) + pre(p); reinit(p, 0); end when;",
        ),
        3.0,
        {"x": sin(6) / 2},
    ),
    Attack(
        "ground_that_a_clause_lowers",
        model(
            "coordinate Real x(start = 0.5); state Real p(start = 0.5); kinetic 1/2*der(x)^2; force -2 on x; "
            "contact c: x >= p with restitution = 0;",
            "der(p) = 0;\nwhen time >= 1 then reinit(p, 0); end when;",
        ),
        1.5,
        {"x": 0.25},
    ),
]

# The same carriage three times: it starts to move where the mass is at 1, and the momentum of the mass is kept.
CARRIAGE = "coordinate Real x(der(start = 1)); {} gravity = 0; mass 1 at {{x + p, 0}};"
STARTED = [
    Attack(
        "carriage_that_a_place_starts",
        model(CARRIAGE.format("state Real p;"), "der(p) = if x > 1 then 0.5 else 0;"),
        3.0,
        {"der(x)": 0.5, "x": 2.0},
        refused=("E0311",),
    ),
    Attack(
        "carriage_of_a_constraint_that_a_place_starts",
        model(CARRIAGE.format("coordinate Real p; constraint k: der(p) = if x > 1 then 0.5 else 0;")),
        3.0,
        {"der(x)": 0.5, "x": 2.0},
    ),
    Attack(
        "carriage_that_a_clause_starts",
        model(
            CARRIAGE.format("state Real p; discrete Real w(start = 0);"),
            "der(p) = w; when x > 1 then w = 0.5; end when;",
        ),
        3.0,
        {"der(x)": 0.5, "x": 2.0},
    ),
    Attack(
        # x' = 2 - abs(x - 1): x = exp(t) - 1, from 1 on 3 - x falls
        "carriage_with_a_corner_in_its_way",
        model(CARRIAGE.format("state Real p;"), "der(p) = abs(x - 1);"),
        3.0,
        {"der(x)": 4 * exp(-3), "x": 3 - 4 * exp(-3)},
    ),
    Attack(
        # the state that jumps carries nothing: the step of energy is felt
        "state_beside_a_step",
        model(
            "coordinate Real x(der(start = 2)); state Real p; kinetic 1/2*der(x)^2; "
            "potential if x > 1 then 1.5 else 0;",
            "der(p) = if x > 1 then 0.5 else 0;",
        ),
        1.5,
        {"der(x)": 1.0, "p": 0.5},
    ),
]

# Places that a clause would move by setting the state p to 2: there is no motion to compare with.
TORN = [
    Attack(
        f"{name}_that_a_clause_sets",
        model(
            f"coordinate Real x(start = 0), y(start = 1); state Real p; gravity = 0; kinetic 1/2*der(y)^2; {text}",
            "der(p) = 0;\nwhen time >= 1 then reinit(p, 2); end when;",
        ),
        3.0,
        {"x": float("nan")},
        refused=(code,),
    )
    for name, text, code in (
        ("way", "mass 1 at {x + p, 0};", "E0836"),
        ("turned_way", "mass 1 at world.rotz(p).point({x + 1, 0, 0});", "E0836"),
        ("place_of_a_constraint", "mass 1 at {x, 0}; constraint c: x = p;", "E0835"),
        ("ground", "mass 1 at {x, 0}; contact c: x + 1 >= p with restitution = 0.5;", "E0834"),
    )
]

# The kinetic energy has the rate of a vector: a mass that changes from 2 to 1 keeps its momentum, a way must not jump.
CHANGED = (
    "coordinate Real x(der(start = 4)), y(der(start = 2)); discrete Real m(start = 2), d(start = 0); gravity = 0; "
)
VECTORS = [
    Attack(
        "mass_of_a_vector_that_a_clause_sets",
        model(
            CHANGED + "point P = {x, y}; kinetic 1/2*m*der(P)*der(P);", "when time >= 1 then m = 1; d = 1; end when;"
        ),
        2.0,
        {"der(x)": 8.0, "der(y)": 4.0, "x": 12.0},
    ),
    Attack(
        "way_of_a_vector_that_a_clause_sets",
        model(
            CHANGED + "point P = {x + d, y}; kinetic 1/2*m*der(P)*der(P);",
            "when time >= 1 then m = 1; d = 1; end when;",
        ),
        2.0,
        {"x": float("nan")},
        refused=("E0836",),
    ),
]


# States whose rates follow coordinates and stand in energies: what they do, and how fast they do it, has power.
DOING = {
    "place_and_time": model(
        "coordinate Real x(start = 1, der(start = 0.5)), y; state Real p(start = 0.3), q; gravity = {0, -9.81}; "
        "mass 1 at {x + p, y + q}; kinetic 1/2*(der(x)^2 + der(y)^2); potential 4*x^2 + 7*y^2 + x*y*p; "
        "force {-3*der(x), 2} at {x + p, y};",
        "der(p) = x*y - p; der(q) = sin(time)*x - q;",
    ),
    "moving_constraint": model(
        "coordinate Real x(start = 1), y; state Real p(start = 0.3); gravity = {0, -9.81}; mass 1 at {x + p, y}; "
        "kinetic 1/2*der(x)^2; constraint c: y = sin(x) + p*time;",
        "der(p) = x - p;",
    ),
    "magnetic_field": model(
        "coordinate Real x(start = 1), y; state Real B(start = 0.3); kinetic 1/2*(der(x)^2 + der(y)^2); "
        "lagrangian B/2*(x*der(y) - y*der(x)) + 0.1*der(B)*x; potential x^2 + 2*y^2;",
        "der(B) = x*y - B;",
    ),
    "input": model(
        "coordinate Real x(start = 1); input Real u(smooth = 1, start = 0.7); state Real p; gravity = 0; "
        "mass 1 at {x + p, 0}; kinetic 1/2*der(x)^2; potential x^2;",
        "der(p) = x*u - p;",
    ),
    "rate_that_a_state_has": model(
        "coordinate Real x(der(start = 1)); state Real z(start = 1), w; kinetic 1/2*(1 + der(z)^2)*der(x)^2;",
        "der(z) = w; der(w) = -4*z;",
    ),
    "second_rate_that_states_have": model(
        "coordinate Real x(start = 1); state Real p(start = 0.3), q(start = 0.2); kinetic 1/2*der(x)^2; "
        "potential x^2/2 + x*der(der(p));",
        "der(p) = sin(time)*q - p; der(q) = -p;",
    ),
}
CERTIFIED = {row.name: row.text for row in (*FOLLOWING, STARTED[1]) if not row.refused} | DOING


@pytest.mark.parametrize("name", spread(CERTIFIED, 4))
def test_certificates_and_derivations_of_states(name: str) -> None:
    """Derivations count rows with states; the power of what states do is part of the balance."""
    attacked = lagdsl.compile(CERTIFIED[name])
    assert "Lagrange" in str(attacked.derive())
    found = attacked.verify()
    assert [(line.name, line.figure) for line in found.lines if line.verdict == "failed"] == []
    assert any(line.name == "power balance" and line.verdict == "held" for line in found.lines)


@pytest.mark.parametrize(("clause", "told"), [("time >= 1", "`p`, `time >= 1`"), ("sample(1, 5)", "`p`")])
def test_states_that_would_move_masses_are_named(clause: str, told: str) -> None:
    """By the clause that sets them, and not by its condition; what sets other states is not told."""
    text = model(
        "coordinate Real x; state Real p, far; gravity = 0; mass 1 at {x + p, 0};",
        "der(p) = 0; der(far) = 0;\n"
        f"when time >= 2 then reinit(far, 1); elsewhen {clause} then reinit(p, 2); end when;",
    )
    with pytest.raises(SimulationFailed) as failure:
        lagdsl.compile(text).simulate(stop=3.0)
    (diagnostic,) = failure.value.diagnostics
    assert diagnostic.code == "E0836"
    assert f"jumps with {told} at t = 1 s" in diagnostic.message
    assert text[diagnostic.labels[0].span.start :].startswith("reinit(p, 2)")


@rows([*FOLLOWING, *SET, *STARTED, *TORN, *VECTORS])
def test_states_that_move_masses(row: Attack, engine: str) -> None:
    check(row, engine)
