"""Tables of smooth inputs keep the shape of their rows; a signed number and a unit with an offset are one literal;
equations of the start leave what is not related to them to the rule of least kinetic energy; whole numbers hold."""

from __future__ import annotations

import pytest
from attack.rows import FIRST, Attack, check, model, rows

import lagdsl

Table = tuple[tuple[float, ...], tuple[float, ...]]

TURNED = "coordinate Real a; input Real w(smooth = 1); kinetic 1/2*der(a)^2; constraint drive: der(a) = w;"
MOVED = "coordinate Real a; input Real s(smooth = 2); kinetic 1/2*der(a)^2; constraint drive: a = s;"


def turned(name: str, table: Table, angle: float, stop: float, speed: float) -> Attack:
    """A disc at the speed of a table, in straight lines: the angle is the area below them."""
    return Attack(name, model(TURNED), stop, {"a": angle, "der(a)": speed}, inputs={"w": table})


def moved(name: str, table: Table, ends: dict[str, float], stop: float, body: str = "", clauses: str = "") -> Attack:
    return Attack(name, model(MOVED + body, clauses), stop, ends, inputs={"s": table})


STAIR = ((0.0, 1.0, 2.0, 3.0), (0.0, 0.0, 1.0, 1.0))

# With slopes of zero at both ends of a piece of length one the cubic is 3 r^2 - 2 r^3, and never leaves the rows.
SMOOTH = [
    turned("speed_of_a_trapezoid", ((0.0, 1.0, 2.0, 3.0), (0.0, 1.0, 1.0, 0.0)), 2.0, 3.0, 0.0),
    turned("speed_of_a_triangle", ((0.0, 0.3, 1.0), (0.0, 2.0, 0.0)), 1.0, 1.0, 0.0),
    turned("speed_that_turns_back", ((0.0, 1.0, 3.0), (1.0, 0.0, -2.0)), 0.0, 2.0, -1.0),
    turned("speed_of_uneven_rows", ((0.0, 1e-3, 1.0, 4.0), (0.0, 5.0, 5.0, 0.0)), 5 * 0.9995 + 7.5, 4.0, 0.0),
    turned("speed_that_is_constant", ((0.0, 9.0), (0.7, 0.7)), 1.4, 2.0, 0.7),
    moved("middle_of_a_stair", STAIR, {"a": 0.5, "der(a)": 1.5}, 1.5),
    moved("quarter_of_a_stair", STAIR, {"a": 3 / 16 - 2 / 64, "der(a)": 6 / 4 - 6 / 16}, 1.25),
    moved("stair_at_its_rows", STAIR, {"a": 1.0, "der(a)": 0.0}, 2.5),
    moved(
        "stair_never_beyond_its_rows",
        STAIR,
        {"over": 0.0, "under": 0.0},
        3.0,
        "state Real over, under;",
        "der(over) = max(0, a - 1); der(under) = max(0, -a);",
    ),
    moved("straight_rows", ((0.0, 0.5, 2.0, 3.0), (1.0, 2.0, 5.0, 7.0)), {"a": 3.6, "der(a)": 2.0}, 1.3),
    Attack(
        "row_that_stands_twice_for_another_column",
        model(TURNED + "input Real u; coordinate Real y; kinetic 1/2*der(y)^2; force u on y;"),
        2.0,
        {"a": 1.5, "der(y)": 3.0},
        inputs={"w": ((0.0, 1.0, 1.0, 2.0), (0.0, 1.0, 1.0, 1.0)), "u": ((0.0, 1.0, 1.0, 2.0), (0.0, 0.0, 3.0, 3.0))},
    ),
]

HEATED = "model Attacked {} state Real z; equation der(z) = ({})/(1 K.s); end Attacked;"


def heated(name: str, value: str, kelvin: float, items: str = "", **more: object) -> Attack:
    """The temperature in kelvin is the slope of a state."""
    return Attack(name, HEATED.format(items, value), 1.0, {"z": kelvin}, **more)  # type: ignore[arg-type]


POINTS = [
    heated("minus_celsius", "T", 268.15, "parameter Temperature T = -5 degC;"),
    heated("plus_celsius", "T", 278.15, "parameter Temperature T = +5 degC;"),
    heated("minus_celsius_of_a_real", "T", 268.15, 'parameter Real T(unit = "K") = -5 degC;'),
    heated("zero_celsius", "T", 273.15, "parameter Temperature T = 0 degC;"),
    heated("minus_zero_celsius", "T", 273.15, "parameter Temperature T = -0.0 degC;"),
    heated("celsius_and_an_amount", "T", 298.15, "parameter Temperature T = 20 degC + 5 K;"),
    heated("difference_of_points", "T - -5 degC", 25.0, "parameter Temperature T = 20 degC;"),
    heated("compared_with_a_point", "if T > -5 degC then 1 K else 2 K", 1.0, "parameter Temperature T = 268.2 K;"),
    heated("given_in_kelvin", "T", 250.0, "parameter Temperature T = -5 degC;", parameters={"T": 250.0}),
    heated("table_of_points", "table(time, {0 s, 1 s}, {-10 degC, 10 degC})", 273.15),
]

WRONG_POINTS = [
    "2*(-5 degC)",
    "-5 degC + 20 degC",
    "-(5 degC)",
    "5 K + -5 degC",
    "-5 degC*3",
]

PAIR = "coordinate Real c, d; kinetic 1/2*der(c)^2 + 1/2*5*der(d)^2; constraint sum: der(c) + der(d) = 1;"


