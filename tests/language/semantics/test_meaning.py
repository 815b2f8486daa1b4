"""Meaning of expressions: precedence, functions, vectors, arrays, literals, compared with numbers worked out by
hand."""

from __future__ import annotations

import math

import pytest
from choice import together
from flattening import accepted, output, pendulum, run, said, value_of

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.evaluate import Values, evaluate

X, Y = 0.7, -1.3


@together(
    ("text", "expected"),
    [
        ("-x^2", -(X**2)),
        ("2^-x", 2**-X),
        ("2^3^2", 512.0),
        ("x - y - 1", X - Y - 1),
        ("x/y/2", X / Y / 2),
        ("+x", X),
        ("wrap(x + 4*pi)", X),
        ("wrap(3.5)", 3.5 - 2 * math.pi),
        ("limit(x, -0.5, 0.5)", 0.5),
        ("limit(y, -0.5, 0.5)", -0.5),
        ("mod(y, 1)", Y + 2),
        ("sign(y)*abs(y)", Y),
        ("log10(1000*exp(0))", 3.0),
        ("min({3, x, y})", Y),
        ("max(x, y)", X),
        ("sum(i^2 for i in 1:4)", 30.0),
        ("sum(i*j for i in 1:3, j in 1:i)", 25.0),
        ("product(i for i in {2, 3, 7})", 42.0),
        ("sum(i for i in 5:-2:1)", 9.0),
        ("sum({i + 10*j for i in 1:2, j in 1:3}*{1, 1})", 129.0),
        ("{1, 2, 3}*{4, 5, 6}", 32.0),
        ("[1, 2; 3, 4]*{5, 6}*{1, 0}", 17.0),
        ("{5, 6}*[1, 2; 3, 4]*{0, 1}", 34.0),
        ("([1, 2; 3, 4]*[0, 1; 1, 0])[2,1]", 4.0),
        ("transpose([1, 2; 3, 4])[1,2]", 3.0),
        ("diagonal({2, 3})[2,2]*identity(2)[1,1] + zeros(2)[1] + ones(2, 2)[1,2]", 4.0),
        ("([1, 2; 3, 4] .* [2, 2; 2, 2])[2,2] + ({6, 8} ./ {2, 4})[2] + 2 .* 3 + 6 ./ 3", 18.0),
        ("size([1, 2; 3, 4; 5, 6], 1) + size([1, 2; 3, 4; 5, 6])[2]", 5.0),
        ("linspace(0, x, 3)[2]", X / 2),
        ("fill(x, 2, 2)[2,1]", X),
        ("{1, 2, 3, 4}[2:3]*{1, 10}", 32.0),
        ("{1, 2, 3, 4}[{4, 1}]*{1, 10}", 14.0),
        ("[1, 2; 3, 4][:, 2]*{1, 1}", 6.0),
        ("norm({3, 4})", 5.0),
        ("norm({3, 4})^2", 25.0),
        ("norm({1, 1, 1, 1})", 2.0),
        ("unit({3, 4}).y", 0.8),
        ("cross({1, 0}, {0, 1}).z", 1.0),
        ("cross(world.x, world.y)*world.z", 1.0),
        ("(world.x*x + {0, y})*{1, 1, 1}", X + Y),
        ("([0, 1, 0; 1, 0, 0; 0, 0, 1]*(x*world.x)).y", X),
        ("(-world.x/x).x", -1 / X),
        ("world.rotz(pi/2).x.y", 1.0),
        ("world.rotz(x).vec({0, 0, 2}).z", 2.0),
        ("world.rotate({0, 0, 5}, pi/2).x.y", 1.0),
        ("world.euler(\"zxz\", 0, pi/2, 0).y.z", 1.0),
        ("world.quat({2, 0, 0, 2}).x.y", 1.0),
        ("world.axes(world.y, -world.x, world.z).y.x", -1.0),
        ("(world.move({1 m, 0}).rotz(pi/2).move({1 m, 0}) - world)*world.y/(1 m)", 1.0),
        ("(world.at({2 m, 0}).origin.x)/(1 m)", 2.0),
        ("world.rotz(pi/2).point({2 m, 0})*world.y/(1 m)", 2.0),
        ("if x > 1 then 1 elseif x > 0.5 and not y > 0 then 2 else 3", 2.0),
        ("if x < 0 or y < 0 then 1 else 2", 1.0),
        ("noEvent(if x <> y and x >= y and y <= x and x == x then 1 else 0)", 1.0),
        ("(if x > 0 then {1, 2} else {3, 4})*{1, 10}", 21.0),
        ("(if x > 0 then world.x else world.y)*{1, 10, 0}", 1.0),
        ("noEvent(if x > 0 then 1 else 0) + smooth(1, x)", 1 + X),
        ("value(90 deg, \"deg\") + value(300 K, \"degC\") + value(2 m, \"m\")", 90 + 26.85 + 2),
        ("(5 mm)/(1 m) + (2 s)*(5 /s)", 10.005),
        ("g_n/(1 m/s2)", 9.80665),
        ("atan2(x*(1 m), y*(1 m))", math.atan2(X, Y)),
        ("(if true then 1 else undeclared)", 1.0),
        ("(if 1 > 2 then undeclared elseif 2 > 1 then 5 else undeclared)", 5.0),
        ("sum(x for i in 1:0) + product(x for i in 1:0)", 1.0),
        ("((1 N/m)*sum((1 m)^2 for i in 1:0)*2 + 3 J)/(1 J)", 3.0),
        ("(4 m2)^(1/2)/(1 m) + (4 m2)^0.5/(1 m) + (8 m3)^(-1/3)*(1 m)", 4.5),
        ("(if x > 0 then 0 else {1, 2})*{1, 1}", 0.0),
        ("({x, y} - 0)*{1, 1} + (0 - {x, y})*{1, 0}", Y),
        ("(world.x + 0)*world.x + (0 - world.y)*world.y + (0 + world.x)*world.x", 1.0),
    ],
)  # fmt: skip
def test_value(text: str, expected: float) -> None:
    assert value_of(text, x=X, y=Y) == pytest.approx(expected, rel=1e-13, abs=1e-13)


