"""Classes of several components, declarations under a condition, multipliers of constraints that are not there."""

from __future__ import annotations

from flattening import run

from lagdsl.foundation.diagnostics import Severity
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.expression import Number

SLIDER = """model Slider
  parameter Mass m = 1 kg;
  coordinate Length x(start = 0.1 m);
  kinetic 1/2*m*der(x)^2;
end Slider;
model Sliders = Slider[2](m = {1 kg, 2 kg});
model Grid = Sliders[3](each x.start = 2 m);
"""
HELD = """model M
  structural parameter Boolean heavy = false, held = false;
  parameter Mass extra = 1 kg if heavy, other = 2 kg if not heavy;
  coordinate Length x, z(start = 1 m) if heavy;
  kinetic 1/2*(1 kg)*der(x)^2;
  constraint wire: x = 0 if held;
  constraint pin: {x, 2*x} = {0 m, 0 m} if held;
  body rod(m = 1 kg, Izz = 1 kg.m2) on world.move({x, 0}) if held;
  output Force f = multiplier(wire);
"""


def flat_of(text: str, **structural: float) -> fm.FlatModel:
    flat, sink = run(text, model="M", structural=structural)
    assert flat is not None, [(d.code, d.message) for d in sink.diagnostics]
    return flat


def codes(text: str) -> list[str]:
    return [d.code for d in run(text, model="M")[1].diagnostics]


def masses(flat: fm.FlatModel) -> dict[str, float]:
    return {item.name: item.value for item in flat.parameters}


def test_a_sized_class_makes_an_array() -> None:
    flat = flat_of(SLIDER + "model M Sliders s; Grid g[2]; output Length y = s[1].x + g[2, 3, 2].x; end M;")
    names = [item.name for item in flat.coordinates]
    assert names[:2] == ["s[1].x", "s[2].x"] and len(names) == 2 + 12 and names[-1] == "g[2,3,2].x"
    assert masses(flat)["g[2,3,1].m"] == 1.0 and masses(flat)["g[1,1,2].m"] == 2.0
    assert flat.coordinates[-1].start == Number(2.0)


def test_modifiers_from_outside_win_and_are_split() -> None:
    flat = flat_of(SLIDER + "model M Sliders s(each m = 3 kg), t[2](m = {{1 kg, 2 kg}, {3 kg, 4 kg}}); end M;")
    assert [masses(flat)[f"s[{k}].m"] for k in (1, 2)] == [3.0, 3.0]
    assert [masses(flat)[f"t[2,{k}].m"] for k in (1, 2)] == [3.0, 4.0]
    assert "E0234" in codes(SLIDER + "model M Sliders s(m = {1 kg, 2 kg, 3 kg}); end M;")


def test_one_class_is_needed() -> None:
    assert codes(SLIDER + "model M extends Sliders; end M;") == ["E0245"]
    holder = "model Holder replaceable Slider s; end Holder;"
    assert codes(f"{SLIDER}{holder} model M Holder h(redeclare Sliders s); end M;") == ["E0242"]
    _, sink = run(SLIDER + "type T = Slider[2]; model M T s; end M;", model="M")
    assert [(d.code, d.help) for d in sink.diagnostics] == [("E0233", "write `model T = Slider[2];`")]


def test_declarations_under_a_condition() -> None:
    without, with_all = flat_of(HELD + "end M;"), flat_of(HELD + "end M;", heavy=1.0, held=1.0)
    assert set(masses(without)) & {"extra", "other"} == {"other"} and len(without.coordinates) == 1
    assert set(masses(with_all)) & {"extra", "other"} == {"extra"} and len(with_all.coordinates) == 2
    assert codes(HELD + "output Mass y = extra; end M;") == ["E0230"]
    points = "point P[2]; for i in 1:2 loop point P[i] = {i*(1 m), x} if i > 1 or heavy; end for;"
    assert codes(f"{HELD}{points} end M;") == ["E0318"]
    assert flat_of(f"{HELD}{points} end M;", heavy=1.0)
    assert codes("model M parameter Boolean b = true; parameter Real k = 1 if b; end M;") == ["E0330"]


def test_what_is_not_there_exerts_nothing() -> None:
    more = "output Real g[2] = multiplier(pin)/(1 N); output AngularMomentum h = angular_momentum(rod).z; end M;"
    flat = flat_of(HELD + more)
    found = {item.name: item for item in flat.outputs}
    assert found["f"].value == Number(0.0) and found["f"].unit == "N" and not flat.constraints
    assert len(flat_of(HELD + more, held=1.0).constraints) == 2
    assert codes(HELD + "output Torque wrong = multiplier(wire); end M;") == ["E0407"]


def test_modifiers_of_what_is_not_there_say_nothing() -> None:
    box = "model Box structural parameter Boolean heavy = false; parameter Mass extra = 1 kg if heavy; end Box;"
    assert codes(f"{box} model M Box b(extra = 2 kg); end M;") == []
    assert masses(flat_of(f"{box} model M Box b(extra = 2 kg, heavy = true); end M;"))["b.extra"] == 2.0
    assert codes(f"{box} model M Box b(extras = 2 kg); end M;") == ["E0223"]


def test_names_of_a_branch_that_is_not_taken_are_told_so() -> None:
    """They were unknown names, with a proposal to declare them."""
    head = "model M structural parameter Boolean held = false; coordinate Length x; kinetic 1/2*(1 kg)*der(x)^2;"
    inside = "constraint c: x = 0; parameter Real k = 2; output Real twice = 2*k;"
    for use in ("output Force f = multiplier(c);", "output Real y = k;"):
        text = f"{head} if held then {inside} else parameter Real other = 1; end if; {use} end M;"
        _, sink = run(text, model="M")
        (found,) = (each for each in sink.diagnostics if each.severity is Severity.ERROR)
        assert found.code == "E0230" and len(found.labels) == 2
        assert flat_of(text.replace("Boolean held = false", "Boolean held = true"))
    text = f"{head} if held then else {inside} end if; output Force f = multiplier(c); end M;"
    assert codes(text) == [] and codes(text.replace("held = false", "held = true")) == ["E0230"]
