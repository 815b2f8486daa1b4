"""Modifiers reach what they name and nothing else; what is said twice or of nothing is an error."""

from __future__ import annotations

import pytest
from flattening import run

from lagdsl.language.flat import model as fm

SLIDER = """
model Slider
  parameter Mass m = 1 kg;
  coordinate Length x;
  kinetic 1/2*m*der(x)^2;
end Slider;
model Row
  Slider s[2];
end Row;
"""
CART = """
model Soft
  input Length s;
  parameter Stiffness k = 10 N/m;
  potential 1/2*k*s^2;
end Soft;
model Hard
  input Length s;
  parameter Stiffness k = 20 N/m;
  parameter Real b = 2;
  potential 1/2*k*s^2 + 1/4*b*(1 N/m3)*s^4;
end Hard;
model Cart
  coordinate Length x;
  kinetic 1/2*(1 kg)*der(x)^2;
  replaceable Soft spring(s = x, k = 5 N/m);
end Cart;
"""


def flat_of(text: str) -> fm.FlatModel:
    flat, sink = run(text, model="M")
    assert flat is not None, [(d.code, d.message, d.labels[0].span.text) for d in sink.diagnostics]
    return flat


def values(text: str) -> dict[str, float]:
    return {parameter.name: parameter.value for parameter in flat_of(text).parameters}


def errors(text: str) -> list[tuple[str, str]]:
    _, sink = run(text, model="M")
    return [(d.code, d.labels[0].span.text) for d in sink.diagnostics if d.code[0] == "E"]


def test_a_component_may_be_called_as_its_class() -> None:
    flat = flat_of(SLIDER + "model M\n  Slider Slider(m = 3 kg);\nend M;\n")
    assert [c.name for c in flat.coordinates] == ["Slider.x"]
    assert len(flat.energies) == 1


@pytest.mark.parametrize(
    ("modifiers", "told"),
    [
        ("s.m = {1, 2}, s(each m = 3)", "each m = 3"),
        ("s[2](m = 3 kg), s.m = {1, 2}", "s.m = {1, 2}"),
        ("s[1](m = 1 kg), s[1](m = 2 kg)", "m = 2 kg"),
        ("s.x(start = {1, 2}, start = {2, 3})", "start = {2, 3}"),
    ],
)
def test_one_list_says_one_thing(modifiers: str, told: str) -> None:
    assert errors(f"{SLIDER}model M\n  Row r({modifiers});\nend M;\n") == [("E0212", told)]


def test_elements_may_be_modified_one_by_one() -> None:
    found = values(SLIDER + "model M\n  Row r(s[1](m = 3 kg), s[2](m = 4 kg), s.x.start = {1, 2});\nend M;\n")
    assert found == {"r.s[1].m": 3.0, "r.s[2].m": 4.0}


@pytest.mark.parametrize("modifier", ["each s.m = 3", "each s(m = 3)", "s(each m = 3)"])
def test_each_counts_for_the_array_that_it_meets(modifier: str) -> None:
    found = values(f"{SLIDER}model M\n  Row r({modifier});\nend M;\n")
    assert found == {"r.s[1].m": 3.0, "r.s[2].m": 3.0}


def test_each_at_one_component() -> None:
    text = SLIDER + "model Pair\n  Slider a, b;\nend Pair;\nmodel M\n  Pair p(each a(m = 3 kg));\nend M;\n"
    assert errors(text) == [("E0344", "each a(m = 3 kg)")]


def test_arrays_in_arrays_need_an_each_of_their_own() -> None:
    text = SLIDER + "model M\n  Row r[2]({});\nend M;\n"
    assert set(values(text.format("each s(each m = 3)")).values()) == {3.0}
    assert errors(text.format("each s.m = 3")) == [("E0335", "each s.m = 3")]
    several = "model S coordinate Length x[2](each start = 1); end S; model M S s[2](x(each start = 7 m)); end M;"
    helps = {found.help for found in run(several)[1].diagnostics if found.code == "E0335"}
    assert helps == {"`each` counts for one array; the one inside needs its own: `each name(each start = 7 m)`"}


def test_redeclarations_of_arrays_are_split() -> None:
    found = values(CART + "model M\n  Cart c[2](redeclare Hard spring(b = {3, 4}));\nend M;\n")
    assert [found["c[1].spring.b"], found["c[2].spring.b"]] == [3.0, 4.0]
    assert errors(CART + "model M\n  Cart c[2](redeclare Hard spring(b = 3));\nend M;\n") == [("E0335", "b = 3")]


