"""Constraints that a relation, an input or a clause switches take hold at the event, by the smallest impulse."""

from __future__ import annotations

from math import asinh, cos, cosh, exp, sin

from attack.rows import Attack, check, model, rows

# Two discs of inertias 1 and 2, torque 3 on the first; the clutch closes at 0.5 s.
# Before: a' = 3 t. At 0.5: a' = 1.5, so both have 0.5. After: 3/(1 + 2) = 1.
DISCS = "coordinate Real a, b; kinetic 1/2*der(a)^2 + 1/2*2*der(b)^2; torque 3 on a;"
CLOSED = {"der(a)": 1.0, "der(b)": 1.0, "a": 0.375 + 0.25 + 0.125, "b": 0.25 + 0.125}

CLUTCHES = [
    Attack(
        "clutch_by_time",
        model(DISCS + "constraint clutch: (if time < 0.5 then 0 else der(a) - der(b)) = 0;"),
        1.0,
        CLOSED,
    ),
    Attack(
        "clutch_by_time_other_branch_first",
        model(DISCS + "constraint clutch: (if time >= 0.5 then der(b) - der(a) else 0) = 0;"),
        1.0,
        CLOSED,
    ),
    Attack(
        "clutch_by_a_definition",
        model(DISCS + "Boolean on = not time < 0.5; constraint clutch: (if on then der(a) - der(b) else 0) = 0;"),
        1.0,
        CLOSED,
    ),
    Attack(
        "clutch_by_an_angle",
        model(DISCS + "constraint clutch: (if a < 0.375 then 0 else der(a) - der(b)) = 0;"),
        1.0,
        CLOSED,
    ),
    Attack(
        "clutch_by_an_angle_by_a_clause",
        model(
            DISCS + "discrete Boolean on(start = false); constraint clutch: (if on then der(a) - der(b) else 0) = 0;",
            "when a >= 0.375 then on = true; end when;",
        ),
        1.0,
        CLOSED,
    ),
    Attack(
        "clutch_by_a_clock",
        model(
            DISCS + "discrete Boolean on(start = false); constraint clutch: (if on then der(a) - der(b) else 0) = 0;",
            "when sample(0.5, 10) then on = true; end when;",
        ),
        1.0,
        CLOSED,
    ),
    Attack(
        "clutch_by_an_input",
        model(DISCS + "input Boolean on; constraint clutch: (if on then der(a) - der(b) else 0) = 0;"),
        1.0,
        CLOSED,
        inputs={"on": ((0.0, 0.5, 0.5, 2.0), (0.0, 0.0, 1.0, 1.0))},
    ),
    Attack(
        "clutch_by_an_input_that_ramps",
        model(DISCS + "input Boolean on; constraint clutch: (if on then der(a) - der(b) else 0) = 0;"),
        1.0,
        CLOSED,
        inputs={"on": lambda t: t},  # rows of a table would hold
    ),
    Attack(
        "clutch_by_a_state",
        model(
            DISCS + "state Real c; constraint clutch: (if c < 0.25 then 0 else der(a) - der(b)) = 0;",
            "der(c) = 0.5;",
        ),
        1.0,
        CLOSED,
    ),
    Attack(
        "clutch_twice_declared",
        model(
            DISCS
            + "constraint one: (if time < 0.5 then 0 else der(a) - der(b)) = 0;"
            + "constraint two: (if time < 0.5 then 0 else 2*der(a) - 2*der(b)) = 0;"
        ),
        1.0,
        CLOSED,
    ),
    Attack(
        "clutch_of_three_discs",
        model(
            "coordinate Real a(der(start = 6)), b, c; kinetic 1/2*(der(a)^2 + der(b)^2 + der(c)^2);"
            "constraint one: (if time < 1 then 0 else der(a) - der(b)) = 0;"
            "constraint two: (if time < 2 then 0 else der(b) - der(c)) = 0;"
        ),
        3.0,
        {"a": 6 + 3 + 2, "b": 3 + 2, "c": 2, "der(a)": 2, "der(c)": 2},
    ),
    Attack(
        "clutch_opens",
        model(
            "coordinate Real a(der(start = 1)), b(der(start = 1)); kinetic 1/2*der(a)^2 + 1/2*2*der(b)^2; "
            "torque 3 on a;"
            "constraint clutch: (if time < 0.5 then der(a) - der(b) else 0) = 0;"
        ),
        1.0,
        {"der(a)": 1.5 + 1.5, "der(b)": 1.5, "a": 0.625 + 0.75 + 0.375, "b": 0.625 + 0.75},
    ),
    Attack(
        "clutch_closes_and_opens_with_a_sine",
        model(
            "coordinate Real a, b; kinetic 1/2*der(a)^2 + 1/2*der(b)^2; torque 1 on a;"
            "constraint clutch: (if sin(pi*time) > 0 then der(a) - der(b) else 0) = 0;"
        ),
        4.0,
        # [0, 1] together to 1/2; [1, 2] a gains 1; at 2 both 1, [2, 3] to 3/2, [3, 4] a gains 1
        {"der(a)": 2.5, "der(b)": 1.5, "a": 0.25 + 1.0 + 1.25 + 2.0, "b": 0.25 + 0.5 + 1.25 + 1.5},
        near=2e-8,
    ),
]