def test_norm_squared_has_no_root() -> None:
    flat = accepted("output Area a = norm({l*theta, l})^2;")
    assert isinstance(output(flat, "a"), fx.Dot)


def test_derivatives() -> None:
    flat = accepted(
        "output AngularVelocity w = der(theta), zero = der(m)/(1 kg);\n"
        "output AngularAcceleration a = der(der(theta));\noutput Velocity v[2] = der(l*{theta, 2});"
    )
    theta = fx.Variable("theta")
    assert output(flat, "w") == fx.Derivative(theta)
    assert output(flat, "a") == fx.Derivative(fx.Derivative(theta))
    assert output(flat, "zero") == fx.Binary("/", fx.ZERO, fx.ONE)
    values = Values(variables={"theta": 0.3}, rates={"theta": 2.0})
    assert evaluate(flat, output(flat, "v[1]"), values) == pytest.approx(1.0)


def test_dependent_parameters_follow_independent_ones() -> None:
    flat = accepted("parameter Length a = 2*l, b = 2 m;\nfinal parameter Length c = 3 m;\noutput Length s = a + b + c;")
    assert [p.name for p in flat.parameters] == ["m", "l", "b"]
    definitions = {d.name: d for d in flat.named if isinstance(d, fm.Definition)}
    assert definitions["a"].variability is fm.Variability.PARAMETER
    assert definitions["c"].value == fx.Number(3.0)


def test_definition_of_parameters_only_has_their_variability() -> None:
    flat = accepted("Inertia J = m*l^2;\nLength h = l*cos(theta);\nReal one = 1;\noutput Real r = J/(m*h^2) + one;")
    variability = {d.name: d.variability for d in flat.named if isinstance(d, fm.Definition)}
    assert variability == {
        "J": fm.Variability.PARAMETER,
        "h": fm.Variability.CONTINUOUS,
        "one": fm.Variability.PARAMETER,
    }


def test_plain_real_takes_the_dimension_of_its_binding() -> None:
    flat = accepted("Real f = m*l/(1 s2);\noutput Real r = f;")
    assert [(o.unit, d.unit) for o in flat.outputs for d in flat.named if isinstance(d, fm.Definition)] == [("N", "N")]


@pytest.mark.parametrize("lengths", ["size = {l, -1 cm, 0}", "size = {-1 m, 1 m, 1 m}", "height = -1 cm"])
def test_shapes_have_no_length_below_zero(lengths: str) -> None:
    """Lengths in braces were not looked at."""
    text = f"model A parameter Length l = 1 m; coordinate Length x; draw box({lengths}) on world.move({{x, l}}); end A;"
    assert [code for code, _ in said(run(text)[1])] == ["E0334"]
    assert said(run(text.replace("-1", "1"))[1]) == []


