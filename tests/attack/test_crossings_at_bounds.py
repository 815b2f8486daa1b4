"""Crossings within rounding of a stop, a tick, a row of an input, another crossing."""

from __future__ import annotations

from attack.rows import Attack, check, model, rows

# x = time, exactly in mathematics
CLOCK = "coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2;"
COUNT = "when x > 2 then n = pre(n) + 1; end when;"


def crossing(name: str, clauses: str, stop: float, ends: dict[str, float], body: str = "", **more: object) -> Attack:
    counted = "".join(f"discrete Integer {name}(start = 0);" for name in "kmn" if f" {name} = pre" in clauses)
    return Attack(name, model(CLOCK + counted + body, clauses), stop, ends, **more)  # type: ignore[arg-type]


TICKS = "when sample(0, {}) then k = pre(k) + 1; end when;"

# A relation that is zero at the start and true a moment later becomes true at the start.
BOUNDS = [
    crossing("crossing_at_a_tick", COUNT + TICKS.format(0.5), 4.2, {"n": 1, "k": 9}),
    crossing(
        "crossing_at_a_tick_of_tenths",
        "when x > 0.7 then n = pre(n) + 1; end when;" + TICKS.format(0.1),
        1.05,
        {"n": 1, "k": 11},
    ),
    crossing(
        "crossings_at_all_ticks",
        "when sin(3.141592653589793*x) > 0 then n = pre(n) + 1; end when;" + TICKS.format(1),
        6.5,
        {"n": 4, "k": 7},
    ),
    crossing(
        "crossings_at_ticks_down",
        "when sin(3.141592653589793*x) < 0 then n = pre(n) + 1; end when;" + TICKS.format(0.5),
        6.25,
        {"n": 3, "k": 13},
    ),
    crossing(
        "not_strict_at_a_tick", "when x >= 2 then n = pre(n) + 1; end when;" + TICKS.format(1), 4.2, {"n": 1, "k": 5}
    ),
    crossing(
        "falling_at_a_tick", "when -x < -2 then n = pre(n) + 1; end when;" + TICKS.format(1), 4.2, {"n": 1, "k": 5}
    ),
    crossing("time_and_place_at_once", COUNT + "when time > 2 then k = pre(k) + 1; end when;", 4.2, {"n": 1, "k": 1}),
    crossing("both_at_once", "when x > 2 and time > 2 then n = pre(n) + 1; end when;", 4.2, {"n": 1}),
    crossing("either_at_once", "when {x > 2, time >= 2} then n = pre(n) + 1; end when;", 4.2, {"n": 1}),
    crossing(
        "two_relations_of_one_place", COUNT + "when 3*x >= 6 then k = pre(k) + 1; end when;", 4.2, {"n": 1, "k": 1}
    ),
    crossing(
        "two_clocks_and_a_crossing",
        COUNT + TICKS.format(1) + "when sample(2, 3) then m = pre(m) + 1; end when;",
        4.2,
        {"n": 1, "k": 5, "m": 1},
    ),
    crossing(
        "rows_of_an_input_at_it",
        COUNT,
        4.2,
        {"n": 1, "der(y)": 2.2},
        "input Real u; coordinate Real y; kinetic 1/2*der(y)^2; force u on y;",
        inputs={"u": ((0.0, 2.0, 2.0, 9.0), (0.0, 0.0, 1.0, 1.0))},
    ),
    crossing(
        "crossing_back_at_the_next_tick",
        "when abs(x - 2.5) < 0.5 then n = pre(n) + 1; end when;" + TICKS.format(0.5),
        4.2,
        {"n": 1, "k": 9},
    ),
    crossing(
        "reset_at_a_tick",
        "when x > 2 then reinit(der(x), -1); n = pre(n) + 1; end when;" + TICKS.format(0.5),
        5.2,
        {"n": 1, "k": 11, "x": -1.2},
    ),
    crossing(
        "impact_at_a_tick",
        TICKS.format(0.5),
        5.2,
        {"k": 11, "x": -1.2},
        "contact c: x <= 2 with restitution = 1;",
        counts={("c", "impact"): 1},
    ),
    crossing(
        "force_from_a_tick_on",
        TICKS.format(0.5),
        4.0,
        {"x": 4 + 2.0, "der(x)": 3.0},
        "force (if time >= 2 then 1 else 0) on x;",
    ),
    crossing("far_times", "when x > 12 then n = pre(n) + 1; end when;" + TICKS.format(0.1), 20.05, {"n": 1, "k": 201}),
    crossing(
        "many_crossings_at_many_ticks",
        "when sin(31.41592653589793*x) > 0 then n = pre(n) + 1; end when;" + TICKS.format(0.1),
        20.05,
        {"n": 101, "k": 201},
    ),
]


# Rounding decides if a crossing at the stop is reached, but not what came before; and nothing happens twice.
AT_THE_STOP = [
    crossing(
        f"stop_at_{relation.format(stop).replace(' ', '')}",
        f"when {relation.format(stop)} then n = pre(n) + 1; end when;"
        f"when {relation.format(stop / 2)} then m = pre(m) + 1; end when;",
        stop,
        {"m": 1.0, "x": stop, "twice": 0.0},
        "output Real twice = if n > 1.5 then 1 else 0;",
    )
    for relation in ("x > {}", "x >= {}", "time > {}", "time >= {}", "-x < -{}", "x*x - {0}*{0} > 0")
    for stop in (4.0, 0.7)
]

# The last tick is at the stop: it ticks, once.
TICK_AT_THE_STOP = [
    crossing(f"tick_{count}_of_{period}_at_the_stop", TICKS.format(period), count * period, {"k": count + 1.0})
    for period, count in ((0.1, 14), (0.1, 3), (0.7, 7), (1.0, 7), (0.0625, 7))
]


@rows([*BOUNDS, *AT_THE_STOP, *TICK_AT_THE_STOP])
def test_crossings_at_bounds(row: Attack, engine: str) -> None:
    check(row, engine)