# ---- extends ---------------------------------------------------------------------------------------------------------


def test_extends_modifies_its_own_class_only() -> None:
    own = "model M\n  extends Slider(k = 3 N/m);\n  parameter Stiffness k = 2 N/m;\n  potential k*x^2;\nend M;\n"
    assert errors(SLIDER + own) == [("E0223", "k")]
    other = "model Spot\n  parameter Length l = 1 m;\n  mass 1 kg at {l, 0};\nend Spot;\n"
    assert errors(SLIDER + other + "model M\n  extends Slider(l = 3 m);\n  extends Spot;\nend M;\n") == [("E0223", "l")]


def test_extends_modifies_what_its_class_inherits() -> None:
    text = SLIDER + "model A\n  extends Slider;\nend A;\nmodel B\n  extends Slider;\nend B;\n"
    assert values(text + "model M\n  extends A(m = 3 kg);\n  extends B(m = 3 kg);\nend M;\n") == {"m": 3.0}


@pytest.mark.parametrize("second", ["extends Slider(m = 3 kg)", "extends Slider", "extends B(m = 3 kg)", "extends B"])
def test_two_ways_with_different_modifiers(second: str) -> None:
    text = SLIDER + "model A\n  extends Slider(m = 2 kg);\nend A;\nmodel B\n  extends Slider;\nend B;\n"
    assert [code for code, _ in errors(f"{text}model M\n  extends A;\n  {second};\nend M;\n")] == ["E0243"]


# ---- what is not there -----------------------------------------------------------------------------------------------


def test_modifiers_of_absent_components_are_checked() -> None:
    text = (
        SLIDER + "model M\n  structural parameter Boolean two = false;\n  Slider a;\n  Slider b({}) if two;\nend M;\n"
    )
    assert values(text.format("m = 2 kg")) == {"two": 0.0, "a.m": 1.0}
    assert errors(text.format("mass = 2 kg")) == [("E0223", "mass")]


def test_redeclared_classes_are_checked_where_they_are_redeclared() -> None:
    bad = "model Bad\n  input Length s;\n  potential 1/2*(2 N/m)*s^2;\nend Bad;\n"
    assert errors(CART + bad + "model M\n  Cart c(redeclare Bad spring);\nend M;\n") == [
        ("E0244", "redeclare Bad spring")
    ]
    kit = "model Kit\n  replaceable model S = Soft;\n  coordinate Length x;\n  kinetic 1/2*(1 kg)*der(x)^2;\n"
    kit += "  S a[2](each s = x);\n  output Stiffness k = a[2].k;\nend Kit;\n"
    kit += "model Two\n  replaceable model T = Soft;\n  Kit kit(redeclare model S = T);\nend Two;\n"
    assert errors(CART + bad + kit + "model M = Two(redeclare model T = Bad);\n") == [
        ("E0244", "redeclare model T = Bad")
    ]
    assert values(CART + bad + kit + "model M = Two(redeclare model T = Hard);\n")["kit.a[1].k"] == 20.0


def test_size_of_an_array_of_components() -> None:
    found = flat_of(SLIDER + "model M\n  Slider s[2, 3];\n  output Real n = size(s, 2);\nend M;\n")
    assert [c.name for c in found.coordinates][:2] == ["s[1,1].x", "s[1,2].x"]


def test_circles_name_the_components() -> None:
    _, sink = run(SLIDER + "model M\n  Slider a(m = 2*b.m), b(m = a.m/3);\nend M;\n", model="M")
    assert [d.message for d in sink.diagnostics] == ["circular definition: `a.m` depends on `b.m`, `b.m` on `a.m`"]


def test_a_signal_is_a_number() -> None:
    """The unit mistake is told at the modifier, not in the text of the block."""
    block = "model Gain\n  input Real u;\n  output Real y = 2*u + 1;\nend Gain;\n"
    body = "model M\n  extends Slider;\n  Gain g(u = x{});\n  force g.y*(1 N) on x;\nend M;\n"
    assert errors(SLIDER + block + body.format("/(1 m)")) == []
    assert errors(SLIDER + block + body.format("")) == [("E0407", "x")]
