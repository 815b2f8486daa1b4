"""Events and corners with coarse tolerances, and with the implicit method, which makes long steps."""

from __future__ import annotations

from math import sqrt

from attack.rows import Attack, check, model, rows

# Teeth of a table, each with the area 1/2 in all: 4 + 2*0.5 is left of the square of 2.
TABLE = "coordinate Real x(der(start = 2)); kinetic 1/2*der(x)^2; force table(x, {{{}}}, {{{}}}) on x;"


def teeth(width: float, count: int) -> str:
    places, values = [0.0], [0.0]
    for k in range(count):
        places += [3 + 0.1 * k + part * width for part in range(3)]
        values += [0.0, 0.5 / width / count, 0.0]
    return model(TABLE.format(*(", ".join(map(repr, [*each, end])) for each, end in ((places, 20.0), (values, 0.0)))))


TABLES = [
    Attack(
        f"{count}_teeth_of_{width:g}_at_{tolerance:g}",
        teeth(width, count),
        4.0,
        {"der(x)": sqrt(5)},
        tolerance=tolerance,
        near=1e-8,
    )
    for width, count, tolerance in ((1e-3, 1, 1e-3), (1e-3, 1, 1e-6), (1e-2, 3, 1e-3), (1e-5, 3, 1e-6))
]

TURNING = "coordinate Real phi(der(start = 1)); kinetic 1/2*der(phi)^2; discrete Integer n(start = 0);"
SWINGS = "coordinate Real x; kinetic 1/2*der(x)^2; force cos(time) on x; discrete Integer n(start = 0);"


def counter(name: str, condition: str, count: int, tolerance: float, solver: str, body: str = TURNING) -> Attack:
    clause = f"when {condition} then n = pre(n) + 1; end when;"
    stop = 100.0 if body == TURNING else 20.0
    return Attack(name, model(body, clause), stop, {"n": count}, tolerance=tolerance, solver=solver)


COUNTERS = [
    # the event is at a jump, behind which the value is small
    counter("behind_a_jump", "mod(phi, 6.25) < 1e-6", 16, 1e-6, "auto"),
    counter("behind_a_jump_exactly", "mod(phi, 6.25) < 3e-7", 16, 1e-12, "auto"),
    counter("behind_a_jump_by_radau", "mod(phi, 6.25) < 1e-7", 16, 1e-6, "radau"),
    counter("beside_a_floor", "floor(phi/6.25)*6.25 > phi - 1e-6", 16, 1e-8, "auto"),
    # steps that are cut to a quarter at a corner, and to less
    counter("needle_of_each_turn", "abs(mod(phi, 6.25) - 3) < 1e-7", 16, 1e-6, "auto"),
    counter("needle_of_each_turn_by_radau", "abs(mod(phi, 6.25) - 3) < 1e-9", 16, 1e-6, "radau"),
    # above 1/2 four times
    counter("limit_by_radau", "limit(2*der(x), -1, 1) >= 1", 4, 1e-6, "radau", SWINGS),
    counter("max_by_radau", "max(0.5 - der(x), 0) <= 0", 4, 1e-4, "radau", SWINGS),
]

# A corner at a place at which its own distance jumps: all have the area 5 where the floor is one number.
JUMPS = [
    Attack(
        f"{name}_of_floor_{size:g}",
        model(f"coordinate Real x(der(start = 2)); kinetic 1/2*der(x)^2; force {5 * size}*{force} on x;"),
        stop,
        {"der(x)": sqrt(14)},
        tolerance=tolerance,
    )
    for name, size, force, stop, tolerance in (
        ("distance", 1.0, "max(0, 1 - abs(floor(x) - 1))", 2.5, 1e-9),
        ("limit", 1.0, "(1 - abs(limit(floor(x) - 1, -1, 1)))", 2.5, 1e-6),
        ("square", 10.0, "max(0, 1 - (floor(10*x) - 10)^2)", 2.5, 1e-8),
    )
]


@rows([*TABLES, *JUMPS])
def test_corners_with_coarse_tolerances(row: Attack, engine: str) -> None:
    check(row, engine)


@rows(COUNTERS)
def test_events_by_other_methods(row: Attack, engine: str) -> None:
    check(row, engine)
