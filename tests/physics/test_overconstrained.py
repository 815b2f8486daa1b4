"""Linkages that move against the count of their equations: ranks, notes, closed forms, singular positions."""

from __future__ import annotations

import linkages
import numpy as np
import pytest
from choice import chosen
from derived_programs import derive

import lagdsl
from lagdsl.derivation.structure.structure import analyze, constraint_space, structure_text
from lagdsl.foundation.diagnostics import Sink

AROUND = ("A", "B", "C", "D")


@pytest.mark.parametrize(
    ("text", "rank"),
    [
        (linkages.bennett(), 2),
        (linkages.bricard(), 4),
        (linkages.CARDAN, 4),
        (linkages.THREE_BARS, 3),
    ],
    ids=["bennett", "bricard", "cardan", "three bars"],
)
def test_one_degree_of_freedom(text: str, rank: int) -> None:
    flat = linkages.flat_model(text)
    structure = analyze(flat, constraint_space(flat, derive(flat)), Sink())
    assert structure.freedom == 1 and structure.rank == rank
    assert structure.redundant.count(False) == rank


@pytest.mark.parametrize("error", chosen([1e-3, 1e-5], [1e-3]))
def test_bennett_with_a_wrong_length_is_rigid_or_open(error: float) -> None:
    """Beyond rounding the dimensions are not special any more: the loop has no motion."""
    flat = linkages.flat_model(linkages.bennett(length_error=error))
    sink = Sink()
    structure = analyze(flat, constraint_space(flat, derive(flat)), sink)
    assert structure.freedom == 0 or any(d.code in ("E0602", "E0603") for d in sink.diagnostics)


def test_redundant_closure_equations_name_joint_and_loop() -> None:
    loops = dict.fromkeys(("origin", "axis"), ("D", AROUND))
    compilation, sink = linkages.compiled(linkages.flat_model(linkages.bennett(), loops=loops))
    assert compilation is not None
    (first,) = (d for d in sink.diagnostics if d.code == "N0701")
    assert first.message == "4 of the 6 closure equations of joint `D` are redundant and are left out of the solve"
    assert first.labels[0].text == "this closes the loop A - B - C - D"
    assert first.notes[0].startswith("3 coordinates - 2 independent constraints = 1 degree of freedom; reaction(D) ")
    assert not any(d.code in ("N0605", "N0607") for d in sink.diagnostics)


LINKS = "import Lag.Planar.*; gravity = -g_n*world.y;"
# A door on two hinges, held by a constraint, with a flap; every closure equation holds identically.
DOOR = f"""model Door
  {LINKS}
  Link door(l = 1 m, m = 2 kg), flap(l = 1 m, m = 1 kg);
  Revolute A(q(start = 30 deg)), B, hinge;
  connect(world, A, door.frame_a);
  connect(world, B, door.frame_a);
  connect(door.frame_b, hinge, flap);
  constraint held: A.q = 30 deg;
end Door;
"""
# A rigid triangle on a pin: the loop does not tie the angle of the pin.
TRIANGLE = f"""model Triangle
  {LINKS}
  Link a(l = 1 m, m = 2 kg), b(l = 1 m, m = 1 kg), c(l = 1 m, m = 1 kg);
  Revolute A, B(q(start = 120 deg)), C(q(start = 120 deg)), D;
  connect(world, A, a, B, b, C, c, D, a.frame_a);
end Triangle;
"""
# Three parallel bars: two loops, of which the second one has special dimensions.
BARS = f"""model Bars
  {LINKS}
  Link one(l = 0.4 m, m = 1 kg), two(l = 0.4 m, m = 1 kg), three(l = 0.4 m, m = 1 kg);
  Link left(l = 0.5 m, m = 1 kg), right(l = 0.5 m, m = 1 kg);
  Revolute A(q(start = 60 deg)), B(q(start = -60 deg)), C(q(start = 60 deg)), D, E(q(start = 60 deg)), F;
  Fixed pin(r = {{0.5 m, 0}}), last(r = {{1 m, 0}});
  connect(world, A, one, B, left, right);
  connect(pin, C, two, D, right.frame_a);
  connect(last, E, three, F, right.frame_b);
end Bars;
"""
# One of its closure equations follows from a constraint that comes first.
REPEATED = f"""model Repeated
  {LINKS}
  Link crank(l = 0.4 m, m = 1 kg), coupler(l = 1 m, m = 2 kg), rocker(l = 0.8 m, m = 1 kg);
  Revolute A(q(start = 60 deg)), B(q(start = -30 deg)), C(q(start = -110 deg)), D;
  Fixed pin(r = {{1 m, 0}});
  connect(world, A, crank, B, coupler, C, rocker, D, pin);
  constraint again: rocker.frame_b.origin*world.x = 1 m;
end Repeated;
"""
# Cylinders in a row: loops of one `connect` are told of once.
ENGINE = f"""model Engine
  {LINKS}
  model Cylinder
    Link web(l = 0.1 m, m = 1 kg), rod(l = 0.3 m, m = 1 kg), piston(l = 0.1 m, m = 1 kg);
    Revolute pin(q(start = 30 deg)), big(q(start = -40 deg)), wrist;
    Prismatic guide(s(start = 0.38 m));
    connect(world, pin, web, big, rod, wrist, piston.frame_a);
    connect(world, guide, piston.frame_a);
  end Cylinder;
  Cylinder cylinder[2];
end Engine;
"""


