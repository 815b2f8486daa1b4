"""Flat expressions print with the parentheses they need and no others."""

import re
from fractions import Fraction

from choice import together
from handmade import call, cos, der, num, op, plus, square, times, var, vec
from hypothesis import given
from hypothesis import strategies as st

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.expression_text import flat_expression_text, number_text

A, B, C = var("a"), var("b"), var("c")


def neg(x):
    return fx.Unary("-", x)


@together(
    ("expression", "text"),
    [
        (op("-", A, op("-", B, C)), "a - (b - c)"),
        (op("-", op("-", A, B), C), "a - b - c"),
        (times(plus(A, B), C), "(a + b)*c"),
        (op("/", A, times(B, C)), "a/(b*c)"),
        (times(op("/", A, B), C), "a/b*c"),
        (square(neg(A)), "(-a)^2"),
        (neg(square(A)), "-a^2"),
        (neg(plus(A, B)), "-(a + b)"),
        (neg(times(A, B)), "-(a*b)"),
        (times(neg(A), B), "-a*b"),
        (op("^", A, op("^", B, C)), "a^b^c"),
        (op("^", op("^", A, B), C), "(a^b)^c"),
        (op("^", A, neg(B)), "a^-b"),
        (op("^", A, num(-1)), "a^-1"),
        (op("^", A, op("/", B, C)), "a^(b/c)"),
        (op("^", num(-1), A), "(-1)^a"),
        (op("<", plus(A, B), C), "a + b < c"),
        (op("==", op("<", A, B), C), "(a < b) == c"),
        (op("and", op("or", A, B), fx.Unary("not", C)), "(a or b) and not c"),
        (fx.Unary("not", op("and", A, B)), "not (a and b)"),
        (op("or", op("and", A, B), C), "a and b or c"),
        (fx.Conditional(A, B, fx.Conditional(B, A, C)), "if a then b else if b then a else c"),
        (fx.Conditional(A, fx.Conditional(B, A, C), C), "if a then (if b then a else c) else c"),
        (plus(fx.Conditional(A, B, C), C), "(if a then b else c) + c"),
        (der(der(A)), "der(der(a))"),
        (call("atan2", A, plus(B, C)), "atan2(a, b + c)"),
        (vec(cos(A), num(2)), "{cos(a), 2, 0}"),
        (fx.Component(fx.PointReference("P"), 1), "P.y"),
        (fx.Component(op("-", fx.FrameOrigin("F"), fx.FrameAxis("world", 2)), 0), "(F.origin - world.z).x"),
        (fx.Dot(fx.PointReference("P"), op("+", fx.PointReference("P"), vec(A, B))), "P*(P + {a, b, 0})"),
        (fx.Cross(fx.PointReference("P"), fx.AngularVelocity("F")), "cross(P, omega(F))"),
        (fx.Norm(fx.PointReference("P"), "P"), "norm(P)"),
        (fx.MaterialVelocity(fx.PointReference("P"), "F"), "vel(P, F)"),
        (fx.Multiplier("pin[2]"), "multiplier(pin[2])"),
        (fx.FrameReaction("F", "torque"), "reaction(F).torque"),
        (fx.ReactionAlong("P", fx.FrameAxis("F", 0)), "reaction(P, along = F.x)"),
        (fx.SystemEnergy("total"), "energy()"),
        (fx.SystemEnergy("kinetic"), "kinetic_energy()"),
        (fx.SystemEnergy("jacobi"), "jacobi_integral()"),
        (fx.GeneralizedMomentum("phi"), "momentum(phi)"),
        (fx.LinearMomentum(), "linear_momentum()"),
        (fx.AngularMomentum(None, fx.FrameOrigin("world")), "angular_momentum(about = world.origin)"),
        (fx.AngularMomentum("gyro", fx.PointReference("P")), "angular_momentum(gyro, about = P)"),
    ],
)
def test_text(expression, text):
    assert flat_expression_text(expression) == text


def test_numbers():
    assert [number_text(x) for x in (2.0, 9.81, 1e-9, -0.5, float("inf"))] == ["2", "9.81", "1e-09", "-0.5", "inf"]


def test_shared_expressions_do_not_explode():
    shared = plus(A, B)
    for _ in range(200):
        shared = times(shared, shared)
    assert len(flat_expression_text(shared)) < 100_000


def test_long_sums_need_no_deep_recursion():
    assert flat_expression_text(plus(*[A] * 3000)).count("a") == 3000


_LEAVES = st.sampled_from([A, B, num(2), num(3), num(0.5)])
_TREES = st.recursive(
    _LEAVES,
    lambda inner: (
        st.builds(op, st.sampled_from("+-*/"), inner, inner) | st.builds(neg, inner) | st.builds(square, inner)
    ),
    max_leaves=12,
)


class _Reader:
    """The grammar's arithmetic by recursive descent, for the test: text to value."""

    def __init__(self, text, values):
        self.tokens = re.findall(r"[a-z]+|[0-9.]+|[-+*/^()]", text)
        self.values = values

    def next(self):
        return self.tokens.pop(0)

    def peek(self):
        return self.tokens[0] if self.tokens else ""

    def sum(self):
        value = self.product()
        while self.peek() in ("+", "-"):
            value = value + self.product() if self.next() == "+" else value - self.product()
        return value

    def product(self):
        value = self.sign()
        while self.peek() in ("*", "/"):
            value = value * self.sign() if self.next() == "*" else value / self.sign()
        return value

    def sign(self):
        if self.peek() == "-":
            self.next()
            return -self.sign()
        return self.power()

    def power(self):
        value = self.atom()
        if self.peek() == "^":
            self.next()
            value = value ** self.power()
        return value

    def atom(self):
        token = self.next()
        if token == "(":
            value = self.sum()
            assert self.next() == ")"
            return value
        return self.values[token] if token.isalpha() else Fraction(token)


@given(_TREES)
def test_text_means_the_tree(tree):
    values = {"a": Fraction(7, 5), "b": Fraction(-3, 11)}
    try:
        expected = _value(tree, values)
    except ZeroDivisionError:
        return
    assert _Reader(flat_expression_text(tree), values).sum() == expected


def _value(tree, values):
    match tree:
        case fx.Number(value):
            return Fraction(value)
        case fx.Variable(name):
            return values[name]
        case fx.Unary(_, operand):
            return -_value(operand, values)
        case fx.Binary(operator, left, right):
            a, b = _value(left, values), _value(right, values)
            return {"+": lambda: a + b, "-": lambda: a - b, "*": lambda: a * b, "/": lambda: a / b, "^": lambda: a**b}[
                operator
            ]()
