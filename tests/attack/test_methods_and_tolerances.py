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


@rows(TABLES)
def test_corners_with_coarse_tolerances(row: Attack, engine: str) -> None:
    check(row, engine)