@pytest.mark.parametrize(
    ("text", "balance", "excess"),
    [
        (DOOR, "2 coordinates - 1 independent constraint = 1 degree of freedom", [5]),
        (TRIANGLE, "3 coordinates - 2 independent constraints = 1 degree of freedom", [3]),
        (BARS, "4 coordinates - 3 independent constraints = 1 degree of freedom", [3, 4]),
        (REPEATED, "3 coordinates - 2 independent constraints = 1 degree of freedom", [4]),
        (ENGINE, "6 coordinates - 4 independent constraints = 2 degrees of freedom", [6]),
    ],
    ids=["door", "triangle", "bars", "repeated", "engine"],
)
def test_notes_on_loops_count_as_the_summary(text: str, balance: str, excess: list[int]) -> None:
    compilation, sink = linkages.compiled(linkages.flat_model(text))
    assert compilation is not None
    structure = compilation.structure
    assert structure_text(structure).startswith(balance)
    notes = [d for d in sink.diagnostics if d.code == "N0701"]
    assert all(any(line.startswith(balance) for line in note.notes) for note in notes)
    told = [int(note.message.split()[0]) * (1 + others(note.notes)) for note in notes]
    assert told == excess and sum(told) == len(structure.redundant) - structure.rank


def others(notes: tuple[str, ...]) -> int:
    last = notes[-1].split()
    return int(last[-3]) if notes[-1].startswith("the same holds for ") else 0


def test_bennett_keeps_its_closed_form() -> None:
    """tan(q1/2) tan(q2/2) is constant (Bennett 1903), through the positions in which rows of J vanish."""
    motion = lagdsl.compile(linkages.bennett()).simulate()
    q1, q2, q3 = motion["q1"], motion["q2"], motion["q3"]
    expected = np.array([linkages.bennett_second_angle(x) for x in q1])
    assert np.max(np.abs(np.sin((q2 - expected) / 2.0))) < 1e-8
    assert np.max(np.abs(q1 + q3)) < 1e-8
    assert np.ptp(q1) > 2.0 * np.pi


def test_bricard_keeps_its_closed_form() -> None:
    motion = lagdsl.compile(linkages.bricard()).simulate()
    a, b = np.cos(motion["q1"]), np.cos(motion["q2"])
    assert np.max(np.abs(a + b + a * b)) < 1e-8
    assert np.max(np.abs(motion["q1"] - motion["q5"])) < 1e-8 and np.ptp(motion["q1"]) > 0.5


def test_double_cardan_turns_equally() -> None:
    motion = lagdsl.compile(linkages.CARDAN).simulate()
    turned = np.unwrap(np.arctan2(motion["turned[2]"], motion["turned[1]"]))
    assert np.max(np.abs(turned - motion["turn"])) < 1e-8
    assert np.ptp(motion["der(a)"]) > 1.0  # the middle shaft does not turn equally


@pytest.mark.parametrize("tolerance", [1e-7, 1e-9])
def test_parallelogram_with_a_third_bar_swings_through_its_flat_position(tolerance: float) -> None:
    motion = lagdsl.compile(linkages.THREE_BARS).simulate(tolerance=tolerance, stop=1.2)
    assert motion["A"].min() < -1.0  # it passed A = 0, where all bars lie in one line
    assert np.max(np.abs(motion["A"] + motion["B"])) < 1e-7 and np.max(np.abs(motion["C"] - motion["A"])) < 1e-7


SLIDER_CRANK = """model SliderCrank
  parameter Length r = 0.2 m, l = 0.2 m;
  coordinate Angle th(start = 60 deg, fixed = true, der(start = 6 rad/s)), ph(start = -60 deg);
  frame crank = world.rotz(th);
  frame rod = crank.move({r, 0, 0}).rotz(ph - th);
  point wrist = rod.point({l, 0, 0});
  gravity = -g_n*world.y;
  constraint wall: wrist*world.y = 0;
  body disc(Izz = 0.02 kg.m2) on crank;
  body conrod(m = 0.5 kg, com = {l/2, 0}, Izz = 2e-3 kg.m2) on rod;
  mass 0.4 kg at wrist;
  invariant E: energy() with tol = 1e-6;
  annotation(experiment(StopTime = 1, Tolerance = 1e-9));
end SliderCrank;
"""


def test_slider_crank_passes_its_dead_centers() -> None:
    motion = lagdsl.compile(SLIDER_CRANK.replace("l = 0.2 m", "l = 0.5 m")).simulate()
    assert np.ptp(motion["th"]) > 2.0 * np.pi
    assert np.max(np.abs(0.2 * np.sin(motion["th"]) + 0.5 * np.sin(motion["ph"]))) < 1e-11


def test_slider_crank_with_equal_arms_keeps_its_branch_where_the_slider_could_stop() -> None:
    """With l = r the slider may rest at the shaft while both arms turn as one; a crossing motion does not."""
    motion = lagdsl.compile(SLIDER_CRANK).simulate()
    assert np.ptp(motion["th"]) > 2.0 * np.pi
    assert np.max(np.abs(motion["th"] + motion["ph"])) < 1e-7
