"""Dry friction and one-way contacts: from the text to the flat model."""

from __future__ import annotations

import pytest
from choice import together
from flattening import output, run, said

from lagdsl.language.flat import events as fe
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.evaluate import Values, evaluate
from lagdsl.language.flat.expression_text import flat_expression_text as text_of

BLOCKS = """model M
  parameter Real mu = 0.3;
  parameter Force r = 2 N;
  coordinate Length x, y(start = 1 m), z;
  coordinate Angle a, b;
  gravity = -g_n*world.y;
  mass 1 kg at {x, y, z};
  kinetic 1/2*(1 kg.m2)*(der(a)^2 + der(b)^2);
"""
FLOOR = "contact floor: y >= 0 with restitution = 0.3, friction = mu, slip = {}{};\n"


def flat_of(body: str) -> fm.FlatModel:
    """The flat model of three lengths and two angles with `body`, of which only W0206 may be said."""
    flat, sink = run(f"{BLOCKS}{body}\nend M;\n")
    assert flat is not None, said(sink)
    assert {d.code for d in sink.diagnostics} <= {"W0206"}, said(sink)
    return flat


def faults(body: str) -> list[tuple[str, str]]:
    """Errors of the same, by code and place."""
    _, sink = run(f"{BLOCKS}{body}\nend M;\n")
    return [each for each in said(sink) if each[0].startswith("E")]


def friction(body: str) -> fe.Friction:
    (found,) = flat_of(body).events.frictions
    return found


# ---- the law ---------------------------------------------------------------------------------------------------------


def test_friction_is_a_row_while_it_sticks_and_a_load_while_it_slides() -> None:
    flat = flat_of("friction hold: der(a) - der(b) with limit = 40 N.m, sticking = 50 N.m;")
    (made,) = flat.events.frictions
    assert (made.name, made.sticks, made.directions) == ("hold", "sticks(hold)", ("direction(hold)",))
    assert (text_of(made.limit), text_of(made.sticking or fx.ZERO), made.contact) == ("40", "50", None)
    (row,) = flat.constraints
    assert (row.rows, row.level, row.friction, row.switched) == (("hold",), "velocity", True, False)
    assert text_of(row.residuals[0]) == "sticks(hold)*(der(a) - der(b))"
    (load,) = flat.loads
    assert isinstance(load, fm.RateForce)
    assert text_of(load.rate) == "der(a) - der(b)"
    for sticks, direction, force in ((0.0, 1.0, -40.0), (0.0, -1.0, 40.0), (1.0, 1.0, 0.0)):
        at = Values(variables={"sticks(hold)": sticks, "direction(hold)": direction})
        assert evaluate(flat, load.value, at) == force
    assert [entry.kind for entry in fe.entries(flat.events)] == ["sticks", "direction"]


def test_planar_friction_is_opposite_to_slip_within_a_disc() -> None:
    flat = flat_of("friction pad: {der(x), der(z)} with limit = r;")
    assert [row.rows for row in flat.constraints] == [("pad[1]", "pad[2]")]
    loads = [load for load in flat.loads if isinstance(load, fm.RateForce)]
    assert [text_of(load.rate) for load in loads] == ["der(x)", "der(z)"]
    for slip, begun, force in (
        ((3.0, -4.0), (0.0, 0.0), (-1.2, 1.6)),
        ((0.0, 0.0), (0.0, 1e-9), (0.0, -2.0)),  # slip that begins
        ((0.0, 0.0), (0.0, 0.0), (0.0, 0.0)),
    ):
        entries = dict(zip(("direction(pad)[1]", "direction(pad)[2]"), begun, strict=True))
        rates = {"x": slip[0], "z": slip[1]}
        at = Values(variables={"sticks(pad)": 0.0, "r": 2.0, **entries}, rates=rates)
        assert [evaluate(flat, load.value, at) for load in loads] == pytest.approx(force, abs=1e-15)


def test_multiplier_of_friction_is_its_force_in_both_modes() -> None:
    flat = flat_of("friction hold: der(x) with limit = r; output Force f = multiplier(hold);")
    assert text_of(output(flat, "f")) == "if sticks(hold) then multiplier(hold) else -(r*direction(hold))"
    flat = flat_of("friction pad: {der(x), der(z)} with limit = r; output Force f = multiplier(pad[2]);")
    assert text_of(output(flat, "f")).startswith("if sticks(pad) then multiplier(pad[2]) else ")


# ---- under contacts --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("slip", "rows"), [("der(x)", 1), ("{der(x), der(z)}", 2)])
def test_friction_under_a_contact_is_a_friction_of_its_own(slip: str, rows: int) -> None:
    flat = flat_of(FLOOR.format(slip, ", sticking = 1.5*mu"))
    (made,) = flat.events.frictions
    assert (made.name, made.contact, len(made.slips)) == ("floor.friction", "floor", rows)
    assert text_of(made.limit) == "mu*multiplier(floor)"
    assert text_of(made.sticking or fx.ZERO) == "1.5*mu*multiplier(floor)"
    (feedback,) = flat.events.feedbacks
    assert (feedback.name, feedback.value) == ("limit(floor.friction)", made.limit)
    assert all("limit(floor.friction)" in text_of(load.value) for load in flat.loads if isinstance(load, fm.RateForce))
    assert fe.entries(flat.events)[-1].kind == "load"