DRAWINGS = {
    "sphere(coils = 3) at P": "`draw sphere at P` has no argument `coils`",
    "sphere(vector = {1, 0, 0}) on F": "`draw sphere on F` has no argument `vector`",
    "box(length = 1 m) from P to Q": "`draw box from A to B` has no argument `length`",
    "box(size = 1 m, width = 1 m) at P": "`draw box(size = ...)` has no argument `width`",
    "disc(length = 1 m, height = 1 m) on F": "`draw disc(length = ...)` has no argument `height`",
    "cylinder(axis = F.x) on F": "`axis` is given in the frame's own axes, this is a vector in world axes",
    "damper(radius = 1 m) from P to Q": "`draw damper from A to B` has no argument `radius`",
    'trace(text = "a") at P': "`draw trace at P` has no argument `text`",
    "sphere from P to Q": "`draw sphere` needs a place: `at P` or `on F`",
    "rod at P": "`draw rod` needs a place: `from A to B`",
    'mesh(file = "a.stl") at P': "`draw mesh` needs a place: `on F`",
    "arrow at P": "`draw arrow` needs a vector",
    "gear(radius = l) on F": "`draw gear` needs the number of its teeth",
    "gear(teeth = -3) on F": "`teeth` must be between 4 and 400 in size, found -3",
    "gear(teeth = x) on F": "an index must be known when the model is compiled",
    "arrow(vector = l) at P": "`vector` must be a vector, found l",
    "sphere(radius = {1 m, 1 m, 1 m}) at P": "`radius` must be a length, found {1 m, 1 m, 1 m}",
    'sphere(radius = "l") at P': '`radius` must be a length, found "l"',
    "sphere(color = 3) at P": "`color` must be a text in quotes, found 3",
}


@together("drawing", DRAWINGS)
def test_arguments_and_places_of_shapes_that_have_no_effect(drawing: str) -> None:
    """A viewer drew something else, and nothing was said."""
    text = f"""model A
  parameter Length l = 1 m;
  coordinate Length x;
  point P = {{x, l}}, Q = {{x, 2*l}};
  frame F = world.move({{x, l}});
  mass 1 kg at P;
  gravity = 0;
  draw {drawing};
  draw trace at P;
  draw trace at Q;
  draw trace on F;
end A;"""
    found = run(text)[1].diagnostics
    assert [each.message for each in found] == [DRAWINGS[drawing]]


def test_a_box_of_one_size_is_a_cube() -> None:
    flat = accepted("draw box(size = 2*l) on world;")
    ((role, value),) = flat.drawings[0].arguments
    assert role == "size" and isinstance(value, fx.Vector) and value.x == value.y == value.z


def test_order_is_by_need_and_stable() -> None:
    flat = accepted(
        "Length a = b;\nLength c = l;\nLength b = c + l;\npoint P = Q;\npoint Q = {a, b};\ndraw rod from P to Q;"
    )
    assert [item.name for item in flat.named] == ["c", "b", "a", "Q", "P"]


def test_condition_of_a_parameter_switches_the_value() -> None:
    flat = accepted(
        "parameter Boolean on = false;\nforce {1 N, 0} at {l*theta, 0} if on;\nkinetic m*(l*der(theta))^2 if not on;\n"
        "body b(m = 1, Izz = 2) on world.rotz(theta) if on;"
    )
    load = flat.loads[0]
    assert isinstance(load, fm.PointForce) and isinstance(load.force, fx.Conditional)
    assert load.force.otherwise == fx.ZERO_VECTOR
    assert isinstance(flat.energies[0].value, fx.Conditional)
    body = flat.bodies[0]
    assert isinstance(body.mass, fx.Conditional) and isinstance(body.inertia[2], fx.Conditional)
    assert body.inertia[0] == fx.ZERO


def test_structural_parameters_may_be_given_from_outside() -> None:
    text = "model A structural parameter Integer N = 2; structural parameter Real f = 1; coordinate Angle q[N];\n"
    text += "kinetic (1 J.s2)*f*sum(der(q[i])^2 for i in 1:N); end A;"
    flat, _ = run(text, structural={"N": 4.0, "f": 0.5})
    assert flat is not None and len(flat.coordinates) == 4
    assert {p.name: p.value for p in flat.parameters} == {"N": 4.0, "f": 0.5}
    _, sink = run(text, structural={"NN": 4.0})
    assert said(sink) == [("E0222", "")]