def started(name: str, items: str, equations: str, ends: dict[str, float], lasting: str = "") -> Attack:
    section = f"equation {lasting}" if lasting else ""
    text = f'model Attacked {items} annotation(units = "none"); initial equation {equations} {section} end Attacked;'
    return Attack(name, text, 1.0, ends)


LEAST = {"der(c)": 5 / 6, "der(d)": 1 / 6}
STARTS = [
    started(
        "beside_a_state",
        PAIR + "state Real z; coordinate Real x; kinetic 1/2*der(x)^2;",
        "z = 3;",
        LEAST,
        "der(z) = 0;",
    ),
    started(
        "beside_a_rate_that_follows_from_a_square",
        PAIR + "coordinate Real x(der(start = 1)); kinetic 1/2*der(x)^2;",
        "der(x)^2 = 4;",
        LEAST | {"der(x)": 2.0},
    ),
    started(
        "beside_two_that_are_related",
        PAIR + "coordinate Real x, y; kinetic 1/2*der(x)^2 + 1/2*der(y)^2;",
        "der(x) = 2; x + y = 4; der(x) + der(y) = 5;",
        LEAST | {"der(x)": 2.0, "der(y)": 3.0},
    ),
    started(
        "beside_a_pair_of_its_own",
        PAIR + "coordinate Real x, y; kinetic 1/2*der(x)^2 + 1/2*3*der(y)^2; constraint other: der(x) + der(y) = 4;",
        "der(x) = 3;",
        LEAST | {"der(x)": 3.0, "der(y)": 1.0},
    ),
    started("that_names_one_of_the_pair", PAIR, "der(c) = 0.25;", {"der(c)": 0.25, "der(d)": 0.75}),
]

HELD = "coordinate Real x; input Integer g; kinetic 1/2*der(x)^2; force {} on x;"
WHOLE = [
    Attack(
        "integer_input_in_a_product",
        model(HELD.format("2*g")),
        2.0,
        {"der(x)": 2 * (1 * 0.5 + 4 * 1.5)},
        inputs={"g": ((0.0, 0.5, 9.0), (1, 4, 4))},
    ),
    Attack(
        "integer_input_that_chooses",
        model(HELD.format("(if g == 2 then 1 else 0)")),
        4.0,
        {"der(x)": 1.0},
        inputs={"g": ((0.0, 1.0, 2.0, 9.0), (0, 2, 5, 5))},
    ),
    Attack(
        "remainder_of_an_input",
        model(HELD.format("mod(g, 4)")),
        3.0,
        {"der(x)": 3 + 0 + 3.0},
        inputs={"g": ((0.0, 1.0, 2.0, 9.0), (7, 8, -1, -1))},
    ),
    Attack(
        "zero_in_a_sum_of_products",
        "model Attacked coordinate Length x; kinetic 1/2*(1 kg)*der(x)^2;"
        "force (time*0/(1 s) + 0*x/(1 m) + 2)*(1 N) on x; end Attacked;",
        2.0,
        {"der(x)": 4.0},
    ),
]


@rows([*SMOOTH, *POINTS, *STARTS, *WHOLE])
def test_shapes_points_starts_and_whole_numbers(row: Attack, engine: str) -> None:
    check(row, engine)


@pytest.mark.parametrize("value", WRONG_POINTS)
def test_points_are_not_amounts(value: str) -> None:
    row = heated("wrong", "T", 0.0, f"parameter Temperature T = {value};", refused=("E0418", "W0328"))
    check(row, FIRST)


PLACED = (
    "model M parameter Temperature T = 25 degC, U = 5 degC; {} state Real z; "
    "equation der(z) = value({}, {})/(1 s); end M;"
)
DIFFERENCE = "parameter TemperatureDifference d[2] = {1 K, 20 K};"
REST = 'parameter Real rest(unit = "K") = 20;'


@pytest.mark.parametrize("value", ["T - U", "(T - 20 degC)", "T - -5 degC", "d[2]"])
def test_a_difference_has_no_place_on_a_scale(value: str) -> None:
    """`value(d, "degC")` of 20 K was -253.15."""
    with pytest.raises(lagdsl.CompilationFailed) as failure:
        lagdsl.compile(PLACED.format(DIFFERENCE, value, '"degC"'))
    assert [each.code for each in failure.value.diagnostics] == ["E0415"]


@pytest.mark.parametrize(
    ("items", "value", "unit", "number"),
    [
        ("", "T - 20 K", "degC", 5.0),
        (DIFFERENCE, "T - d[2]", "degC", 5.0),
        (REST, "T - rest", "degC", 5.0),
        ("", "T - U", "K", 20.0),
        ("", "T", "degC", 25.0),
    ],
)
def test_numbers_of_temperatures(items: str, value: str, unit: str, number: float) -> None:
    check(Attack(value, PLACED.format(items, value, f'"{unit}"'), 1.0, {"z": number}), FIRST)


@pytest.mark.parametrize(
    "text",
    [
        'model M output TemperatureDifference d(displayUnit = "degC") = 5 K; end M;',
        'type D = TemperatureDifference(displayUnit = "degC"); model M output D d = 5 K; end M;',
    ],
)
def test_a_difference_is_not_shown_on_a_scale(text: str) -> None:
    """5 K were shown as -268.15 degC."""
    with pytest.raises(lagdsl.CompilationFailed) as failure:
        lagdsl.compile(text)
    assert [each.code for each in failure.value.diagnostics] == ["E0410"]


def test_a_jump_of_a_position_has_no_derivative() -> None:
    jump = ((0.0, 1.0, 1.0, 2.0), (0.0, 0.0, 1.0, 1.0))
    check(Attack("jump", model(MOVED), 2.0, {"a": -1.0}, inputs={"s": jump}, refused=("E0847",)), FIRST)