def test_friction_under_a_contact_is_read_by_a_member_of_it() -> None:
    reads = "output Force f = multiplier(floor.friction[2]); output Boolean s = sticks(floor);"
    reads += "output Boolean t = sticks(floor.friction);"
    flat = flat_of(FLOOR.format("{der(x), der(z)}", "") + reads)
    assert "multiplier(floor.friction[2])" in text_of(output(flat, "f"))
    assert text_of(output(flat, "s")) == text_of(output(flat, "t")) == "sticks(floor.friction)"


def test_coefficient_may_depend_on_the_normal_force() -> None:
    law = "contact floor: y >= 0 with restitution = 0, friction = mu/(1 + multiplier(floor)/(10 N)), slip = der(x);"
    assert text_of(friction(law).limit) == "mu/(1 + multiplier(floor)/10)*multiplier(floor)"


def test_compliant_contact_gives_a_limit_that_is_known() -> None:
    flat = flat_of("contact floor: y >= 0 with compliance = 1 kN/m, friction = mu, slip = der(x);")
    (made,) = flat.events.frictions
    assert made.contact is None
    assert text_of(made.limit) == "mu*(if closed(floor) then 1000*-(y - 0) else 0)"
    assert flat.events.feedbacks == ()


# ---- one way ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("relation", "rate"),
    [("der(a) - der(b) >= 0", "der(a) - der(b) - 0"), ("der(a) <= 3 rad/s", "3 - der(a)")],
)
def test_contact_of_rates_is_one_way(relation: str, rate: str) -> None:
    flat = flat_of(f"contact free: {relation}; output Torque t = multiplier(free); output Boolean c = closed(free);")
    (made,) = flat.events.contacts
    assert (made.one_way, made.restitution, text_of(made.gap)) == (True, fx.ZERO, rate)
    (row,) = flat.constraints
    assert (row.level, row.contact) == ("velocity", True)
    assert text_of(output(flat, "t")) == "multiplier(free)"


# ---- places ----------------------------------------------------------------------------------------------------------


def test_friction_in_loops_components_and_under_conditions() -> None:
    text = """model Pad
  input Real v(unit = "m/s");
  parameter Force r = 1 N;
end Pad;
model Brake
  structural parameter Boolean on = true;
  coordinate Angle q;
  kinetic 1/2*(1 kg.m2)*der(q)^2;
  friction f: der(q) with limit = 1 N.m if on;
  output Torque t = multiplier(f);
  output Boolean s = sticks(f);
end Brake;
model M
  Brake left, right(on = false);
  coordinate Length x[2];
  kinetic 1/2*(1 kg)*(der(x[1])^2 + der(x[2])^2);
  for i in 1:2 loop
    friction g: der(x[i]) with limit = i*(1 N);
  end for;
  friction der(x[1]) - der(x[2]) with limit = 3 N;
  output Force second = multiplier(g[2]);
end M;
"""
    flat, sink = run(text, model="M")
    assert flat is not None, said(sink)
    names = {each.name: text_of(each.limit) for each in flat.events.frictions}
    assert names == {"left.f": "1", "g[1]": "1*1", "g[2]": "2*1", "friction_1": "3"}
    assert "multiplier(g[2])" in text_of(output(flat, "second"))
    outputs = {item.name: text_of(item.value) for item in flat.outputs}
    assert (outputs["right.t"], outputs["right.s"], outputs["left.s"]) == ("0", "0", "sticks(left.f)")


def test_a_contact_that_is_absent_reads_as_open() -> None:
    law = FLOOR.format("der(x)", " if false") + "output Boolean c = closed(floor); output Integer n = impacts(floor);"
    flat = flat_of(law + "output Force f = multiplier(floor); output Force g = multiplier(floor.friction);")
    assert {item.name: text_of(item.value) for item in flat.outputs} == dict.fromkeys("cnfg", "0")
    assert flat.events.contacts == flat.events.frictions == ()


def test_the_mode_is_a_condition_of_events() -> None:
    body = """friction hold: der(x) with limit = r; discrete Integer n(start = 0);
  equation
  when not sticks(hold) and multiplier(hold) > 1 N then n = pre(n) + 1; end when;"""
    flat = flat_of(body)
    (relation,) = flat.events.relations
    assert text_of(relation.difference) == "(if sticks(hold) then multiplier(hold) else -(r*direction(hold))) - 1"
    (when,) = flat.events.whens
    assert text_of(when.branches[0].conditions[0]) == "not sticks(hold) and multiplier(hold) > 1 N"


def test_friction_is_a_name_elsewhere() -> None:
    flat = flat_of("output Real friction; equation friction = 3*x/(1 m);")
    assert text_of(output(flat, "friction")) == "3*x/1"


# ---- faults ----------------------------------------------------------------------------------------------------------