def test_choice_of_the_model() -> None:
    text = "model A coordinate Length x; potential (1 N)*x; end A;\n" * 1 + "partial model C end C;\n"
    text += "model B coordinate Angle y; potential (1 J)*y; end B;\nmodel D = A;\n"
    assert run(text)[0].name == "D"  # type: ignore[union-attr]
    assert run(text, model="A")[0].name == "A"  # type: ignore[union-attr]
    flat, sink = run(text, model="AA")
    assert flat is None and sink.diagnostics[0].code == "E0217" and "`A`" in (sink.diagnostics[0].help or "")
    assert "`B`" in (run(text, model="quite another")[1].diagnostics[0].help or "")
    assert run("type X = Real;", model="A")[1].diagnostics[0].help is None


def test_quaternion_starts_from_an_angular_velocity() -> None:
    flat = accepted(
        "coordinate Quaternion e(start = {0, 1, 0, 0}, omega(start = {1, 2, 3}, fixed = true));\n"
        "body b(m = 1) on world.quat(e);"
    )
    e = flat.coordinates[1:]
    assert [evaluate(flat, c.start, Values()) for c in e] == [0, 1, 0, 0]
    # e o (0, omega)/2 with e = i: i*(i + 2j + 3k)/2 = (-1 + 2k - 3j)/2
    assert [evaluate(flat, c.rate_start, Values()) for c in e] == [-0.5, 0, -1.5, 1]
    assert all(c.rate_fixed and c.rate_start_explicit and c.start_explicit for c in e)
    assert flat.constraints[0].normalisation and flat.constraints[0].rows == ("norm(e)",)


def test_array_of_quaternions() -> None:
    flat = accepted(
        "coordinate Quaternion e[2];\nbody b(m = 1) on world.quat(e[1]);\nbody c(m = 1) on world.quat(e[2]);"
    )
    assert [c.name for c in flat.coordinates[1:]] == [f"e[{i},{k}]" for i in (1, 2) for k in (1, 2, 3, 4)]
    assert [evaluate(flat, c.start, Values()) for c in flat.coordinates[1:]] == [1, 0, 0, 0, 1, 0, 0, 0]
    assert [c.rows for c in flat.constraints] == [("norm(e[1])",), ("norm(e[2])",)]


def test_rows_of_constraints_in_loops() -> None:
    flat = accepted(
        "coordinate Length x[2];\npotential (1 N)*sum(x);\nfor i in 1:2 loop\n constraint c: {x[i], x[i]} = {l, l};\n"
        " constraint d: der(x[i]) = 0;\nend for;\nconstraint x[1] = l;\n"
        "output Force f[4] = multiplier(c), g[2] = multiplier(c[2]), h = multiplier(d[1]);\n"
        "output Real all[2] = multiplier(d)/(1 N);"
    )
    assert [c.rows for c in flat.constraints] == [
        ("c[1,1]", "c[1,2]"), ("d[1]",), ("c[2,1]", "c[2,2]"), ("d[2]",), ("constraint_1",),
    ]  # fmt: skip
    assert [c.level for c in flat.constraints] == ["position", "velocity", "position", "velocity", "position"]
    assert output(flat, "g[1]") == fx.Multiplier("c[2,1]") and output(flat, "h") == fx.Multiplier("d[1]")


def test_an_undeclared_name_is_told_once() -> None:
    _, sink = pendulum("force -k*theta on theta;\ntorque -k*theta on theta;\ntorque -kk*theta on theta;")
    assert said(sink) == [("E0201", "k"), ("E0201", "kk")]


def test_notes_of_literals_that_hide_variables() -> None:
    _, sink = pendulum(
        "parameter Time s = 1 s;\noutput Length x = l + 2 m/s;\noutput Time y = s + 2 /s;\noutput Time z = s + 2 m2;"
    )
    notes = [d.notes for d in sink.diagnostics]
    assert ["2*m/s" in notes[0][0], "2/s" in notes[1][0], "2*m^2" in notes[2][0]] == [True] * 3


def test_factor_that_is_missing_is_named() -> None:
    def help_of(body: str) -> str | None:
        return pendulum(body)[1].diagnostics[0].help

    assert "`m*g_n`" in (help_of("potential m*g_n*l + l;") or "")
    assert "the first term" in (help_of("potential l + m*g_n*l;") or "")
    assert "`l^2`" in (help_of("output Real x = 1 m2 + theta;") or "")
    assert (help_of("output Real x = 1 A + 1 K;") or "").startswith("check the formula")
