"""`lag flat`: every kind of item has its line."""

import dataclasses

from handmade import (
    at_line,
    body,
    coordinate,
    definition,
    der,
    energy,
    frame,
    invariant,
    mass,
    model,
    num,
    op,
    parameter,
    point,
    square,
    times,
    var,
    vec,
)

from lagdsl.foundation.units.dimension import DIMENSIONLESS, LENGTH
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.text import flat_text

Q = var("q")
P = fx.PointReference("P")

FULL = model(
    doc="all of it",
    parameters=(
        parameter("m", 0.5, minimum=0.0),
        parameter("n", 3.0, structural=True, type_name="Integer"),
        parameter("on", 1.0, kind="Boolean", type_name="Boolean"),
        parameter("off", 0.0, kind="Boolean", type_name="Boolean"),
        parameter("file", 0.0, kind="String", text="a.csv", type_name="String"),
    ),
    coordinates=(
        coordinate(
            "q", unit="rad", display_unit="deg", type_name="Angle", start=0.7853981633974483, fixed=True, doc="turn",
            minimum=-1.0, maximum=1.0, nominal=0.1,
        ),
        coordinate("r", line=3, rate_start=num(2), rate_start_explicit=True, rate_fixed=True),
    ),
    states=(
        fm.State(
            name="z", dimension=DIMENSIONLESS, start=num(1), start_explicit=True, fixed=True, derivative=Q,
            spans=at_line(20),
        ),
    ),
    inputs=(
        fm.Input(name="u", dimension=DIMENSIONLESS, default=num(0), stated=True, smooth=2, spans=at_line(21)),
    ),
    named=(
        definition("d", square(Q)),
        point("P", vec(Q, num(1))),
        frame("A", "world", fm.Rotate(2, Q), fm.RotateAbout((num(0), num(1), num(0)), Q), fm.Move((Q, num(0), num(0)))),
        frame("B", "A", fm.RotateQuaternion((Q, Q, Q, Q)), fm.Place(P)),
        frame("C", "world", fm.SetAxes(fx.FrameAxis("A", 1), fx.FrameAxis("A", 2), fx.FrameAxis("A", 0))),
    ),
    masses=(mass(var("m"), P),),
    bodies=(body("A", var("m"), (num(1),) * 3), body("A", var("m"), (), label=None)),
    gravity=vec(num(0), num(-9.81)),
    energies=(
        energy("kinetic", square(der(Q)), label="T"),
        energy("potential", Q),
        energy("dissipation", square(der(Q)), label="D"),
    ),
    loads=(
        fm.PointForce(
            label="F", force=vec(Q, Q), point=P, frame="A", origin=P, origin_frame="B", spans=at_line(22)
        ),
        fm.PointForce(label=None, force=P, point=P, frame=None, origin=None, origin_frame=None, spans=at_line(23)),
        fm.FrameTorque(label=None, torque=P, frame="A", origin="B", spans=at_line(24)),
        fm.FrameTorque(label=None, torque=P, frame="A", origin=None, spans=at_line(25)),
        fm.GeneralizedForce(label=None, keyword="torque", value=Q, target=Q, origin=None, spans=at_line(26)),
        fm.GeneralizedForce(label=None, keyword="force", value=Q, target=Q, origin=var("r"), spans=at_line(27)),
    ),
    constraints=(
        fm.Constraint(
            name="pin", rows=("pin[1]", "pin[2]"), residuals=(Q, op("-", Q, var("r"))), dimension=LENGTH,
            level="position", spans=at_line(28),
        ),
        fm.Constraint(
            name="e", rows=("e",), residuals=(Q,), dimension=DIMENSIONLESS, level="position", normalisation=True,
            spans=at_line(29),
        ),
    ),
    outputs=(
        fm.Output(name="y", dimension=DIMENSIONLESS, value=fx.Multiplier("pin[1]"), doc="push", spans=at_line(30)),
    ),
    invariants=(invariant("E", fx.SystemEnergy("total"), 1e-9), invariant("H", fx.SystemEnergy("jacobi"))),
    initial_equations=(fm.InitialEquation(residual=der(Q), dimension=DIMENSIONLESS, spans=at_line(31)),),
    assertions=(fm.Assertion(condition=op("<", Q, num(1)), message="too\nfar", spans=at_line(32)),),
    drawings=(
        fm.Drawing(
            shape="rod", arguments=(("radius", num(0.1)), ("color", "red")), place="between",
            anchors=(fx.FrameOrigin("world"), P), spans=at_line(33),
        ),
        fm.Drawing(shape="disc", arguments=(), place="on", anchors=("A",), spans=at_line(34)),
    ),
    experiment=fm.Experiment(interval=0.01),
)  # fmt: skip


