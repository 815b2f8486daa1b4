"""Dependencies of flat expressions."""

import pytest
from choice import together
from handmade import coordinate, definition, der, frame, model, num, op, plus, point, sin, square, var, vec

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.traversal import operands, postorder

Q, R, S = var("q"), var("r"), var("s")
FLAT = model(
    coordinates=tuple(map(coordinate, "qrs")),
    named=(
        definition("d", square(Q)),
        point("P", vec(var("d"), R)),
        frame("A", "world", fm.Rotate(2, Q), fm.Move((R, num(0), num(0)))),
        frame("B", "A", fm.RotateAbout((num(0), num(1), num(0)), S), fm.Place(fx.PointReference("P"))),
        frame("C", "world", fm.RotateQuaternion((Q, R, S, num(1)))),
        frame("D", "world", fm.SetAxes(fx.FrameAxis("A", 0), fx.FrameAxis("A", 1), fx.FrameAxis("world", 2))),
    ),
)
P = fx.PointReference("P")


@together(
    ("expression", "orders"),
    [
        (num(1), {}),
        (fx.TIME, {"time": 0}),
        (plus(Q, der(Q), R), {"q": 1, "r": 0}),
        (der(der(var("d"))), {"q": 2}),
        (P, {"q": 0, "r": 0}),
        (fx.PointReference("nobody"), {}),
        (der(P), {"q": 1, "r": 1}),
        (fx.FrameOrigin("A"), {"q": 0, "r": 0}),
        (fx.FrameAxis("A", 0), {"q": 0}),
        (fx.FrameAxis("B", 0), {"q": 0, "s": 0}),
        (fx.AngularVelocity("B"), {"q": 1, "s": 1}),
        (fx.AngularVelocity("C"), {"q": 1, "r": 1, "s": 1}),
        (fx.AngularVelocity("D"), {"q": 1}),
        (fx.AngularVelocity("world"), {}),
        (fx.MaterialVelocity(vec(S, num(0)), "A"), {"s": 0, "q": 1, "r": 1}),
        (fx.SystemEnergy("total"), {}),
        (fx.ReactionAlong("P", vec(S, num(0))), {"s": 0}),
        (fx.AngularMomentum(None, P), {"q": 0, "r": 0}),
        (fx.Conditional(op("<", Q, num(0)), fx.Norm(P, "P"), sin(S)), {"q": 0, "r": 0, "s": 0}),
    ],
)
def test_orders(expression, orders):
    assert Dependence(FLAT).of(expression) == orders


def test_of_frames():
    dependence = Dependence(FLAT)
    assert dependence.of_frame("B") == {"q": 0, "r": 0, "s": 0}
    assert dependence.of_frame("B", turning_only=True) == {"q": 0, "s": 0}
    assert dependence.of_frame("world") == {}


@pytest.mark.parametrize(
    "leaf",
    [fx.Multiplier("c"), fx.FrameReaction("A", "force"), fx.GeneralizedMomentum("q"), fx.LinearMomentum()],
)
def test_leaves(leaf):
    assert operands(leaf) == ()


def test_postorder_visits_shared_nodes_once_and_operands_first():
    shared = square(Q)
    root = op("+", shared, op("*", shared, R))
    nodes = list(postorder(root))
    assert len(nodes) == len({id(node) for node in nodes})
    assert nodes.index(shared) < nodes.index(root) and nodes[-1] is root
    assert list(postorder(root, {id(root)})) == []
