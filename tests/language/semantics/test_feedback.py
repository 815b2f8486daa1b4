"""Loads that depend on the motion that they cause."""

from __future__ import annotations

import pytest
from choice import together
from flattening import output, run, said

from lagdsl.foundation.units.dimension import ENERGY, FORCE
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.expression_text import flat_expression_text as text_of

WIRE = """model M
  parameter Real mu = 0.3;
  parameter Boolean on = true;
  coordinate Length x, y(start = 1 m);
  coordinate Angle a;
  point P = {x, y};
  mass 1 kg at P;
  gravity = -g_n*world.y;
  frame B = world.move({x, y}).rotz(a);
  body b(m = 1 kg, Izz = 1 kg.m2) on B;
  constraint wire: norm(P) = 1 m;
"""


def flat_of(body: str) -> fm.FlatModel:
    flat, sink = run(f"{WIRE}{body}\nend M;\n")
    assert flat is not None, said(sink)
    return flat


def told(flat: fm.FlatModel) -> tuple[list[str], dict[str, str]]:
    """Values of the loads, and the feedbacks by name."""
    values = [
        text_of(load.force if isinstance(load, fm.PointForce) else load.torque)
        if isinstance(load, fm.PointForce | fm.FrameTorque)
        else text_of(load.value)
        for load in flat.loads
    ]
    return values, {each.name: text_of(each.value) for each in flat.events.feedbacks}


@together(
    ("load", "value", "feedbacks"),
    [
        ("force F = mu*multiplier(wire) on x;", "load(F)", {"load(F)": "mu*multiplier(wire)"}),
        (  # what is known with the state stays
            "force F = -(2 N.s/m)*der(x) - mu*multiplier(wire) on x;",
            "-2*der(x) + load(F)",
            {"load(F)": "-(mu*multiplier(wire))"},
        ),
        ("force -(0.1 kg)*der(der(y)) on y;", "load(-0.1*der(der(y)))", {"load(-0.1*der(der(y)))": "-0.1*der(der(y))"}),
        (
            "torque T = (1 m)*norm(reaction(B).force) on a;",
            "load(T)",
            {"load(T)": "1*norm(reaction(B).force)"},
        ),
        ("force F = {multiplier(wire), 1 N} at P;", "{load(F).x, 1, 0}", {"load(F).x": "multiplier(wire)"}),
        (
            "force F = -multiplier(wire)*world.x at P;",
            "{load(F).x, 0, 0}",
            {"load(F).x": "-multiplier(wire)"},
        ),
        ("force F = multiplier(wire)*B.x at P;", "load(F)*B.x", {"load(F)": "multiplier(wire)"}),
        ("torque T = (1 m)*multiplier(wire)*B.z on B;", "load(T)*B.z", {"load(T)": "1*multiplier(wire)"}),
        (
            "force F = mu*multiplier(wire) on x if on;",
            "if on then load(F) else 0",
            {"load(F)": "mu*multiplier(wire)"},
        ),
        ("force F = -energy()/(10 m) on x;", "load(F)", {"load(F)": "-energy()/10"}),
    ],
)
def test_terms_that_need_the_solved_motion_are_entries(load: str, value: str, feedbacks: dict[str, str]) -> None:
    assert told(flat_of(load)) == ([value], feedbacks)


def test_entries_are_last_and_have_the_dimension_of_the_load() -> None:
    flat = flat_of("force multiplier(wire)*B.y at P; torque (1 m)*multiplier(wire) on a;")
    assert [each.dimension for each in flat.events.feedbacks] == [FORCE, ENERGY]


def test_reader_of_the_label_sees_the_value() -> None:
    flat = flat_of("force F = mu*multiplier(wire) on x; force G = 2*F on y; output Force f = F;")
    assert text_of(output(flat, "f")) == "mu*multiplier(wire)"
    assert told(flat)[1] == {"load(F)": "mu*multiplier(wire)", "load(G)": "2*(mu*multiplier(wire))"}
    assert [each.name for each in flat.observed] == ["F", "G"]


def test_loads_without_need_are_as_before() -> None:
    flat = flat_of("force F = -(1 N.s/m)*der(x) on x;")
    assert flat.events.feedbacks == ()


@pytest.mark.parametrize(
    ("body", "code"),
    [
        ("force F = 2*F on x;", "E0305"),
        ("potential x*multiplier(wire);", "E0324"),
        ("constraint c: multiplier(wire) = 3 N;", "E0324"),
        ("initial equation multiplier(wire) = 3 N;", "E0324"),
    ],
)
def test_the_rest_is_refused(body: str, code: str) -> None:
    flat, sink = run(f"{WIRE}{body}\nend M;\n")
    assert flat is None
    assert code in [found for found, _ in said(sink)]
