"""Units with an offset, zeros, and whole numbers: what a literal means wherever it may stand."""

from __future__ import annotations

import pytest
from choice import together
from flattening import run, said

from lagdsl.language.flat import model as fm
from lagdsl.language.flat.evaluate import Evaluator, Values

BODY = "coordinate Angle x; kinetic (1 J.s2)*der(x)^2;"


def flat_of(text: str) -> fm.FlatModel:
    flat, sink = run(f"model M {BODY} parameter Temperature T = 20 degC; {text} end M;")
    assert flat is not None, [(d.code, d.message, d.labels[0].span.text) for d in sink.diagnostics]
    return flat


def outputs(text: str) -> list[float]:
    flat = flat_of(text)
    still = Evaluator(flat, Values(variables={"x": 0.75, "time": 3.0}))
    return [still.scalar(item.value) for item in flat.outputs]


def errors(text: str) -> list[tuple[str, str]]:
    _, sink = run(f"model M {BODY} parameter Temperature T = 20 degC; {text} end M;")
    return [(code, place) for code, place in said(sink) if code.startswith("E")]


@together(
    ("expression", "kelvin"),
    [
        ("-5 degC", 268.15),
        ("+5 degC", 278.15),
        ("-0 degC", 273.15),
        ("-40.5 degC", 232.65),
        ("(-5 degC)", 268.15),
        ("- 5 degC", 268.15),
        ("if x > 0 then -5 degC else -6 degC", 268.15),
        ("max(-5 degC, -6 degC)", 268.15),
        ("limit(T, -5 degC, -1 degC)", 272.15),
        ("table(x, {0, 1}, {-5 degC, 15 degC})", 283.15),
        ("-5 degC + 5 K", 273.15),
        ("T - -5 degC", 25.0),
        ("T - 20 degC", 0.0),
        ("20 degC - 5 degC", 15.0),
        ("abs(-5 degC)", 268.15),
        ("min(T, 0 degC)", 273.15),
    ],
)
def test_a_temperature_with_its_sign(expression: str, kelvin: float) -> None:
    assert outputs(f'output Real y(unit = "K") = {expression};') == pytest.approx([kelvin], abs=1e-12)


def test_starts_and_limits_of_temperatures() -> None:
    flat = flat_of(
        'parameter Temperature a(min = -50 degC, max = -1 degC) = -5 degC; parameter Real b(unit = "K") = -5 degC;'
        "state Temperature s(start = -10 degC, nominal = 100 K); equation der(s) = (-5 degC - s)/(1 s);"
    )
    found = {item.name: item for item in flat.parameters}
    assert found["a"].value == 268.15 and found["b"].value == 268.15
    assert (found["a"].minimum, found["a"].maximum) == (223.15, 272.15)
    still = Evaluator(flat, Values())
    assert still.scalar(flat.states[0].start) == 263.15
    assert still.scalar(flat.states[0].derivative) == pytest.approx(268.15)


@together(
    ("text", "literal"),
    [
        ("output Temperature y = T + 5 degC;", "5 degC"),
        ("output Temperature y = T + -5 degC;", "-5 degC"),
        ("output Temperature y = 2*(20 degC);", "20 degC"),
        ("output Temperature y = 20 degC*2;", "20 degC"),
        ("output Temperature y = -20 degC/2;", "-20 degC"),
        ('output Real y(unit = "K2") = (5 degC)^2;', "5 degC"),
        ("output Temperature y = -(5 degC);", "5 degC"),
        ("output Temperature y = - -5 degC;", "-5 degC"),
        ("output Temperature y = -(if x > 0 then 5 degC else T);", "5 degC"),
        ("output Temperature y[2] = 2*{5 degC, 6 degC};", "5 degC"),
        ("output Temperature y = sum({5 degC, 6 degC});", "5 degC"),
        ("output Temperature y = sum(5 degC for i in 1:2);", "5 degC"),
        ("output Temperature y = mod(T, 5 degC);", "5 degC"),
        ("parameter TemperatureDifference d = 5 degC;", "5 degC"),
        ("parameter TemperatureDifference d(max = 5 degC) = 1 K;", "5 degC"),
        ("type Rise = TemperatureDifference; parameter Rise d = -5 degC;", "-5 degC"),
        ("state TemperatureDifference d(start = 5 degC); equation der(d) = 0;", "5 degC"),
    ],
)
def test_an_amount_is_no_point_on_a_scale(text: str, literal: str) -> None:
    assert errors(text) == [("E0418", literal)]


def test_products_of_units_have_no_offset() -> None:
    found = outputs(
        'output Real a(unit = "K/s") = -5 degC/s; output Real b(unit = "W/K") = 2*(3 W/degC);'
        'output Real c(unit = "K2") = -5 degC^2;'
    )
    assert found == [-5.0, 6.0, -5.0]


# ---- zeros -----------------------------------------------------------------------------------------------------------


@together(
    ("expression", "value"),
    [
        ("0*time/(1 s) + 1", 1.0),
        ("time*0/(1 s) + 1", 1.0),
        ("1 + 0*x", 1.0),
        ("0*(3 m)/(2 m) + x", 0.75),
        ("x + 0/(1 /s)*(2 /s)", 0.75),
        ("(0*time + time)/(1 s)", 3.0),
        ("(0 + time)/(1 s)", 3.0),
        ("(if x > 1 then time else 0)/(1 s) + 2", 2.0),
        ("sum(i*(1 m) for i in 0:2)/(1 m)", 3.0),
        ("((0 + 3 N) + sum((1 N)*i for i in 1:0))/(1 N)", 3.0),
        ("((1 N/m)*sum(1 m for i in 1:0)*2 + 3 J/m)/(1 N) + 0", 3.0),
        ("(sum(1 m for i in 1:0)/(2 s) + 3 m/s)/(1 m/s)", 3.0),
        ("(-sum(1 m for i in 1:0)*(2 N) + 3 J)/(1 J)", 3.0),
        ("({0, 0}*(1 m)*{1, 1} + 2 m)/(1 m)", 2.0),
    ],
)
def test_zero_has_its_dimension_in_products(expression: str, value: float) -> None:
    assert outputs(f"output Real y = {expression};") == pytest.approx([value])


