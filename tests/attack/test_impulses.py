"""Corners in prescribed motion, geometry and the Lagrangian are blows: the balance of momentum decides."""

from __future__ import annotations

from math import cos, sin, sqrt

from attack.rows import Attack, check, model, rows

# A slide of 1 carried by a base that starts to run at 1 s with the speed 1; the spring (9) is between slide and base.
# With x relative to the base: x' jumps by -1, then x = -sin(3 (t - 1))/3.
CARRIED = {"x": -sin(6) / 3, "der(x)": -cos(6)}
SPRING = "potential 1/2*9*x^2; coordinate Real x;"
RAMPS = {
    "max": "max(0, time - 1)",
    "if": "(if time < 1 then 0 else time - 1)",
    "if_turned": "(if time >= 1 then time - 1 else 0)",
    "abs": "(time - 1 + abs(time - 1))/2",
    "limit": "limit(time - 1, 0, 50)",
    "min": "-min(0, 1 - time)",
    "table": "table(time, {0, 1, 9}, {0, 0, 8})",
}

BASES = [
    *(
        Attack(
            f"kinetic_on_a_base_by_{n}", model(f"{SPRING} Real r = {r}; kinetic 1/2*(der(x) + der(r))^2;"), 3.0, CARRIED
        )
        for n, r in RAMPS.items()
    ),
    *(
        Attack(f"mass_on_a_base_by_{n}", model(f"{SPRING} gravity = 0; mass 1 at {{x + {r}, 0}};"), 3.0, CARRIED)
        for n, r in RAMPS.items()
    ),
    *(
        Attack(
            f"constraint_on_a_base_by_{n}",
            model(f"coordinate Real x, s; potential 1/2*9*x^2; kinetic 1/2*der(s)^2; constraint base: s - x = {r};"),
            3.0,
            CARRIED,
        )
        for n, r in RAMPS.items()
    ),
    Attack(
        "base_that_stops",
        model(f"{SPRING} gravity = 0; mass 1 at {{x + min(2*time, 2), 0}};"),
        3.0,
        # it starts with the speed 0 relative to the base; at the stop x' jumps by +2
        {"x": 2 * sin(6) / 3, "der(x)": 2 * cos(6)},
    ),
    Attack(
        "base_that_turns_back",
        model(f"{SPRING} gravity = 0; mass 1 at {{x - abs(time - 1), 0}};"),
        3.0,
        {"x": 2 * sin(6) / 3, "der(x)": 2 * cos(6)},
    ),
    Attack(
        "two_masses_on_a_base",
        # rods hold the second to the first: both jump
        model(
            "coordinate Real x, y; potential 1/2*9*(x - y)^2; gravity = 0; mass 1 at {x + max(0, time - 1), 0}; "
            "mass 1 at {y, 0};"
        ),
        3.0,
        # x jumps to -1; center of x and y moves at -1/2, the difference swings with sqrt(18)
        {"x": -1.0 - sin(sqrt(18) * 2) / (2 * sqrt(18)), "y": -1.0 + sin(sqrt(18) * 2) / (2 * sqrt(18))},
    ),
    Attack(
        "coupled_by_inertia",
        # M = [[2, 1], [1, 1]]: momentum is kept for both coordinates
        model(
            "coordinate Real x, y; kinetic 1/2*(der(x) + der(r))^2 + 1/2*(der(x) + der(y))^2; "
            "Real r = max(0, time - 1);"
        ),
        3.0,
        {"der(x)": -1.0, "der(y)": 1.0, "x": -2.0, "y": 2.0},
    ),
    Attack(
        "arm_on_a_base",
        # pendulum without gravity across the motion of its pivot: the mass stays, the angle takes -r'/l and keeps it
        model("coordinate Real a; gravity = 0; mass 2 at {max(0, 3*(time - 1)) + 0.5*sin(a), 0.5*cos(a)};"),
        2.0,
        {"a": -6.0, "der(a)": -6.0},
    ),
    Attack(
        "turned_base",
        # a slide on an arm that starts to turn at 2 rad/s: r'' = 4 r
        model(
            "coordinate Real s(start = 1); gravity = 0; frame A = world.rotz(max(0, 2*(time - 1))); "
            "mass 1 at A.point({s, 0, 0});"
        ),
        2.0,
        {"s": (2.718281828459045**2 + 2.718281828459045**-2) / 2},
    ),
    Attack(
        "drive_of_a_slide",
        """model Driven
  import Lag.Planar.*;
  import Lag.Blocks.Ramp;
  Ramp way(start = 1 s, duration = 50 s, height = 50);
  PrismaticDrive shaker(way = way.y*(1 m));
  Prismatic slide(s(start = 0 m));
  Body block(m = 1 kg);
  potential 1/2*(9 N/m)*slide.s^2;
  gravity = 0;
  connect(world, shaker, slide, block);
end Driven;
""",
        3.0,
        {"slide.s": -sin(6) / 3},
    ),
    Attack(
        "drive_of_a_pin",
        # arm of 1 m on an arm that starts to turn at 2 rad/s, both straight
        """model Driven
  import Lag.Planar.*;
  import Lag.Blocks.Ramp;
  Ramp angle(start = 1 s, duration = 50 s, height = 100);
  RevoluteDrive motor(angle = angle.y*(1 rad));
  FixedTranslation arm(r = {1 m, 0});
  Revolute pin;
  Body block(m = 1 kg, com = {1 m, 0});
  gravity = 0;
  connect(world, motor, arm, pin, block);
end Driven;
""",
        1.0000001,
        # momentum about the pin: 1*(1 + 1)*2 + v = 0 for the speed 2 + (2 + v) of the block
        {"der(pin.q)": -4.0},
        near=1e-6,
    ),
    Attack(
        "ramp_as_place_of_a_spring",
        """model Moved
  import Lag.Translational.*;
  import Lag.Blocks.Ramp;
  Ramp way(start = 1 s, duration = 50 s, height = 50);
  PositionSource source(s_ref = way.y*(1 m));
  SlidingMass base(m = 3 kg), load(m = 1 kg);
  Spring spring(k = 9 N/m);
  connect(source.s, base.s, spring.s_a);
  connect(spring.s_b, load.s);
  output Length seen = load.s;
end Moved;
""",
        3.0,
        {"seen": 2 - sin(6) / 3},
    ),
]

