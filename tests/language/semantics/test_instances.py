"""A model of components flattens to what the same mechanism written in one class does."""

from __future__ import annotations

import re

import pytest
from flattening import output, run, said
from hypothesis import given
from hypothesis import strategies as st

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.text import flat_text

LIBRARY = """
model Spring "Between two points"
  point a, b;
  parameter Stiffness k = 10 N/m;
  parameter Length rest = 0;
  Length s = norm(b - a) - rest;
  potential V = 1/2*k*s^2;
end Spring;
model Pendulum
  point O;
  parameter Length l = 1 m;
  parameter Mass m = 1 kg;
  coordinate Angle q;
  input Torque tau = 0;
  torque tau on q;
  point P = O + {l*sin(q), -l*cos(q)};
  mass m at P;
end Pendulum;
"""


def flat_of(text: str, model: str = "M") -> fm.FlatModel:
    flat, sink = run(text, model=model)
    assert flat is not None, [(d.code, d.message, d.labels[0].span.text) for d in sink.diagnostics]
    return flat


def lines(flat: fm.FlatModel) -> list[str]:
    """The flat text with `a.b` and `a[1].b` written as `a_b` and `a_1_b`, without places."""
    text = flat_text(flat)
    listed = (*flat.coordinates, *flat.states, *flat.inputs, *flat.parameters, *flat.named, *flat.outputs)
    for name in sorted({item.name for item in listed if "." in item.name}, key=len, reverse=True):
        text = text.replace(name, re.sub(r"\[(\d+)\]\.", r"_\1.", name).replace(".", "_"))
    return [re.sub(r"\s*//.*", "", line) for line in text.split("\n")[1:]]


def values(flat: fm.FlatModel) -> dict[str, float]:
    return {parameter.name: parameter.value for parameter in flat.parameters}


# ---- the same mechanism in one class ---------------------------------------------------------------------------------


def test_components_are_what_one_class_says() -> None:
    built = flat_of(
        LIBRARY
        + """
model M
  Pendulum one(O = {0, 0}, l = 2 m, q(start = 20 deg, fixed = true)), two(O = one.P, m = 3 kg, q.start = 5 deg);
  Spring spring(a = one.P, b = two.P, k = 7 N/m);
  input Torque u;
  torque u on two.q;
  gravity = -g_n*world.y;
  output Angle sum = one.q + two.q;
  output Energy stored = spring.V;
end M;
"""
    )
    written = flat_of(
        """
model M
  point one_O = {0, 0};
  parameter Length one_l = 2 m;
  parameter Mass one_m = 1 kg;
  coordinate Angle one_q(start = 20 deg, fixed = true);
  point one_P = one_O + {one_l*sin(one_q), -one_l*cos(one_q)};
  mass one_m at one_P;
  point two_O = one_P;
  parameter Length two_l = 1 m;
  parameter Mass two_m = 3 kg;
  coordinate Angle two_q(start = 5 deg);
  point two_P = two_O + {two_l*sin(two_q), -two_l*cos(two_q)};
  mass two_m at two_P;
  point spring_a = one_P, spring_b = two_P;
  parameter Stiffness spring_k = 7 N/m;
  parameter Length spring_rest = 0;
  Length spring_s = norm(spring_b - spring_a) - spring_rest;
  potential spring_V = 1/2*spring_k*spring_s^2;
  input Torque u;
  torque u on two_q;
  gravity = -g_n*world.y;
  output Angle sum = one_q + two_q;
  output Energy stored = spring_V;
end M;
"""
    )
    assert lines(built) == lines(written)


def test_inherited_is_written_again() -> None:
    built = flat_of(
        """
partial model Slider
  parameter Mass m = 1 kg;
  coordinate Length x;
  kinetic 1/2*m*der(x)^2;
end Slider;
partial model Sprung
  extends Slider(m = 2 kg, x(start = 1 m));
  parameter Stiffness k = 3 N/m;
  potential 1/2*k*x^2;
end Sprung;
model M
  extends Sprung(k = 4 N/m, m = 5 kg);
  dissipation 1/2*(1 N.s/m)*der(x)^2;
end M;
"""
    )
    written = flat_of(
        """
model M
  parameter Mass m = 5 kg;
  coordinate Length x(start = 1 m);
  kinetic 1/2*m*der(x)^2;
  parameter Stiffness k = 4 N/m;
  potential 1/2*k*x^2;
  dissipation 1/2*(1 N.s/m)*der(x)^2;
end M;
"""
    )
    assert lines(built) == lines(written)


