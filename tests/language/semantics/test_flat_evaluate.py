"""The numeric interpreter against formulas written out by hand."""

import math

import numpy as np
import pytest
from choice import together
from handmade import (
    call,
    coordinate,
    cos,
    definition,
    der,
    frame,
    model,
    num,
    op,
    parameter,
    plus,
    point,
    sin,
    square,
    times,
    var,
    vec,
)
from hypothesis import given
from hypothesis import strategies as st

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.evaluate import Evaluator, ManyEvaluator, NotEvaluable, Values, evaluate

Q = var("q")
EMPTY = model(coordinates=(coordinate("q"), coordinate("r")), parameters=(parameter("l", 2.0),))


def at(expression, q=0.7, qd=1.3, qdd=0.4, flat=EMPTY, **variables):
    """The value at one moment, which is also that of the first of two moments."""
    values = Values(variables={"q": q, **variables}, rates={"q": qd}, accelerations={"q": qdd})
    other = Values(variables={"q": -q, **variables}, rates={"q": 2.0}, accelerations={"q": 0.0})
    found = evaluate(flat, expression, values)
    first = ManyEvaluator(flat, [values, other]).scalar(expression)[0]
    if math.isfinite(found):
        assert first == pytest.approx(found, rel=1e-12, abs=1e-15)
    else:
        assert not math.isfinite(first)
    return found


@together(
    ("name", "x", "value", "slope"),
    [
        ("sin", 0.7, math.sin(0.7), math.cos(0.7)),
        ("cos", 0.7, math.cos(0.7), -math.sin(0.7)),
        ("tan", 0.7, math.tan(0.7), 1 / math.cos(0.7) ** 2),
        ("asin", 0.7, math.asin(0.7), 1 / math.sqrt(1 - 0.49)),
        ("acos", 0.7, math.acos(0.7), -1 / math.sqrt(1 - 0.49)),
        ("atan", 0.7, math.atan(0.7), 1 / 1.49),
        ("sinh", 0.7, math.sinh(0.7), math.cosh(0.7)),
        ("cosh", 0.7, math.cosh(0.7), math.sinh(0.7)),
        ("tanh", 0.7, math.tanh(0.7), 1 / math.cosh(0.7) ** 2),
        ("exp", 0.7, math.exp(0.7), math.exp(0.7)),
        ("log", 0.7, math.log(0.7), 1 / 0.7),
        ("sqrt", 0.7, math.sqrt(0.7), 0.5 / math.sqrt(0.7)),
        ("abs", -0.7, 0.7, -1.0),
        ("sign", -0.7, -1.0, 0.0),
        ("floor", 1.7, 1.0, 0.0),
        ("ceil", 1.2, 2.0, 0.0),
    ],
)
def test_functions_and_their_time_derivatives(name, x, value, slope):
    assert at(call(name, Q), q=x) == pytest.approx(value, rel=1e-14)
    assert at(der(call(name, Q)), q=x) == pytest.approx(1.3 * slope, rel=1e-13)


@pytest.mark.parametrize("x", [(1.0, 2.0), (-1.0, 2.0), (-1.0, -2.0), (0.0, 0.0)])
def test_two_argument_functions(x):
    a, b = x
    for name, value in (("atan2", math.atan2(a, b)), ("min", min(a, b)), ("max", max(a, b))):
        assert at(call(name, Q, num(b)), q=a) == value
    assert at(call("mod", num(-1.5), num(4))) == 2.5
    assert math.isnan(at(call("mod", num(1), num(0))))
    slope = b / (a * a + b * b) if a or b else 0.0
    assert at(der(call("atan2", Q, num(b))), q=a) == pytest.approx(1.3 * slope)


@together(
    ("operator", "value"),
    list({"+": 5, "-": -1, "*": 6, "/": 2 / 3, "^": 8, "<": 1, "<=": 1, ">": 0, ">=": 0, "==": 0, "<>": 1}.items()),
)
def test_operators(operator, value):
    assert at(op(operator, num(2), num(3))) == pytest.approx(value)


def test_choice_and_logic():
    assert [at(op("and", num(1), num(x))) for x in (0, 1)] == [0.0, 1.0]
    assert [at(op("or", num(0), num(x))) for x in (0, 1)] == [0.0, 1.0]
    chosen = fx.Conditional(op("<", Q, num(1)), num(10), num(20))
    assert (at(chosen, q=0.5), at(chosen, q=1.5)) == (10.0, 20.0)
    assert at(fx.Unary("not", num(0))) == 1.0