# A disc of 1 on a spring of stiffness 4 whose other end is driven at a speed that jumps from 0 to 2 at 1 s.
DRIVEN = "coordinate Real a, b; kinetic 1/2*der(a)^2 + 1/2*der(b)^2; potential 1/2*4*(a - b)^2;"
AT_3 = {"a": 4.0, "der(a)": 2.0, "b": 4 - sin(4), "der(b)": 2 - 2 * cos(4)}

DRIVES = [
    Attack("speed_by_if", model(DRIVEN + "constraint d: der(a) = if time < 1 then 0 else 2;"), 3.0, AT_3),
    Attack("speed_by_sign", model(DRIVEN + "constraint d: der(a) = 1 + sign(time - 1);"), 3.0, AT_3),
    Attack("speed_by_floor", model(DRIVEN + "constraint d: der(a) = 2*min(floor(time), 1);"), 3.0, AT_3),
    Attack("place_by_if", model(DRIVEN + "constraint d: a = if time < 1 then 0 else 2*(time - 1);"), 3.0, AT_3),
    Attack("place_by_max", model(DRIVEN + "constraint d: a = max(0, 2*(time - 1));"), 3.0, AT_3),
    Attack("place_by_table", model(DRIVEN + "constraint d: a = table(time, {0, 1, 5}, {0, 0, 8});"), 3.0, AT_3),
    Attack("place_by_limit", model(DRIVEN + "constraint d: a = limit(2*time - 2, 0, 100);"), 3.0, AT_3),
    Attack("place_by_abs", model(DRIVEN + "constraint d: a = time - 1 + abs(time - 1);"), 3.0, AT_3),
    Attack(
        "speed_by_a_place",
        model(
            "coordinate Real s, c(der(start = 1)); kinetic 1/2*der(s)^2 + 1/2*der(c)^2; "
            "constraint d: der(s) = if c < 0.5 then 1 else 3;"
        ),
        1.0,
        {"s": 2.0, "der(s)": 3.0, "c": 1.0},
    ),
    Attack(
        "two_on_a_rope_that_is_driven",
        # the speed of a + 2 b is given: the impulse 1 : 2 shares the jump of 5
        model(
            "coordinate Real a, b; kinetic 1/2*(der(a)^2 + der(b)^2); "
            "constraint d: der(a) + 2*der(b) = if time < 1 then 0 else 5;"
        ),
        2.0,
        {"a": 1.0, "b": 2.0, "der(a)": 1.0, "der(b)": 2.0},
    ),
    Attack(
        "state_follows_a_switched_rate",
        model(
            "coordinate Real s; state Real z; kinetic 1/2*der(s)^2; constraint d: der(s) = if time < 1 then 0 else 2;",
            "der(z) = der(s) - z;",
        ),
        3.0,
        {"z": 2 * (1 - exp(-2.0)), "s": 4.0},
    ),
    Attack(
        "speed_by_a_discrete",
        model(
            DRIVEN + "discrete Real v(start = 0); constraint d: der(a) = v;",
            "when sample(1, 50) then v = 2; end when;",
        ),
        3.0,
        AT_3,
    ),
]