def test_arrays_are_components_one_by_one() -> None:
    model = "model M\n  structural parameter Integer n = 3;\n  %s\n  gravity = 0;\nend M;\n"
    array = "Pendulum p[n](each O = {0, 0}, l = {1 m, 2 m, 3 m}, each m = 2 kg, q(start = {i*0.1 for i in 1:n}));"
    single = "".join(f"Pendulum p_{i}(O = {{0, 0}}, l = {i} m, m = 2 kg, q(start = {i}*0.1));" for i in (1, 2, 3))
    assert lines(flat_of(LIBRARY + model % array)) == lines(flat_of(LIBRARY + model % single))


def test_one_element_of_an_array_is_modified() -> None:
    """An outer modifier of all elements wins over an inner one of a single element, and the other way round."""
    row = "model Row\n  Pendulum p[3](each O = {0, 0});\n  gravity = 0;\nend Row;\n"
    flat = flat_of(LIBRARY + row + "model M = Row(p[2](m = 9 kg), p(each l = 4 m));\n")
    assert [flat_value for name, flat_value in values(flat).items() if name.endswith(".m")] == [1.0, 9.0, 1.0]
    assert values(flat)["p[3].l"] == 4.0
    outer = flat_of(LIBRARY + row + "model Heavy = Row(p[2](m = 9 kg));\nmodel M = Heavy(p(each m = 5 kg));\n")
    assert values(outer)["p[2].m"] == 5.0


# ---- bindings --------------------------------------------------------------------------------------------------------


def test_a_bound_input_is_a_name_for_its_binding() -> None:
    """The chain rule goes through it: the torsion spring acts on what it is bound to."""
    flat = flat_of(
        """
model TorsionSpring
  input Angle q;
  potential 1/2*(3 N.m/rad)*q^2;
  output AngularVelocity w = der(q);
end TorsionSpring;
model M
  coordinate Angle phi(start = 1);
  kinetic 1/2*(1 kg.m2)*der(phi)^2;
  TorsionSpring spring(q = 2*phi);
end M;
"""
    )
    assert [item.name for item in flat.inputs] == []
    assert [item.name for item in flat.named] == ["spring.q"]
    assert output(flat, "spring.w") == fx.Derivative(fx.Variable("spring.q"))


def test_inputs_of_components() -> None:
    """Unbound: an input of the model where there is no default, else the default."""
    flat = flat_of(
        LIBRARY
        + """
model Driven
  extends Pendulum;
  input Torque drive;
  torque drive on q;
end Driven;
model M
  Driven a(O = {0, 0}), b(O = {0, 0}, drive = 2 N.m, tau = 1 N.m);
  gravity = 0;
end M;
"""
    )
    assert [item.name for item in flat.inputs] == ["a.drive"]
    # The idle torque of `a` is left out.
    assert [type(load).__name__ for load in flat.loads] == ["GeneralizedForce"] * 3


def test_frames_are_handed_on() -> None:
    flat = flat_of(
        """
model Block
  frame at;
  parameter Mass m;
  body b(m = m, Izz = 1 kg.m2) on at;
  frame tip = at.move({1 m, 0, 0});
end Block;
model M
  coordinate Angle q;
  Block one(at = world.rotz(q), m = 1 kg), two(at = one.tip, m = 2 kg);
  gravity = 0;
  output Length x = two.tip.origin.x;
end M;
"""
    )
    frames = [(item.name, item.parent) for item in flat.named if isinstance(item, fm.Frame)]
    assert frames == [("one.at", "world"), ("one.tip", "one.at"), ("two.at", "one.tip"), ("two.tip", "two.at")]


