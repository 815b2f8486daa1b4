"""The first instant: discrete starts, initial equations, least kinetic energy."""

from __future__ import annotations

from math import asin, cos, exp, sin

from attack.rows import Attack, check, model, rows

DISCRETES = [
    Attack(
        "discrete_mass_at_the_start",
        model(
            "coordinate Real x; discrete Real m(start = 2); kinetic 1/2*m*der(x)^2; force 6 on x;",
            "when time > 1 then m = 4; end when;",
        ),
        0.5,
        {"der(x)": 1.5, "x": 0.375},
    ),
    Attack(
        "discrete_mass_and_a_constraint",
        # rates 3, 0 go to the common speed by momenta: 2*3/(2 + 4)
        model(
            "coordinate Real x(der(start = 3)), y; discrete Real m(start = 2), k(start = 4); "
            "kinetic 1/2*m*der(x)^2 + 1/2*k*der(y)^2;"
            "constraint tie: x = y;",
            "when time > 9 then m = 4; k = 1; end when;",
        ),
        0.5,
        {"der(x)": 3.0, "der(y)": 3.0},
    ),
    Attack(
        "assertion_of_a_discrete",
        model(
            "coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2; discrete Integer n(start = 3);",
            'assert(n > 2, "too few"); when x > 5 then n = 4; end when;',
        ),
        1.0,
        {"n": 3},
    ),
    Attack(
        "discrete_force_at_the_start",
        model(
            "coordinate Real x; kinetic 1/2*der(x)^2; discrete Real f(start = 2); force f on x;",
            "when time > 1 then f = 0; end when;",
        ),
        3.0,
        {"der(x)": 2.0, "x": 1.0 + 4.0},
    ),
    Attack(
        "discrete_radius_of_a_constraint",
        model(
            "coordinate Real x(start = 3), y; discrete Real r(start = 3); kinetic 1/2*(der(x)^2 + der(y)^2); "
            "constraint c: x^2 + y^2 = r^2;",
            "when time > 9 then r = 1; end when;",
        ),
        1.0,
        {"x": 3.0, "y": 0.0},
    ),
    Attack(
        "discrete_place_of_a_contact",
        model(
            "coordinate Real x(start = 3, der(start = -1)); discrete Real w(start = 2); kinetic 1/2*der(x)^2; "
            "contact c: x >= w with restitution = 1;",
            "when time > 9 then w = 1; end when;",
        ),
        2.0,
        {"x": 3.0, "der(x)": 1.0},
    ),
    Attack(
        "discrete_switch_of_a_constraint",
        # held from the start: the blow of the start is that of the constraint
        model(
            "coordinate Real x(der(start = 3, fixed = false)), y; discrete Boolean held(start = true); "
            "kinetic 1/2*der(x)^2 + 1/2*2*der(y)^2;"
            "constraint c: (if held then der(x) - der(y) else 0) = 0; force 3 on x;",
            "when time > 1 then held = false; end when;",
        ),
        1.0,
        {"der(x)": 4.0, "der(y)": 4.0},
    ),
    Attack(
        "acceleration_of_the_first_instant",
        model(
            "coordinate Real x; discrete Real m(start = 0.5); kinetic 1/2*m*der(x)^2; force 3 on x; "
            "output Real a = der(der(x)); discrete Real seen(start = 0);",
            "when initial() then seen = a; end when; when time > 9 then m = 1; end when;",
        ),
        0.5,
        {"seen": 6.0, "a": 6.0},
    ),
    Attack(
        "enumeration_at_the_start",
        "model Attacked type Gear = enumeration(low, high); coordinate Real x; discrete Gear g(start = Gear.high); "
        "kinetic 1/2*der(x)^2;"
        'force (if g == Gear.high then 4 else 1) on x; annotation(units = "none");'
        "equation when time > 1 then g = Gear.low; end when; end Attacked;",
        2.0,
        {"der(x)": 5.0},
    ),
    Attack(
        "state_with_a_discrete_gain",
        model(
            "state Real z(start = 1); discrete Real k(start = -2);", "der(z) = k*z; when time > 1 then k = 2; end when;"
        ),
        2.0,
        {"z": 1.0},
    ),
    Attack(
        "condition_true_at_the_start_does_not_act",
        model(
            "coordinate Real x(start = 5, der(start = 1)); kinetic 1/2*der(x)^2; discrete Integer n(start = 0);",
            "when x > 2 then n = 7; end when;",
        ),
        1.0,
        {"n": 0},
    ),
    Attack(
        "set_at_the_start",
        model(
            "coordinate Real x; kinetic 1/2*m*der(x)^2; discrete Real m(start = 1); force 8 on x;",
            "when initial() then m = 4; end when;",
        ),
        1.0,
        {"der(x)": 2.0},
    ),
]