LIBRARY = [
    Attack(
        "step_into_speed_source",
        """model Stepped
  import Lag.Rotational.*;
  import Lag.Blocks.Step;
  Step step(start = 1 s);
  SpeedSource source(w = step.y*(2 rad/s));
  Rotor driver(J = 1 kg.m2), load(J = 1 kg.m2);
  Spring shaft(k = 4 N.m/rad);
  connect(source.phi, driver.phi, shaft.phi_a);
  connect(shaft.phi_b, load.phi);
  output Angle seen = load.phi;
end Stepped;
""",
        3.0,
        {"seen": 4 - sin(4)},
    ),
    Attack(
        "step_into_translational_speed_source",
        """model Stepped
  import Lag.Translational.*;
  import Lag.Blocks.Step;
  Step step(start = 1 s);
  SpeedSource source(v = step.y*(2 m/s));
  Spring spring(k = 4 N/m);
  SlidingMass load(m = 1 kg);
  connect(source.s, spring.s_a);
  connect(spring.s_b, load.s);
  output Length seen = load.s;
end Stepped;
""",
        3.0,
        {"seen": 4 - sin(4)},
    ),
    Attack(
        "step_into_current_source",
        """model Stepped
  import Lag.Electrical.*;
  import Lag.Blocks.Step;
  Step step(start = 1 s);
  CurrentSource source(i = step.y*(2 A));
  Inductor L1(L = 0.5 H);
  Capacitor C1(C = 0.5 F);
  Ground ground;
  connect(source.n, L1.p, C1.p);
  connect(source.p, L1.n, C1.n, ground.p);
  output Voltage u = C1.p.v;
end Stepped;
""",
        3.0,
        # the inductor keeps its current: the capacitor takes the step; u = i sqrt(L/C) sin(t/sqrt(L C))
        {"u": 2.0 * sin(2.0 / 0.5)},
    ),
]


def _braked(m: float, c: float, g: float) -> float:
    """The rate along x at 2 s of what a brake holds along x from 0.3 s to 0.6 s, from 0.9 s to 1.2 s, and so on. A
    damper acts between the rates along x and y."""
    along, down, k = -1.1, -1.0, c / m
    for i in range(7):
        last = min(0.3, 2 - 0.3 * i)
        if i % 2:
            along, down = 0.0, -g / k + (down + g / k) * exp(-k * last)
        else:
            steady = g / (2 * k)
            both, apart = along + down - g * last, steady + (along - down - steady) * exp(-2 * k * last)
            along, down = (both + apart) / 2, (both - apart) / 2
    return along


# The brake leaves a rate of round-off, whose momentum is known to the round-off of the rate along y only.
SINE = asinh(-0.0578)
BRAKES = [
    Attack(
        f"brake_that_opens_{name}",
        model(
            "discrete Boolean held(start = false); constraint brake: (if held then der(x) else 0) = 0;"
            f"coordinate Real x(start = -0.0578, der(start = -1.1)){along} gravity = {{0, -9.81, 0}};"
            f"coordinate Real y(start = 0.2, der(start = -1)){down}"
            "mass 2.14 at {x, y}; dissipation 1/2*1.58*(der(x) - der(y))^2;",
            "when sample(0.3, 0.3) then held = not pre(held); end when;",
        ),
        2.0,
        {"der(x)": _braked(2.14, 1.58, 9.81)},
    )
    for name, along, down in (
        ("alone", ";", ";"),
        (
            "on_ways_of_others",
            f", u(start = {SINE!r}, der(start = {-1.1 / cosh(SINE)!r})); constraint ways: x = sinh(u);",
            ", v; constraint heights: sinh(v) - y = 0;",
        ),
    )
]


@rows([*CLUTCHES, *DRIVES, *LIBRARY, *BRAKES])
def test_switched_constraints(row: Attack, engine: str) -> None:
    check(row, engine)