def lines(flat):
    return [line.split("  //")[0].strip() for line in flat_text(flat).splitlines()]


def test_every_item_has_its_line():
    shown = lines(FULL)
    for expected in (
        'model Hand  "all of it"',
        "Angle q [rad, shown in deg], start = 0.7853981633974483 (45 deg), fixed, min = -1, max = 1, nominal = 0.1"
        '  "turn"',
        "Real r [1], start = 0.3, der start = 2, der fixed",
        "mass m at P",
        "body plate(m = m, com = {0, 0, 0}, I = {1, 1, 1, 0, 0, 0}) on A",
        "body(m = m, com = {0, 0, 0}, I = {0, 0, 0, 0, 0, 0}) on A",
        "gravity = {0, -9.81, 0}",
        "kinetic T = der(q)^2",
        "potential q",
        "dissipation D = der(q)^2",
        "force F = {q, q, 0} at P on A from P on B",
        "force P at P",
        "torque P on A from B",
        "torque P on A",
        "torque q on q",
        "force q on q from r",
        "pin[1] [m, position]: 0 = q",
        "pin[2] [m, position]: 0 = q - r",
        "e [1, unit length]: 0 = q",
        "Real z [1], start = 1, fixed, der(z) = q",
        "Real u [1], default = 0, smooth = 2",
        "Real m [1] = 0.5, min = 0",
        "structural Integer n [1] = 3",
        "Boolean on [1] = true",
        "Boolean off [1] = false",
        'String file [1] = "a.csv"',
        "Real d [1] = q^2",
        "point P = {q, 1, 0}",
        "frame A = world.rotz(q).rotate({0, 1, 0}, q).move({q, 0, 0})",
        "frame B = A.quat({q, q, q, q}).at(P)",
        "frame C = world.axes(A.y, A.z, A.x)",
        'Real y [1] = multiplier(pin[1])  "push"',
        "E [J]: energy() with tol = 1e-09",
        "H [J]: jacobi_integral()",
        "0 = der(q)",
        'assert(q < 1, "too\\x0afar")',
        "rod(radius = 0.1, color = red) from world.origin to P",
        "disc on A",
        "0 to 10 s, tolerance 1e-08, interval 0.01 s",
    ):
        assert expected in shown
    titles = [line for line in flat_text(FULL).splitlines() if line.endswith(":")]
    assert titles[:6] == ["q:", "L:", "D:", "Q:", "constraints:", "states:"]


def test_places_stand_beside_the_items():
    text = flat_text(FULL)
    assert "  gravity = {0, -9.81, 0}" in text
    assert any(line.startswith("  mass m at P ") and line.endswith("// hand.lag:6") for line in text.splitlines())


def test_empty_lists():
    assert flat_text(model(experiment=fm.Experiment(stop_time=1.0))) == (
        "model Hand\n\nq: none\n\nL: none\n\nD: none\n\nQ: none\n\nconstraints: none\n\n"
        "experiment:\n  0 to 1 s, tolerance 1e-08\n"
    )


def test_very_long_items_do_not_push_the_others_away():
    long = energy("potential", times(*[Q] * 200))
    text = flat_text(dataclasses.replace(FULL, energies=(long, energy("potential", Q, line=9))))
    (short,) = [line for line in text.splitlines() if line.startswith("  potential q  ")]
    assert len(short) < 100