# A chain a = b tied to a, with a rate given; an unrelated pair tied c + d.
PAIR = "coordinate Real c(der(start = 1)), d; kinetic 1/2*der(c)^2 + 1/2*5*der(d)^2; constraint tie: c - d = 0;"

INITIAL = [
    Attack(
        "least_energy_beside_an_initial_equation",
        # rates 1 and 0, both explicit, masses 1 and 5, one row: momentum decides, 1/6
        "model Attacked coordinate Real c(der(start = 1)), d(der(start = 0)), x; "
        "kinetic 1/2*der(c)^2 + 1/2*5*der(d)^2 + 1/2*der(x)^2;"
        'constraint tie: c - d = 0; annotation(units = "none"); initial equation der(x) = 2; end Attacked;',
        1.0,
        {"der(x)": 2.0},
    ),
    Attack(
        "defaulted_rates_beside_an_initial_equation",
        # c + d given as a speed of 1, nothing explicit: least kinetic energy, by 5 : 1
        "model Attacked coordinate Real c, d, x; kinetic 1/2*der(c)^2 + 1/2*5*der(d)^2 + 1/2*der(x)^2;"
        'constraint sum: der(c) + der(d) = 1; annotation(units = "none"); initial equation der(x) = 2; end Attacked;',
        1.0,
        {"der(c)": 5 / 6, "der(d)": 1 / 6, "der(x)": 2.0},
    ),
    Attack(
        "defaulted_rates_without_an_initial_equation",
        model("coordinate Real c, d; kinetic 1/2*der(c)^2 + 1/2*5*der(d)^2; constraint sum: der(c) + der(d) = 1;"),
        1.0,
        {"der(c)": 5 / 6, "der(d)": 1 / 6},
    ),
    Attack(
        "defaulted_rates_beside_an_equation_of_position",
        "model Attacked coordinate Real c, d, x; kinetic 1/2*der(c)^2 + 1/2*5*der(d)^2 + 1/2*der(x)^2;"
        'constraint sum: der(c) + der(d) = 1; annotation(units = "none"); initial equation x = 2; end Attacked;',
        1.0,
        {"der(c)": 5 / 6, "der(d)": 1 / 6, "x": 2.0},
    ),
    Attack(
        "defaulted_rates_of_three",
        # masses 1, 2, 4 of a sum of 7: in the ratio of 1/m
        "model Attacked coordinate Real a, b, c, x(start = 1); "
        "kinetic 1/2*der(a)^2 + 1/2*2*der(b)^2 + 1/2*4*der(c)^2 + 1/2*der(x)^2; potential 1/2*x^2;"
        'constraint sum: der(a) + der(b) + der(c) = 7; annotation(units = "none");'
        "initial equation der(x) = 0; end Attacked;",
        1.0,
        {"der(a)": 4.0, "der(b)": 2.0, "der(c)": 1.0},
    ),
    Attack(
        "one_explicit_rate_beside_an_initial_equation",
        "model Attacked coordinate Real c(der(start = 0.25)), d, x; "
        "kinetic 1/2*der(c)^2 + 1/2*5*der(d)^2 + 1/2*der(x)^2;"
        'constraint sum: der(c) + der(d) = 1; annotation(units = "none"); initial equation der(x) = 2; end Attacked;',
        1.0,
        {"der(c)": 0.25, "der(d)": 0.75},
    ),
    Attack(
        "defaulted_rates_that_inertia_couples",
        # with u = a' + b' and v = b' the row is u + v = 3, the energy (u^2 + v^2)/2
        "model Attacked coordinate Real a, b, x; kinetic 1/2*(der(a) + der(b))^2 + 1/2*der(b)^2 + 1/2*der(x)^2;"
        'constraint sum: der(a) + 2*der(b) = 3; annotation(units = "none"); initial equation der(x) = 2; end Attacked;',
        1.0,
        {"der(a)": 0.0, "der(b)": 1.5, "der(x)": 2.0},
    ),
    Attack(
        "defaulted_rates_of_two_pairs",
        "model Attacked coordinate Real c, d, e, f, x; "
        "kinetic 1/2*(der(c)^2 + 5*der(d)^2 + 2*der(e)^2 + 3*der(f)^2 + der(x)^2);"
        "constraint one: der(c) + der(d) = 1; constraint two: der(e) + der(f) = 5;"
        'annotation(units = "none"); initial equation x = 1; end Attacked;',
        1.0,
        {"der(c)": 5 / 6, "der(d)": 1 / 6, "der(e)": 3.0, "der(f)": 2.0, "x": 1.0},
    ),
    Attack(
        "defaulted_rates_of_unequal_weights",
        # along M^-1 J' = (2, -1/5), which the row counts as 4.2
        "model Attacked coordinate Real c, d, x; kinetic 1/2*der(c)^2 + 1/2*5*der(d)^2 + 1/2*der(x)^2;"
        'constraint row: 2*der(c) - der(d) = 4; annotation(units = "none"); initial equation der(x) = 2; end Attacked;',
        1.0,
        {"der(c)": 8 / 4.2, "der(d)": -0.8 / 4.2},
    ),
    Attack(
        "defaulted_rates_beside_a_state",
        "model Attacked coordinate Real c, d; state Real z; kinetic 1/2*der(c)^2 + 1/2*5*der(d)^2;"
        'constraint sum: der(c) + der(d) = 1; annotation(units = "none");'
        "equation der(z) = -z; initial equation z = 3; end Attacked;",
        1.0,
        {"der(c)": 5 / 6, "der(d)": 1 / 6, "z": 3 * exp(-1)},
    ),
    Attack(
        "bead_on_a_circle_beside_an_initial_equation",
        # x = sin(p), 0.8 p' = 1 at x = 0.6; nothing acts along the circle
        "model Attacked coordinate Real x(start = 0.6, der(start = 1)), y(start = -0.8), s; "
        "kinetic 1/2*(der(x)^2 + der(y)^2 + der(s)^2); constraint circle: x^2 + y^2 = 1;"
        'annotation(units = "none"); initial equation der(s) = 2; end Attacked;',
        2.0,
        {"x": sin(asin(0.6) + 2.5), "y": -cos(asin(0.6) + 2.5), "s": 4.0},
    ),
]