MOMENTA = [
    Attack(
        "jump_of_a_generalized_momentum",
        model(
            "coordinate Real x(der(start = 3)); kinetic 1/2*der(x)^2; lagrangian (if time < 1 then 0 else 1)*der(x);"
        ),
        3.0,
        {"der(x)": 2.0, "x": 3 + 4.0},
        refused=("E0321",),
    ),
    Attack(
        "jump_of_a_magnetic_potential",
        # a term A(x) der(x) is a total derivative where A depends on x alone: nothing happens
        model("coordinate Real x(der(start = 3)); kinetic 1/2*der(x)^2; lagrangian max(0, x - 1)*der(x);"),
        3.0,
        {"der(x)": 3.0, "x": 9.0},
    ),
    Attack(
        "kinetic_energy_switched_in_time",
        # the momentum of a cyclic coordinate is kept: 1*4 = 2*2
        model("coordinate Real x(der(start = 4)); kinetic 1/2*(if time < 1 then 1 else 2)*der(x)^2;"),
        2.0,
        {"der(x)": 2.0, "x": 6.0},
    ),
    Attack(
        "kinetic_energy_that_grows_from_a_corner_on",
        # m = 1 + max(0, t - 1): momentum 4, x' = 4/t
        model("coordinate Real x(der(start = 4)); kinetic 1/2*(1 + max(0, time - 1))*der(x)^2;"),
        2.0,
        {"der(x)": 2.0, "x": 4 + 4 * 0.6931471805599453},
    ),
    Attack(
        "kinetic_energy_switched_in_place",
        # T is kept where the Lagrangian depends on x alone: energy, so x' = 4/sqrt(4); or the momentum: no answer is
        # an answer
        model("coordinate Real x(der(start = 4)); kinetic 1/2*(if x < 1 then 1 else 4)*der(x)^2;"),
        2.0,
        {"der(x)": 2.0},
        refused=("any",),
    ),
    Attack(
        "step_of_a_potential",
        model("coordinate Real x(der(start = 3)); kinetic 1/2*der(x)^2; potential if x < 1 then 0 else 2.5;"),
        2.0,
        {"der(x)": 2.0},
        refused=("any",),
    ),
    Attack(
        "step_of_a_potential_that_throws_back",
        model("coordinate Real x(der(start = 2)); kinetic 1/2*der(x)^2; potential if x < 1 then 0 else 2.5;"),
        2.0,
        {"der(x)": -2.0},
        refused=("any",),
    ),
    Attack(
        "corner_of_a_potential",
        model("coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2; potential 1/2*max(0, x - 1)*1;"),
        2.0,
        {"der(x)": 0.5, "x": 1.75},
    ),
    Attack(
        "track_with_a_corner",
        # the energy is kept
        model("coordinate Real x(start = -1, der(start = 1)); gravity = 0; mass 1 at {x, max(0, x)};"),
        2.0,
        {"der(x)": sqrt(0.5)},
    ),
    Attack(
        "track_with_a_corner_by_a_constraint",
        model(
            "coordinate Real x(start = -1, der(start = 1)), y; kinetic 1/2*(der(x)^2 + der(y)^2); "
            "constraint track: y = max(0, x);"
        ),
        2.0,
        {"der(x)": sqrt(0.5), "der(y)": sqrt(0.5)},
    ),
    Attack(
        "track_of_an_abs",
        # from the slope -1 to +1 with the same speed along
        model(
            "coordinate Real x(start = -1, der(start = 1)), y(start = 1, der(start = -1)); "
            "kinetic 1/2*(der(x)^2 + der(y)^2); constraint track: y = abs(x);"
        ),
        2.0,
        {"der(x)": 1.0, "x": 1.0},
    ),
    Attack(
        "discrete_mass",
        # the momentum is kept: 2*4.5 = 1*9 at 1 s
        model(
            "coordinate Real x(der(start = 4)); discrete Real m(start = 2); kinetic 1/2*m*der(x)^2; force 1 on x;",
            "when time > 1 then m = 1; end when;",
        ),
        2.0,
        {"der(x)": 10.0},
    ),
]

