"""Family 05 on flat models by hand."""

import dataclasses

import pytest
from choice import together
from handmade import (
    at_line,
    body,
    call,
    coordinate,
    cos,
    definition,
    der,
    energy,
    frame,
    mass,
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

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile, Span
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.semantics.wellformed.check import check

Q, R, M, L = var("q"), var("r"), var("m"), var("l")
ONE = num(1)
DOWN = vec(num(0), num(-9.81))
TIP = vec(times(L, sin(Q)), fx.Unary("-", times(L, cos(Q))))
PARAMETERS = (parameter("m", 0.5), parameter("l", 2.0), parameter("g", 9.81))
MOTION = energy("kinetic", square(der(Q)))
COIL = fm.Input(name="u", dimension=PARAMETERS[0].dimension, default=num(0), spans=())


def found(**parts):
    sink = Sink()
    given = {"coordinates": (coordinate("q"),), "parameters": PARAMETERS, **parts}
    check(model(**given), sink)
    return sink.diagnostics


def codes(**parts):
    return [diagnostic.code for diagnostic in found(**parts)]


def test_sound_models_draw_nothing():
    assert codes(energies=(MOTION, energy("potential", cos(Q)))) == []
    assert codes(masses=(mass(M, TIP),), gravity=DOWN) == []
    assert codes(masses=(mass(M, TIP),), gravity=fx.ZERO_VECTOR) == []


# ---- use and effect --------------------------------------------------------------------------------------------------


def test_unused_coordinate():
    (diagnostic,) = found(coordinates=(coordinate("q"), coordinate("phi", line=9)), energies=(MOTION,))
    assert (diagnostic.code, diagnostic.labels[0].span.first.line) == ("E0501", 9)
    assert "`phi`" in diagnostic.message


def force(**more):
    given = {"label": None, "force": DOWN, "point": fx.ZERO_VECTOR, "frame": None, "origin": None, "origin_frame": None}
    return fm.PointForce(spans=at_line(11), **{**given, **more})


def torque(**more):
    return fm.FrameTorque(spans=at_line(12), **{"label": None, "torque": DOWN, "frame": "A", "origin": None, **more})


def push(**more):
    given = {"label": None, "keyword": "force", "value": ONE, "target": R, "origin": None}
    return fm.GeneralizedForce(spans=at_line(13), **{**given, **more})


R_TURNS = (frame("A", "world", fm.Rotate(2, R)),)


@together(
    "parts",
    [
        {"loads": (force(point=vec(R, num(0))),)},
        {"loads": (force(point=vec(Q, num(0)), origin=vec(R, num(0))),)},
        {"loads": (force(frame="A"),), "named": R_TURNS},
        {"loads": (force(origin=fx.ZERO_VECTOR, origin_frame="A"),), "named": R_TURNS},
        {"loads": (torque(),), "named": R_TURNS},
        {"loads": (torque(frame="world", origin="A"),), "named": R_TURNS},
        {"loads": (push(),)},
        {"loads": (push(target=Q, origin=R),)},
        {"loads": (push(target=Q, value=R),)},
        {"masses": (mass(M, vec(R, num(0))),), "gravity": DOWN},
        {"bodies": (body("A", M, (ONE, ONE, ONE)),), "named": R_TURNS, "gravity": DOWN},
    ],
)
def test_any_physics_item_counts_as_use(parts):
    assert codes(coordinates=(coordinate("q"), coordinate("r")), energies=(MOTION,), **parts) == []


def test_constraints_and_states_count_but_not_normalisations_and_outputs():
    two = (coordinate("q"), coordinate("r"))
    row = {"name": "c", "rows": ("c",), "residuals": (op("-", Q, R),), "dimension": PARAMETERS[0].dimension}
    constraint = fm.Constraint(level="position", spans=(), **row)
    assert codes(coordinates=two, energies=(MOTION,), constraints=(constraint,)) == []
    unit = fm.Constraint(level="position", normalisation=True, spans=(), **row)
    output = fm.Output(name="y", dimension=row["dimension"], value=R, spans=())
    assert codes(coordinates=two, energies=(MOTION,), constraints=(unit,), outputs=(output,)) == ["E0501"]
    state = fm.State(
        name="z", dimension=row["dimension"], start=fx.ZERO, start_explicit=False, fixed=False, derivative=R, spans=()
    )
    assert codes(coordinates=two, energies=(MOTION,), states=(state,)) == []
    assert codes(coordinates=(), states=(state,), named=(definition("r", ONE),)) == []


def test_nothing_is_free_to_move():
    """The note counts: frames that coincide are one motion, one that another carries is none of its own."""
    (diagnostic,) = found(coordinates=(), energies=())
    assert diagnostic.code == "N0513" and diagnostic.labels[0].span.first.line == 1
    assert "nothing to compute" in diagnostic.message
    (bare,) = found(coordinates=(), parameters=())
    assert bare.labels == ()
    turn = fm.Rotate(2, fx.TIME)
    frames = (
        frame("A", "world", turn),
        frame("seat", "world", turn),
        frame("B", "A", fm.Move((ONE, fx.ZERO, fx.ZERO))),
        definition("phase", times(num(3), fx.TIME)),
        frame("C", "B", fm.Rotate(2, var("phase"))),
    )
    output = fm.Output(name="y", dimension=PARAMETERS[0].dimension, value=fx.TIME, spans=())
    (moved,) = found(coordinates=(), named=frames, outputs=(output,))
    assert moved.message.endswith("it has 2 prescribed motions and 1 output")


@pytest.mark.parametrize(
    "reading",
    [fx.Component(fx.FrameReaction("A", "force"), 0), fx.SystemEnergy("kinetic")],
    ids=["reaction", "energy"],
)
def test_a_driven_body_is_not_idle_if_its_reaction_or_energy_is_read(reading):
    turning = (frame("A", "world", fm.Rotate(2, fx.TIME)), frame("B", "A", fm.Move((ONE, fx.ZERO, fx.ZERO))))
    parts = {"energies": (MOTION,), "named": turning, "bodies": (body("B", M, (ONE, ONE, ONE)),), "gravity": DOWN}
    assert codes(**parts) == ["W0514"]
    output = fm.Output(name="y", dimension=PARAMETERS[0].dimension, value=reading, spans=())
    assert codes(**parts, outputs=(output,)) == []


@pytest.mark.parametrize(
    "parts",
    [
        {"masses": (mass(M, vec(der(Q), num(0))),), "gravity": DOWN},
        {"bodies": (body("A", M, ()),), "named": (frame("A", "world", fm.Rotate(2, der(Q))),), "gravity": DOWN},
        {"loads": (push(target=der(Q)),)},
        {"loads": (force(point=fx.PointReference("P")),), "named": (point("P", vec(der(Q), num(0))),)},
    ],
)
def test_positions_made_of_rates(parts):
    (diagnostic,) = found(energies=(MOTION,), **parts)
    assert diagnostic.code == "E0508" and "der(q)" in diagnostic.message


@pytest.mark.parametrize(
    ("parts", "keyword"),
    [
        ({"masses": (mass(M, vec(fx.TIME, num(0))),), "gravity": DOWN}, "mass"),
        ({"bodies": (body("world", M, ()),), "gravity": DOWN}, "body"),
        ({"loads": (force(),)}, "force"),
        ({"loads": (torque(frame="world"),)}, "torque"),
        ({"loads": (push(target=fx.TIME),)}, "force"),
        ({"energies": (MOTION, energy("potential", M))}, "potential"),
        ({"energies": (MOTION, energy("dissipation", square(Q)))}, "dissipation"),
    ],
)
def test_items_without_effect(parts, keyword):
    (diagnostic,) = found(**{"energies": (MOTION,), **parts})
    assert diagnostic.code == "W0514" and f"`{keyword}`" in diagnostic.message


# ---- energies --------------------------------------------------------------------------------------------------------

P = fx.PointReference("P")
SPEED = der(P)


@together(
    ("kind", "value", "expected"),
    [
        ("potential", times(Q, der(Q)), ["E0502"]),
        ("potential", der(der(Q)), ["E0512"]),
        ("kinetic", times(der(der(Q)), der(Q)), ["E0512"]),
        ("kinetic", op("^", der(Q), num(3)), ["E0504"]),
        ("kinetic", op("^", der(Q), num(4)), ["E0504"]),
        ("kinetic", call("abs", der(Q)), ["E0504"]),
        ("kinetic", op("/", ONE, der(Q)), ["E0504"]),
        ("kinetic", fx.Norm(plus(SPEED, vec(num(1), num(1))), "P"), ["E0504"]),
        ("kinetic", fx.Conditional(op("<", der(Q), num(0)), square(der(Q)), Q), ["E0504"]),
        ("kinetic", op("^", der(Q), Q), ["E0504"]),
        ("lagrangian", op("^", der(Q), num(4)), []),
        ("kinetic", fx.Dot(SPEED, SPEED), []),
        ("kinetic", square(fx.Norm(SPEED, "P")), []),
        ("kinetic", times(fx.Norm(SPEED, "P"), fx.Norm(SPEED, "P")), []),
        ("kinetic", square(call("sqrt", plus(square(der(Q)), square(Q)))), []),
        ("kinetic", square(call("abs", der(Q))), []),
        ("kinetic", plus(square(der(Q)), times(Q, der(Q)), Q), []),
        ("kinetic", op("/", op("-", square(der(Q)), Q), plus(ONE, square(Q))), []),
        ("kinetic", fx.Conditional(op("<", Q, num(0)), square(der(Q)), fx.Unary("-", der(Q))), []),
        ("kinetic", fx.Component(fx.Cross(SPEED, fx.AngularVelocity("A")), 0), []),
        ("kinetic", fx.Component(fx.MaterialVelocity(P, "A"), 0), []),
        ("kinetic", fx.Component(vec(der(Q), var("speed")), 1), []),
        ("kinetic", times(op("^", der(Q), num(3)), fx.SystemEnergy("total")), []),
        ("dissipation", op("^", der(Q), num(4)), []),
    ],
)
def test_forms_of_energies(kind, value, expected):
    named = (
        point("P", TIP),
        frame("A", "world", fm.Rotate(2, Q)),
        definition("speed", der(Q)),
    )
    assert codes(energies=(MOTION, energy(kind, value)), named=named) == expected


# ---- masses and inertias ---------------------------------------------------------------------------------------------

A = (frame("A", "world", fm.Rotate(2, Q)),)


@pytest.mark.parametrize(
    ("value", "name"), [(Q, "q"), (fx.TIME, "time"), (var("u"), "u"), (times(M, var("full")), "u")]
)
def test_changing_mass(value, name):
    named = (definition("full", var("u")),)
    (diagnostic,) = found(masses=(mass(value, TIP),), gravity=DOWN, inputs=(COIL,), named=named)
    assert diagnostic.code == "E0505" and f"`{name}`" in diagnostic.message


def test_negative_mass_and_moment():
    (negative,) = found(masses=(mass(op("-", M, ONE), TIP),), gravity=DOWN)
    assert negative.code == "E0506" and "-0.5 kg" in negative.message
    (moment,) = found(bodies=(body("A", M, (ONE, num(-1), ONE)),), named=A, gravity=DOWN)
    assert moment.code == "E0506" and "moment Iyy of body `plate`" in moment.message
    (unnamed,) = found(bodies=(body("A", num(-1), (), label=None),), named=A, gravity=DOWN)
    assert "the mass of body is negative" in unnamed.message


@pytest.mark.parametrize(
    ("inertia", "left", "right"),
    [
        ((1, 1, 3), "Ixx + Iyy", "Izz"),
        ((1, 3, 1), "Ixx + Izz", "Iyy"),
        ((3, 1, 1), "Iyy + Izz", "Ixx"),
        ((1, 1, 1, 0.9), "I1 + I2", "I3"),
    ],
)
def test_impossible_inertia(inertia, left, right):
    (diagnostic,) = found(bodies=(body("A", M, tuple(map(num, inertia))),), named=A, gravity=DOWN)
    assert diagnostic.code == "E0509"
    assert diagnostic.message == f"impossible inertia: {left} < {right} for body `plate`"


@pytest.mark.parametrize(
    "inertia",
    [(0.25, 0.5, 0.25), (0.1, 0.2, 0.3), (0, 0, 3), (1, 1, float("nan")), (1, 1, 1, 0.3, 0.2, -0.1)],
)
def test_possible_or_unstated_inertia(inertia):
    assert codes(bodies=(body("A", M, tuple(map(num, inertia))),), named=A, gravity=DOWN) == []


def test_one_cause_one_error():
    moments = (Q, num(-1), num(9))
    assert codes(bodies=(body("A", M, moments),), named=A, gravity=DOWN) == ["E0505"]


# ---- gravity ---------------------------------------------------------------------------------------------------------


def test_forgotten_gravity():
    (diagnostic,) = found(masses=(mass(M, TIP, line=14),))
    assert (diagnostic.code, diagnostic.labels[0].span.first.line) == ("W0510", 14)
    assert codes(bodies=(body("A", M, ()),), named=A) == ["W0510"]
    assert codes(bodies=(body("A", fx.ZERO, (ONE,) * 3),), named=A) == []
    assert codes(masses=(mass(M, TIP),), energies=(energy("potential", cos(Q)),)) == []
    assert codes(masses=(mass(M, TIP),), energies=(energy("lagrangian", cos(Q)),)) == []


def test_gravity_of_position():
    (diagnostic,) = found(masses=(mass(M, TIP),), gravity=vec(num(0), Q))
    assert (diagnostic.code, diagnostic.labels[0].span.first.line) == ("E0507", 8)
    assert codes(masses=(mass(M, TIP),), gravity=vec(num(0), fx.TIME)) == []


HEIGHT = times(M, var("g"), L, cos(Q))
SPRING = times(num(3), square(Q))


@together(
    ("potential", "twice"),
    [
        (fx.Unary("-", HEIGHT), True),
        (op("-", SPRING, HEIGHT), True),
        (op("-", times(M, var("g"), L), op("-", HEIGHT, SPRING)), True),
        (times(M, num(9.81), L, op("-", ONE, cos(Q))), True),
        (times(M, num(9.81), fx.Component(TIP, 1)), True),
        (SPRING, False),
        (HEIGHT, False),
        (times(num(0.5), HEIGHT), False),
        (op("-", times(M, num(9.80665), L, sin(Q)), M), False),
        (times(HEIGHT, call("sqrt", num(-1))), False),
        (times(HEIGHT, fx.SystemEnergy("total")), False),
        (op("/", ONE, call("sqrt", Q)), False),
    ],
)
def test_gravity_counted_twice(potential, twice):
    diagnostics = found(masses=(mass(M, TIP),), energies=(energy("potential", potential),), gravity=DOWN)
    assert [d.code for d in diagnostics] == (["W0511"] if twice else [])
    if twice:
        assert [label.span.first.line for label in diagnostics[0].labels] == [5, 8]
        assert diagnostics[0].labels[1].text == "already adds -m*g.r for `item`"


def test_a_long_statement_is_cut_in_the_label():
    span = Span(SourceFile("a.lag", "x" * 100 + ";"), 0, 101)
    heavy = dataclasses.replace(mass(M, TIP), spans=(span,))
    potential = energy("potential", fx.Unary("-", HEIGHT))
    (diagnostic,) = found(masses=(heavy,), energies=(potential,), gravity=DOWN)
    assert diagnostic.labels[1].text == f"already adds -m*g.r for `{'x' * 37}...`"
    (bare,) = found(masses=(dataclasses.replace(heavy, spans=()),), energies=(potential,), gravity=DOWN)
    assert bare.labels[1].text == "already adds -m*g.r for `mass`"


def test_gravity_twice_for_all_masses_together_and_for_bodies():
    second = plus(TIP, vec(times(L, sin(R)), fx.Unary("-", times(L, cos(R)))))
    masses = (mass(M, TIP), mass(ONE, second))
    together = fx.Unary("-", times(var("g"), L, plus(times(plus(M, ONE), cos(Q)), cos(R))))
    two = (coordinate("q"), coordinate("r"))
    assert codes(coordinates=two, masses=masses, energies=(energy("potential", together),), gravity=DOWN) == ["W0511"]
    com = (fx.ZERO, fx.Unary("-", L), fx.ZERO)
    hung = body("A", M, (), com=com)
    hand = energy("potential", fx.Unary("-", HEIGHT))
    assert codes(bodies=(hung,), named=A, energies=(hand,), gravity=DOWN) == ["W0511"]
    balanced = (mass(M, TIP), mass(M, fx.Unary("-", TIP)))
    assert codes(masses=balanced, energies=(energy("potential", SPRING),), gravity=DOWN) == []


def test_a_start_that_cannot_be_evaluated_counts_as_zero():
    odd = dataclasses.replace(coordinate("q"), start=fx.SystemEnergy("total"))
    assert (
        codes(coordinates=(odd,), masses=(mass(M, TIP),), energies=(energy("potential", SPRING),), gravity=DOWN) == []
    )