SMALL = [
    Attack(
        "integer_input_holds",
        model("coordinate Real x; input Integer g; kinetic 1/2*der(x)^2; force g on x;"),
        4.0,
        {"der(x)": 1 * 2 + 3 * 2.0},
        inputs={"g": ((0.0, 2.0, 5.0), (1, 3, 3))},
    ),
    Attack(
        "integer_input_holds_down",
        model("coordinate Real x; input Integer g; kinetic 1/2*der(x)^2; force g on x;"),
        4.0,
        {"der(x)": 5 * 1 + 2 * 2 - 1 * 1.0},
        inputs={"g": ((0.0, 1.0, 3.0, 9.0), (5, 2, -1, -1))},
    ),
    Attack(
        "zero_times_time",
        "model Attacked coordinate Length x; kinetic 1/2*(1 kg)*der(x)^2; force (0*time/(1 s) + 1)*(2 N) on x; "
        "end Attacked;",
        1.0,
        {"der(x)": 2.0},
    ),
    Attack(
        "mod_of_integers",
        model(
            "coordinate Real x; kinetic 1/2*der(x)^2; force mod(n, 3) on x; "
            "discrete Integer n(start = 0), r(start = 0);",
            "when sample(1, 1) then n = pre(n) + 1; r = mod(n, 3); end when;",
        ),
        5.5,
        # n = 0, 1, 2, 3, 4, 5: forces 0, 1, 2, 0, 1, 2 (half)
        {"der(x)": 1 + 2 + 0 + 1 + 1.0, "r": 2},
    ),
    Attack(
        "mod_of_negative_integers",
        model(
            "coordinate Real x; kinetic 1/2*der(x)^2; discrete Integer n(start = 0), r(start = 0);",
            "when sample(1, 1) then n = pre(n) - 1; r = mod(n, 3); end when;",
        ),
        4.5,
        {"n": -4, "r": 2},
    ),
    Attack(
        "signed_celsius",
        "model Attacked parameter Temperature T = -5 degC; state Real z(start = 0); equation der(z) = T/(1 K.s); "
        "end Attacked;",
        1.0,
        {"z": 268.15},
    ),
    Attack(
        "speed_of_a_shape",
        # a smooth input through 0, 1, 1, 0: never above 1, and the angle is the area
        "model Attacked coordinate Angle a; input AngularVelocity w(smooth = 1); kinetic 1/2*(1 kg.m2)*der(a)^2; "
        "constraint drive: der(a) = w; end Attacked;",
        4.0,
        {"a": 3.0},
        inputs={"w": ((0.0, 1.0, 3.0, 4.0), (0.0, 1.0, 1.0, 0.0))},
        near=1e-6,
        refused=("any",),
    ),
]


@rows([*DISCRETES, *INITIAL, *SMALL])
def test_starts(row: Attack, engine: str) -> None:
    check(row, engine)