@pytest.mark.parametrize(
    "expression",
    ["0*time + 1", "0*(1 kg) + 1 m", "time + 0*x", "0*time/(1 m) + 1", "sum(i*(1 m) for i in 0:0) + 1 s",
     "if x > 0 then 0*time else 1"],
)  # fmt: skip
def test_a_product_with_zero_is_not_of_any_dimension(expression: str) -> None:
    codes = [code for code, _ in errors(f"output Real y = ({expression})/({expression});")]
    assert codes and set(codes) <= {"E0401", "E0405"}


@pytest.mark.parametrize("loop", ["0:0", "1:1"])
def test_the_value_of_an_index_does_not_change_what_is_accepted(loop: str) -> None:
    assert [code for code, _ in errors(f"output Length y = sum(i + 1 m for i in {loop});")] == ["E0401"]


# ---- whole numbers ---------------------------------------------------------------------------------------------------


@together(
    ("expression", "value"),
    [
        ("mod(7, 3)", 1),
        ("mod(n, 2)", 1),
        ("abs(-n)", 5),
        ("sign(-n)", -1),
        ("min(n, 3)", 3),
        ("max({n, 3, 9})", 9),
        ("limit(n, 1, 4)", 4),
        ("sum({n, 3})", 8),
        ("sum(i for i in 1:n)", 15),
        ("sum(i for i in 1:0)", 0),
        ("product(i for i in 1:4)", 24),
        ("product({n, 2})", 10),
        ("product(i for i in 1:0)", 1),
        ("{n, 2}*{1, 2}", 9),
        ("ones(2)*{n, 2}", 7),
        ("zeros(2)*{n, 2} + 1", 1),
        ("(identity(2)*{n, 2})*{1, 0}", 5),
        ("({n, 2} .* {1, 3})*{1, 1}", 11),
        ("fill(n, 3)*{1, 1, 1}", 15),
        ("size({n, n, n}, 1)", 3),
        ("0*n", 0),
        ("if n > 3 then mod(n, 3) else -n", 2),
        ("noEvent(abs(n))", 5),
        ("-sum(i for i in 1:0)", 0),
    ],
)
def test_functions_of_integers_are_integers(expression: str, value: int) -> None:
    assert outputs(f"structural parameter Integer n = 5; output Integer y = {expression};") == [value]


@pytest.mark.parametrize(
    "expression",
    ["mod(7, 2.5)", "7/2", "abs(x)", "sqrt(4)", "n^2", "min(n, 2.5)", "product({n, 0.5})", "limit(n, 0, x)"],
)
def test_reals_are_no_integers(expression: str) -> None:
    found = errors(f"structural parameter Integer n = 5; output Integer y = {expression};")
    assert [code for code, _ in found] == ["E0334"]


@together(
    ("expression", "place"),
    [
        ("sum({true, false})", "{true, false}"),
        ("product({b, true})", "{b, true}"),
        ("sum(b for i in 1:2)", "b"),
        ("max(b, 1)", "b"),
        ("min(1, b)", "b"),
        ("abs(b)", "b"),
        ("mod(b, 2)", "b"),
        ("limit(b, 0, 1)", "b"),
        ("sign(b)", "b"),
        ("b*2", "b"),
        ("-b", "b"),
    ],
)
def test_truths_are_no_numbers(expression: str, place: str) -> None:
    assert errors(f"parameter Boolean b = true; output Real y = {expression};") == [("E0312", place)]


# ---- rows of constraints ---------------------------------------------------------------------------------------------

ROWS = "coordinate Length u, v; kinetic (1 kg)*(der(u)^2 + der(v)^2); constraint roll: {u, v} = {0, 0};" \
    "constraint one: x = 0; for i in 1:2 loop constraint c: i*{u, v} = {0, 0}; end for;"  # fmt: skip


@pytest.mark.parametrize(
    ("argument", "rows"),
    [("roll[1]", ["roll[1]"]), ("roll[2]", ["roll[2]"]), ("roll[1:2]", ["roll[1]", "roll[2]"]),
     ("c[2, 1]", ["c[2,1]"]), ("c[1, :]", ["c[1,1]", "c[1,2]"]), ("c[2]", ["c[2,1]", "c[2,2]"])],
)  # fmt: skip
def test_the_multiplier_of_one_row(argument: str, rows: list[str]) -> None:
    size = f"[{len(rows)}]" if len(rows) > 1 else ""
    flat = flat_of(f"{ROWS} output Force f{size} = multiplier({argument});")
    assert [item.value.row for item in flat.outputs] == rows  # type: ignore[union-attr]


@pytest.mark.parametrize(
    ("argument", "code"), [("roll[3]", "E0316"), ("one[1]", "E0312"), ("roll[1, 1]", "E0341"), ("c[3, 1]", "E0316")]
)
def test_rows_that_are_not_there(argument: str, code: str) -> None:
    assert [found for found, _ in errors(f"{ROWS} output Force f = multiplier({argument});")] == [code]