@together(
    "expression",
    [
        op("/", num(1), num(0)),
        call("sqrt", num(-1)),
        call("log", num(-1)),
        call("log", num(0)),
        call("asin", num(2)),
        call("exp", num(1e6)),
        op("^", num(-1), num(0.5)),
        op("^", num(0), num(-1)),
        op("^", num(10), num(1000)),
        op("^", num(2), num(math.inf)),
        call("floor", num(math.nan)),
    ],
)
def test_outside_the_domain_is_nan(expression):
    assert math.isnan(at(expression))


def test_powers_of_negative_numbers():
    assert at(op("^", num(-2), num(3))) == -8.0
    assert at(op("^", num(-2), num(-3))) == -0.125
    assert at(op("^", num(4), num(0.5))) == 2.0


def test_derivatives_of_definitions_states_inputs_and_time():
    state = fm.State(
        name="z", dimension=EMPTY.coordinates[0].dimension, start=num(0), start_explicit=False, fixed=False,
        derivative=times(num(3), Q), spans=(),
    )  # fmt: skip
    smooth = [
        fm.Input(name=name, dimension=state.dimension, default=num(0), smooth=1, derivative_of=of, spans=())
        for name, of in (("u", None), ("der(u)", "u"))
    ]
    flat = model(
        coordinates=(coordinate("q"),),
        states=(state,),
        inputs=tuple(smooth),
        named=(definition("area", square(Q)), definition("twice", times(num(2), var("area")))),
    )
    assert at(der(var("twice")), flat=flat) == pytest.approx(2 * 2 * 0.7 * 1.3)
    assert at(der(var("z")), flat=flat) == pytest.approx(2.1)
    assert at(der(times(var("z"), var("z"))), flat=flat, z=2.0) == pytest.approx(2 * 2.0 * 2.1)
    assert at(der(square(var("u"))), flat=flat, u=3.0, **{"der(u)": 5.0}) == pytest.approx(30.0)
    assert at(der(square(fx.TIME)), flat=flat, time=4.0) == pytest.approx(8.0)
    assert at(der(der(Q)), flat=flat) == 0.4
    assert at(der(times(Q, der(Q))), flat=flat) == pytest.approx(1.3**2 + 0.7 * 0.4)


def test_the_equation_of_a_state_may_read_rates_of_definitions():
    """z' = 2 q q' + z with z = 0.5; (z^2)' = 2 z z'."""
    rate = plus(der(var("area")), var("z"))
    state = fm.State(
        name="z", dimension=EMPTY.coordinates[0].dimension, start=num(0), start_explicit=False, fixed=False,
        derivative=rate, spans=(),
    )  # fmt: skip
    flat = model(coordinates=(coordinate("q"),), states=(state,), named=(definition("area", square(Q)),))
    assert at(der(square(var("z"))), flat=flat, z=0.5) == pytest.approx(2 * 0.5 * (2 * 0.7 * 1.3 + 0.5))