# A mass of 3 enters a coil: the flux is kept where the inductance falls, the energy too. Three coils between two nodes:
# the flux of each changes by the same impulse of the voltage, and their currents stay zero in sum.
COIL = "coordinate Real q(der(start = 1.5)), x(der(start = 2)); kinetic 1/2*{}*der(q)^2 + 3/2*der(x)^2; "
IN_COIL = {"der(q)": 1.5 * 2 / 1.2, "der(x)": sqrt(4 + (2 * 1.5**2 - 1.2 * 2.5**2) / 3)}
SURGE = -(2 * 1 / 0.7 - 0.6 - 0.4) / (1 / 0.7 + 1 + 1 / 3)

FLUXES = [
    Attack("coil_by_if", model(COIL.format("(if x < 1 then 2 else 1.2)")), 1.0, IN_COIL),
    Attack("coil_by_floor", model(COIL.format("(2 - 0.8*min(floor(max(x, 0)), 1))")), 1.0, IN_COIL),
    Attack(
        "coil_by_a_clause",
        # the clause knows the time only: the energy is not kept
        model(COIL.format("L") + "discrete Real L(start = 2);", "when x >= 1 then L = 1.2; end when;"),
        1.0,
        {"der(q)": 2.5, "der(x)": 2.0},
    ),
    Attack(
        "three_coils",
        """model Coil
  extends Lag.Electrical.OnePort;
  kinetic 1/2*(if time < 1 s then 2 H else 0.7 H)*der(q)^2;
end Coil;

model Parallel
  import Lag.Electrical.*;
  Coil a(q(der(start = 1 A)));
  Inductor b(L = 1 H, q(der(start = -0.6 A))), c(L = 3 H, q(der(start = -0.4 A)));
  Ground g;
  connect(a.p, b.p, c.p);
  connect(a.n, b.n, c.n, g.p);
  output Current i[3] = {der(a.q), der(b.q), der(c.q)};
end Parallel;
""",
        2.0,
        {"i[1]": (2 + SURGE) / 0.7, "i[2]": -0.6 + SURGE, "i[3]": (-1.2 + SURGE) / 3},
    ),
]


@rows([*BASES, *MOMENTA, *FLUXES])
def test_impulses(row: Attack, engine: str) -> None:
    check(row, engine)