def test_an_equation_gives_a_component_its_input() -> None:
    """In the place of its default, but not beside another value."""
    text = LIBRARY + "model M\n  Pendulum p(O = {0, 0}%s);\n  gravity = 0;\nequation\n  p.tau = -(1 N.m)*p.q;\nend M;\n"
    (load,) = flat_of(text % "").loads
    assert isinstance(load, fm.GeneralizedForce) and load.value == fx.Variable("p.tau")
    assert [code for code, _ in said(run(text % ", tau = 1 N.m", model="M")[1])] == ["E0319"]


def test_multipliers_and_momenta_of_components() -> None:
    flat = flat_of(
        """
model Gear
  coordinate Angle a, b;
  kinetic (1 kg.m2)*(der(a)^2 + der(b)^2);
  constraint mesh: a = 2*b;
end Gear;
model M
  Gear g[2];
  output Torque m = multiplier(g[2].mesh);
  output AngularMomentum p = momentum(g[1].a);
end M;
"""
    )
    assert repr(output(flat, "m")).count("g[2].mesh") == 1
    assert output(flat, "p") == fx.GeneralizedMomentum("g[1].a")


# ---- conditions ------------------------------------------------------------------------------------------------------

SWITCHED = """
model Damper
  input Length x;
  dissipation 1/2*(1 N.s/m)*der(x)^2;
end Damper;
model M
  %s parameter Boolean damped = %s;
  coordinate Length x;
  kinetic 1/2*(1 kg)*der(x)^2;
  Damper d(x = x) if damped;
end M;
"""


@pytest.mark.parametrize(("value", "count"), [("true", 1), ("false", 0)])
def test_a_structural_condition_keeps_or_drops(value: str, count: int) -> None:
    flat = flat_of(SWITCHED % ("structural", value))
    assert len([term for term in flat.energies if term.kind == "dissipation"]) == count


def test_a_condition_of_parameters_switches() -> None:
    (term,) = (term for term in flat_of(SWITCHED % ("", "false")).energies if term.kind == "dissipation")
    assert isinstance(term.value, fx.Conditional) and term.value.condition == fx.Variable("damped")


# ---- redeclaration ---------------------------------------------------------------------------------------------------

CAR = """
model Soft
  input Length s;
  parameter Stiffness k = 1 N/m;
  potential 1/2*k*s^2;
end Soft;
model Hard
  input Length s;
  parameter Stiffness k = 9 N/m;
  potential 1/2*k*s^2 + (1 N/m3)*s^4;
end Hard;
model Car
  replaceable model Tyre = Soft;
  coordinate Length x;
  kinetic 1/2*(1 kg)*der(x)^2;
  replaceable Soft spring(s = x);
  Tyre tyre(s = x);
end Car;
"""


def test_redeclared_components_and_classes() -> None:
    text = CAR + "model M\n  Car car(redeclare Hard spring, redeclare model Tyre = Hard(k = 5 N/m));\nend M;\n"
    assert values(flat_of(text)) == {"car.spring.k": 9.0, "car.tyre.k": 5.0}


def test_the_outermost_redeclaration_wins() -> None:
    text = CAR + "model Race\n  extends Car(redeclare Hard spring(k = 7 N/m));\nend Race;\n"
    text += "model M = Race(redeclare Soft spring(k = 2 N/m));\n"
    assert values(flat_of(text))["spring.k"] == 2.0


# ---- who wins --------------------------------------------------------------------------------------------------------

_numbers = st.none() | st.integers(1, 99)


def _given(name: str, value: int | None) -> str:
    return f"({name} = {value} kg)" if value is not None else ""