def test_velocities_of_points_and_frames():
    arm = vec(times(var("l"), sin(Q)), times(var("l"), fx.Unary("-", cos(Q))))
    flat = model(
        parameters=(parameter("l", 2.0),),
        coordinates=(coordinate("q"),),
        named=(
            point("P", arm),
            frame("A", "world", fm.Rotate(2, Q), fm.Move((var("l"), fx.ZERO, fx.ZERO))),
            frame("B", "A", fm.RotateAbout((fx.ZERO, num(3), fx.ZERO), Q)),
            frame("C", "world", fm.Place(vec(Q, num(1))), fm.RotateQuaternion((cos(Q), fx.ZERO, sin(Q), fx.ZERO))),
            frame("D", "world", fm.SetAxes(fx.FrameAxis("A", 1), fx.FrameAxis("A", 2), fx.FrameAxis("A", 0))),
        ),
    )
    q, qd = 0.7, 1.3
    evaluator = Evaluator(flat, Values(variables={"q": q}, rates={"q": qd}))
    np.testing.assert_allclose(
        evaluator.vector(der(fx.PointReference("P"))), 2 * qd * np.array([math.cos(q), math.sin(q), 0]), atol=1e-14
    )
    np.testing.assert_allclose(evaluator.vector(fx.FrameOrigin("A")), [2 * math.cos(q), 2 * math.sin(q), 0], atol=1e-14)
    np.testing.assert_allclose(evaluator.vector(fx.AngularVelocity("A")), [0, 0, qd], atol=1e-13)
    # omega of B: qd about z of the world plus qd about the turned y axis.
    expected = qd * np.array([-math.sin(q), math.cos(q), 1])
    np.testing.assert_allclose(evaluator.vector(fx.AngularVelocity("B")), expected, atol=1e-13)
    # The quaternion (cos q, 0, sin q, 0) turns by 2 q about y.
    np.testing.assert_allclose(evaluator.vector(fx.AngularVelocity("C")), [0, 2 * qd, 0], atol=1e-13)
    np.testing.assert_allclose(
        evaluator.vector(fx.FrameAxis("C", 0)), [math.cos(2 * q), 0, -math.sin(2 * q)], atol=1e-14
    )
    np.testing.assert_allclose(evaluator.vector(fx.FrameAxis("D", 2)), [math.cos(q), math.sin(q), 0], atol=1e-14)
    carried = evaluator.vector(fx.MaterialVelocity(vec(num(1), num(1)), "C"))
    np.testing.assert_allclose(carried, [qd, 0, -2 * qd * (1 - q)], atol=1e-13)
    origin, axes = evaluator.frame("world")
    assert not origin.any() and (axes == np.eye(3)).all()
    speed = fx.Norm(der(fx.PointReference("P")), "P")
    assert evaluator.scalar(speed) == pytest.approx(2 * qd)
    assert evaluator.scalar(fx.Dot(fx.PointReference("P"), fx.PointReference("P"))) == pytest.approx(4.0)
    turned = fx.Cross(fx.FrameAxis("world", 2), fx.PointReference("P"))
    assert evaluator.scalar(fx.Component(turned, 0)) == pytest.approx(2 * math.cos(q))
    halved = op("/", fx.Unary("-", fx.PointReference("P")), num(2))
    np.testing.assert_allclose(evaluator.vector(halved), [-math.sin(q), math.cos(q), 0], atol=1e-14)
    assert np.isnan(evaluator.vector(op("/", fx.PointReference("P"), num(0)))).all()
    moments = [Values(variables={"q": each}, rates={"q": qd}) for each in (q, 2 * q, 3 * q)]
    many = ManyEvaluator(flat, moments)
    vectors = [der(fx.PointReference("P")), *map(fx.AngularVelocity, "ABCD"), fx.FrameAxis("world", 1), turned, halved]
    for vector in [*vectors, fx.MaterialVelocity(vec(num(1), num(1)), "C"), vec(num(1), Q), op("/", turned, Q)]:
        expected = [Evaluator(flat, each).vector(vector) for each in moments]
        np.testing.assert_allclose(many.vector(vector).T, expected, atol=1e-13)
    for scalar in (speed, fx.Component(turned, 0), fx.Dot(fx.FrameAxis("world", 0), fx.PointReference("P")), num(2)):
        assert many.scalar(scalar) == pytest.approx([Evaluator(flat, each).scalar(scalar) for each in moments])
    for name in ("world", "A", "B", "C", "D"):
        origin, axes = many.frame(name)
        for k, each in enumerate(moments):
            expected_origin, expected_axes = Evaluator(flat, each).frame(name)
            np.testing.assert_allclose(origin[:, k], expected_origin, atol=1e-14)
            np.testing.assert_allclose(axes[:, :, k], expected_axes, atol=1e-14)


@pytest.mark.parametrize("expression", [fx.SystemEnergy("total"), var("nobody"), der(square(der(square(Q))))])
def test_what_it_refuses(expression):
    with pytest.raises(NotEvaluable):
        at(expression)


def test_long_sums_need_no_deep_recursion():
    assert at(plus(*[Q] * 20_000), q=0.5) == pytest.approx(10_000)


@given(st.floats(-3, 3), st.floats(-3, 3), st.floats(-3, 3))
def test_frames_stay_orthonormal(a, b, c):
    e = (var("a"), var("b"), var("c"), num(1))
    flat = model(
        coordinates=tuple(map(coordinate, "abc")),
        named=(
            frame("A", "world", fm.Rotate(0, var("a")), fm.Rotate(1, var("b")), fm.RotateQuaternion(e)),
            frame("B", "A", fm.RotateAbout((num(1), num(2), num(-2)), var("c"))),
        ),
    )
    axes = Evaluator(flat, Values(variables={"a": a, "b": b, "c": c})).frame("B")[1]
    np.testing.assert_allclose(axes.T @ axes, np.eye(3), atol=1e-13)
    assert np.linalg.det(axes) == pytest.approx(1.0)