@together(
    ("body", "code", "place"),
    [
        ("friction h: x with limit = r;", "E0387", "x"),
        ("friction h: time*(1 m/s2) with limit = r;", "E0387", "time*(1 m/s2)"),
        ("friction h: der(der(x)) with limit = r;", "E0387", "der(der(x))"),
        ("friction h: der(x) > 0 with limit = r;", "E0387", "der(x) > 0"),
        ("friction h: {der(x), der(y), der(z)} with limit = r;", "E0387", "{der(x), der(y), der(z)}"),
        ("friction h: {der(x), der(a)} with limit = r;", "E0401", "der(a)"),
        ("friction h: der(x);", "E0388", "der(x)"),
        ("friction h: der(x) with sticking = r;", "E0388", "der(x)"),
        ("friction h: der(x) with limit = r, stick = r;", "E0202", "stick"),
        ("friction h: der(x) with limit = r, limit = r;", "E0212", "limit"),
        ("friction h: der(x) with limit = -2 N;", "E0334", "-2 N"),
        ("friction h: der(x) with limit = 2 N, sticking = 1 N;", "E0334", "1 N"),
        ("friction h: der(x) with limit = r, sticking = 1 N;", "E0334", "1 N"),  # of a parameter
        ("friction h: der(a) with limit = r;", "E0415", "r"),
        ("friction h: der(x) with limit = r if mu > 1;", "E0330", "mu > 1"),
        ("friction h: der(x) with limit = mu*multiplier(h);", "E0305", "h"),
        ("friction h: der(x) with limit = r; output Force f = h;", "E0219", "h"),
        ("output Boolean s = sticks(h);", "E0201", "h"),
        ("contact c: y >= 0 with restitution = 0; output Boolean s = sticks(c);", "E0312", "c"),
        ("contact c: y >= 0 with restitution = 0; output Force f = multiplier(c.friction);", "E0312", "c.friction"),
        ("contact c: y >= 0 with restitution = 0, friction = mu;", "E0388", "friction"),
        ("contact c: y >= 0 with restitution = 0, slip = der(x);", "E0388", "slip"),
        ("contact c: y >= 0 with restitution = 0, sticking = 1, slip = der(x);", "E0388", "sticking"),
        ("contact c: y >= 0 with restitution = 0, friction = -1, slip = der(x);", "E0334", "-1"),
        ("contact c: y >= 0 with restitution = 0, friction = 1, sticking = 0.5, slip = der(x);", "E0334", "0.5"),
        ("contact c: der(x) >= 0 with restitution = 0;", "E0389", "restitution"),
        ("contact c: der(der(x)) >= 0;", "E0382", "der(der(x)) >= 0"),
        ("for i in 1:2 loop friction h: der(x) with limit = r; end for; output Force f = multiplier(h);", "E0312", "h"),
        (
            "for i in 1:2 loop contact c: x >= 0 with restitution = 0; end for; output Boolean f = closed(c);",
            "E0312",
            "c",
        ),
    ],
)
def test_fault_is_told_at_its_place(body: str, code: str, place: str) -> None:
    assert faults(body) == [(code, place)]


@pytest.mark.parametrize(
    ("body", "code"),
    [
        ("friction h: der(x)*der(y)/(1 m/s) with limit = r;", "E0387"),
        ("friction h: der(w)*(1 m) with limit = r;", "E0387"),
        ("contact c: der(x)*der(y) >= 0;", "E0382"),
        ("contact c: der(w) >= 0;", "E0382"),
    ],
)
def test_slips_and_one_way_rates_are_linear_in_rates_of_coordinates(body: str, code: str) -> None:
    assert [found for found, _ in faults(f"state Real w(start = 1); {body} equation der(w) = -w/(1 s);")] == [code]


@pytest.mark.parametrize(
    ("body", "code", "place", "reason", "way_out"),
    [
        ("friction h: x with limit = r;", "E0387", "x", "a position", "write `der(x)`"),
        ("friction h: {x, y} with limit = r;", "E0387", "{x, y}", "a position", "write `{der(x), der(y)}`"),
        ("friction h: der(x) with limt = r;", "E0202", "limt", "not an attribute", "did you mean `limit`?"),
        ("friction h: der(x);", "E0388", "der(x)", "nothing says how large the force is", "write `with limit = R`, "),
        (
            "contact c: y >= 0 with friction = mu;",
            "E0388",
            "friction",
            "a contact knows its gap, not the direction in which the bodies slide",
            "add `slip = der(s)`, the rate at which the bodies slide on each other",
        ),
    ],
)
def test_a_mistyped_friction_says_why_and_leads_to_the_right_text(
    body: str, code: str, place: str, reason: str, way_out: str
) -> None:
    _, sink = run(f"{BLOCKS}{body}\nend M;\n")
    (found,) = [each for each in sink.diagnostics if each.code == code]
    assert found.labels[0].span.text == place
    assert found.labels[0].text == reason
    assert found.help is not None
    assert found.help.startswith(way_out)


def test_a_contact_without_law_and_slip_lacks_both_at_once() -> None:
    assert sorted(faults("contact c: y >= 0 with friction = mu;")) == [
        ("E0383", "contact c: y >= 0 with friction = mu;"),
        ("E0388", "friction"),
    ]