@given(st.tuples(*[_numbers] * 6))
def test_outer_modifiers_win(levels: tuple[int | None, ...]) -> None:
    base, short, component, inner, outer, whole = levels
    flat = flat_of(
        f"""
model A
  parameter Mass m = 100 kg;
  coordinate Length x;
  kinetic 1/2*m*der(x)^2;
end A;
model B
  extends A{_given("m", base)};
end B;
model S = B{_given("m", short)};
model C
  S s{_given("m", component)};
end C;
model D
  extends C{_given("s.m", inner)};
end D;
model E
  D d{_given("s(m", outer) + (")" if outer is not None else "")};
end E;
model M = E{_given("d.s.m", whole)};
"""
    )
    assert values(flat) == {"d.s.m": float([100, *(each for each in levels if each is not None)][-1])}


# ---- the order of things ---------------------------------------------------------------------------------------------


def test_parts_stand_where_their_component_is_declared() -> None:
    flat = flat_of(
        """
model Part
  coordinate Length x, y;
  kinetic 1/2*(1 kg)*(der(x)^2 + der(y)^2);
end Part;
model M
  coordinate Length first;
  Part a;
  coordinate Length middle;
  Part b[2];
  kinetic 1/2*(1 kg)*(der(first)^2 + der(middle)^2);
end M;
"""
    )
    names = ["first", "a.x", "a.y", "middle", "b[1].x", "b[1].y", "b[2].x", "b[2].y"]
    assert [coordinate.name for coordinate in flat.coordinates] == names
    assert len(flat.energies) == 4


def test_declarations_may_stand_in_any_order() -> None:
    flat = flat_of(
        "model M\n  Part p[n](x(each start = n*1 m));\n  structural parameter Integer n = 2;\nend M;\n" + PART
    )
    assert [coordinate.name for coordinate in flat.coordinates] == ["p[1].x", "p[2].x"]


PART = "model Part\n  coordinate Length x;\n  kinetic 1/2*(1 kg)*der(x)^2;\nend Part;\n"


def test_places_go_outward() -> None:
    """Every flat item keeps the declarations that led to it."""
    flat = flat_of(PART + "model Pair\n  Part one;\nend Pair;\nmodel M\n  Pair two[2];\nend M;\n")
    assert [span.text for span in flat.energies[1].spans[1:]] == ["one", "two"]


def test_a_fault_in_a_class_is_told_once() -> None:
    text = (
        PART.replace("(1 kg)", "(1 m)") + "model Pair\n  Part one, other;\nend Pair;\nmodel M\n  Pair two[5];\nend M;\n"
    )
    _, sink = run(text, model="M")
    assert said(sink) == [("E0404", "1/2*(1 m)*der(x)^2")]
    assert [label.text for label in sink.diagnostics[0].labels[1:]] == [
        "in component `two[1].one`",
        "in component `two[1]`",
    ]


def test_the_experiment_is_inherited_unless_redefined() -> None:
    base = PART.replace("end Part", "annotation(experiment(StopTime = 3, Interval = 0.1));\nend Part")
    assert flat_of(base + "model M\n  extends Part;\nend M;\n").experiment.stop_time == 3.0
    own = flat_of(base + "model M\n  extends Part;\n  annotation(experiment(StopTime = 7));\nend M;\n").experiment
    assert (own.stop_time, own.interval) == (7.0, None)
    assert flat_of(base + "model M\n  Part p;\nend M;\n").experiment.stop_time == 10.0


def test_what_two_bases_declare_alike_is_one() -> None:
    text = PART + "model A\n  extends Part;\n  parameter Real k = 1;\nend A;\n"
    text += "model B\n  extends Part;\n  parameter Real k = 1;\nend B;\nmodel M\n  extends A;\n  extends B;\n"
    flat = flat_of(text + "  potential k*(1 N/m)*x^2;\nend M;\n")
    assert [len(flat.coordinates), len(flat.parameters), len(flat.energies)] == [1, 1, 2]


@pytest.mark.parametrize("given", ["{world, world, world}", "world"])
def test_an_array_of_frames_is_given_frame_by_frame(given: str) -> None:
    row = "model Row\n  frame ways[2];\n  mass 1 kg at ways[2];\nend Row;\n"
    flat, sink = run(f"{row}model M\n  Row row(ways = {given});\n  gravity = 0;\nend M;\n", model="M")
    assert flat is None
    assert "E0334" in {code for code, _ in said(sink)}
