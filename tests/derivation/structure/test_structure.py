"""Degrees of freedom, redundant and contradictory constraints, coordinates without inertia."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from mechanics.mechanics_models import body, constraint, coordinate, derive, energy, frame, mass, model, point

from lagdsl.derivation.structure.points import random_points
from lagdsl.derivation.structure.structure import Structure, analyze, constraint_space, flag_redundant, structure_text
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.units.dimension import LENGTH, dimension
from lagdsl.language.flat.display import Display, display, display_rate, quantity_text
from lagdsl.language.flat.expression import Variable
from lagdsl.language.flat.model import FlatModel, RotateQuaternion


def examined(flat: FlatModel) -> tuple[Structure, Sink]:
    sink = Sink()
    return analyze(flat, constraint_space(flat, derive(flat)), sink), sink


def codes(sink: Sink) -> list[str]:
    return [d.code for d in sink.diagnostics]


def plane(*constraints: Any, **more: Any) -> FlatModel:
    """A unit mass at x, y = 0.3, 0.4."""
    parts = {
        "coordinates": (coordinate("x", 0.3), coordinate("y", 0.4)),
        "masses": (mass(1, "v(x, y, 0)"),),
        "constraints": constraints,
    }
    return model(**(parts | more))


UNBOUNDED = (coordinate("a", 0.0), coordinate("b", 0.0))
CIRCLE = constraint("a", "x^2 + y^2 - 0.25")


def test_pendulum_counts_as_in_the_lecture() -> None:
    flat = model(coordinates=("th",), masses=(mass(1, "v(sin(th), -cos(th), 0)"),))
    found, sink = examined(flat)
    assert structure_text(found) == "1 coordinate = 1 degree of freedom (d = 3N - k = 3*1 - 2 = 1)"
    assert not sink.diagnostics


def test_particle_on_a_wire() -> None:
    found, sink = examined(plane(constraint("wire", "y - 0.4 - sin(x)")))
    assert (found.configuration_freedom, found.freedom, found.redundant) == (1, 1, (False,))
    expected = "2 coordinates - 1 independent constraint = 1 degree of freedom (d = 3N - k = 3*1 - 2 = 1)"
    assert structure_text(found) == expected
    assert not sink.diagnostics


def test_body_and_particle_count_together() -> None:
    turned = frame("A", "world")
    flat = model(
        coordinates=(coordinate("x"), coordinate("y")),
        named=(turned,),
        masses=(mass(1, "v(x, 0, 0)"), mass(1, "v(x, y, 0)")),
        bodies=(body("A", 1),),
    )
    found, _ = examined(flat)
    assert structure_text(found).endswith("(d = 3N + 6B - k = 3*2 + 6*1 - 10 = 2)")


def test_energies_by_hand_have_no_count() -> None:
    found, sink = examined(model(coordinates=("th",), energies=(energy("kinetic", "der(th)^2"),)))
    assert found.count is None
    assert structure_text(found) == "1 coordinate = 1 degree of freedom"
    assert not sink.diagnostics


def test_the_same_rod_twice_is_redundant_and_named() -> None:
    flat = plane(CIRCLE, constraint("b", "sqrt(x^2 + y^2) - 0.5"))
    found, sink = examined(flat)
    assert found.redundant == (False, True)
    assert flag_redundant(derive(flat), found).layout.redundant == (False, True)
    assert found.freedom == 1
    (note,) = sink.diagnostics
    assert note.code == "N0607" and note.message == "constraint `b` follows from `a` and is redundant"


def test_a_combination_names_all_it_follows_from() -> None:
    flat = model(
        coordinates=("x", "y", "z", "s"),
        masses=(mass(1, "v(x, y, z)"), mass(1, "v(s, 0, 0)")),
        constraints=(
            constraint("a", "x - y"),
            constraint("b", "y - z"),
            constraint("c", "x - s"),
            constraint("d", "x - z"),
        ),
    )
    found, sink = examined(flat)
    assert found.redundant == (False, False, False, True)
    assert sink.diagnostics[0].message == "constraint `d` follows from `a` and `b` and is redundant"


def test_derivative_of_a_holonomic_row_is_the_redundant_one_wherever_it_stands() -> None:
    rate = constraint("b", "2*x*der(x) + 2*y*der(y)", level="velocity")
    found, sink = examined(plane(rate, CIRCLE))
    assert found.redundant == (True, False)
    assert (found.configuration_freedom, found.freedom) == (1, 1)
    assert codes(sink) == ["N0607"]


def test_identically_satisfied_component() -> None:
    found, sink = examined(plane(constraint("a", "x - 1", "0*y")))
    assert found.redundant == (False, True) and found.empty == (False, True)
    assert sink.diagnostics[0].message == "component 2 of `a` is identically satisfied; its multiplier is 0"


def test_constraint_that_can_never_hold_shows_the_closest_approach() -> None:
    _, sink = examined(plane(constraint("a", "x^2 + y^2 + 1")))
    (error,) = sink.diagnostics
    assert error.code == "E0602"
    assert error.notes == ("closest approach is 1, at x = 0, y = 0",)


def test_a_triangle_that_does_not_close_is_told_with_its_gap() -> None:
    """Two links of 0.2 m and 0.3 m cannot span 1 m: they miss it by 0.5 m."""
    lengths = constraint("loop", "0.2*cos(x) + 0.3*cos(y) - 1", "0.2*sin(x) + 0.3*sin(y)")
    _, sink = examined(plane(replace(lengths, dimension=LENGTH), energies=(energy("kinetic", "der(x)^2 + der(y)^2"),)))
    (error,) = sink.diagnostics
    assert error.code == "E0602" and error.notes[0].startswith("closest approach is 0.5 m, at ")


def test_a_row_that_is_steep_somewhere_is_met_exactly_and_restricts() -> None:
    """tan(a/2) is as long as one likes near half a turn, where one of the points that tell the sizes of rows lies."""
    offset = np.array([point[0] for point in random_points(UNBOUNDED, np.zeros(2), np.ones(2), 8)])
    for steep in offset[np.argsort(np.abs(offset))[-3:]].tolist():
        zero = steep - float(np.copysign(np.pi, steep)) + 1e-7
        rows = constraint("one", f"sin((a - ({zero!r}))/2)/cos((a - ({zero!r}))/2)"), constraint("two", "b - 2*a")
        turning = energy("kinetic", "1/2*der(a)^2 + 1/2*der(b)^2")
        found, sink = examined(model(coordinates=UNBOUNDED, energies=(turning,), constraints=rows))
        assert (found.freedom, found.redundant, codes(sink)) == (0, (False, False), ["N0611"])


def test_contradiction_names_both() -> None:
    _, sink = examined(plane(constraint("c", "y - 3"), constraint("a", "x - 1"), constraint("b", "x - 2")))
    (error,) = sink.diagnostics
    assert error.code == "E0603" and error.message == "constraint `b` contradicts `a`"


def test_contradiction_of_three_names_all() -> None:
    rows = (constraint("a", "x - y"), constraint("b", "y - 1"), constraint("c", "x - 2"))
    _, sink = examined(plane(*rows))
    (error,) = sink.diagnostics
    assert error.message == "constraint `c` contradicts `a` and `b`"


def test_contradicting_rates() -> None:
    rows = (constraint("a", "der(x) - 1", level="velocity"), constraint("b", "der(x) - 2", level="velocity"))
    _, sink = examined(plane(*rows))
    (error,) = sink.diagnostics
    assert error.code == "E0603" and error.notes == ("no rates of the coordinates satisfy all of them",)


def test_a_row_that_moves_by_itself_can_never_hold() -> None:
    _, sink = examined(plane(constraint("a", "0*der(x) + 1", level="velocity")))
    assert codes(sink) == ["E0602"]


def test_constraint_that_only_touches_is_no_error() -> None:
    """Two circles that meet in one point hold there, though Newton's method converges slowly."""
    touching = (constraint("a", "x^2 + y^2 - 1"), constraint("b", "(x - 2)^2 + y^2 - 1"))
    _, sink = examined(plane(*touching))
    assert "E0602" not in codes(sink) and "E0603" not in codes(sink)


def test_velocity_constraint_must_be_linear_in_the_rates() -> None:
    _, sink = examined(plane(constraint("speed", "der(x)^2 + der(y)^2 - 1", level="velocity")))
    assert codes(sink) == ["E0604"]


def test_knife_edge_is_not_integrable_rolling_along_a_line_is() -> None:
    parts: dict[str, Any] = {
        "coordinates": (coordinate("x"), coordinate("y"), coordinate("th", 0.4)),
        "masses": (mass(1, "v(x, y, 0)"),),
        "energies": (energy("kinetic", "der(th)^2"),),
    }
    knife = constraint("knife", "der(x)*sin(th) - der(y)*cos(th)", level="velocity")
    found, sink = examined(model(**parts, constraints=(knife,)))
    assert (found.configuration_freedom, found.freedom) == (3, 2)
    told = "(1 of the constraints holds rates only and leaves 3 coordinates to choose at the start"
    assert told in structure_text(found)
    assert not sink.diagnostics
    rolling = constraint("rolling", "der(x) - 0.3*der(th)", level="velocity")
    assert codes(examined(model(**parts, constraints=(rolling,)))[1]) == ["N0606"]


def test_time_in_a_velocity_row_counts_in_its_integrability() -> None:
    """der(x) = t + y is not the derivative of a relation between x, y and t; der(x) = t is."""
    loose = constraint("a", "der(x) - y", level="velocity")
    tight = constraint("b", "der(x) - time", level="velocity")
    assert codes(examined(plane(loose))[1]) == []
    assert codes(examined(plane(tight))[1]) == ["N0606"]


def test_coordinate_without_inertia_is_named() -> None:
    flat = plane(coordinates=("x", "y", "spin"))
    _, sink = examined(flat)
    (error,) = sink.diagnostics
    assert error.code == "E0503" and error.message == "`spin` has no inertia"


def test_massless_combination_names_the_leading_coordinate_once() -> None:
    flat = model(coordinates=("a", "b"), energies=(energy("kinetic", "(der(a) + 2*der(b))^2"),))
    _, sink = examined(flat)
    assert [d.message for d in sink.diagnostics] == ["`a` has no inertia"]


def test_massless_coordinate_tied_to_a_massive_one_is_accepted() -> None:
    flat = plane(constraint("tie", "s - x - y"), coordinates=("x", "y", "s"))
    _, sink = examined(flat)
    assert not sink.diagnostics


@pytest.mark.parametrize(("tie", "names"), [("s - m0 - m1", []), ("m0 - m1", ["`s` has no inertia"])])
def test_among_many_coordinates_one_without_inertia_is_found_too(tie: str, names: list[str]) -> None:
    """Of so many that elimination shows the inertia of the others."""
    masses = tuple(f"m{i}" for i in range(60))
    kinetic = tuple(energy("kinetic", f"der({name})^2") for name in masses)
    flat = model(coordinates=(*masses, "s"), energies=kinetic, constraints=(constraint("tie", tie),))
    _, sink = examined(flat)
    assert [d.message for d in sink.diagnostics] == names


def test_quaternion_has_a_singular_mass_matrix_and_is_accepted() -> None:
    e = tuple(Variable(name) for name in ("e0", "e1", "e2", "e3"))
    starts = (1.0, 0.0, 0.0, 0.0)
    flat = model(
        coordinates=tuple(coordinate(v.name, s) for v, s in zip(e, starts, strict=True)),
        named=(frame("A", "world", RotateQuaternion(e)),),  # type: ignore[arg-type]
        bodies=(body("A", 1, inertia=(1, 2, 2.5, 0, 0, 0)),),
        constraints=(constraint("unit", "e0^2 + e1^2 + e2^2 + e3^2 - 1"),),
    )
    found, sink = examined(flat)
    assert found.freedom == 3 and not sink.diagnostics
    assert structure_text(found).endswith("(d = 6B - k = 6*1 - 3 = 3)")


@pytest.mark.parametrize(("inertia", "found"), [((1, 2, 2.5, 0, 0, 0), []), ((1, 0, 0, 0, 0, 0), ["E0503"])])
def test_among_many_coordinates_a_quaternion_needs_its_row_and_three_inertias(
    inertia: tuple[float, ...], found: list[str]
) -> None:
    """M is singular along the quaternion; its row is what makes up for that."""
    e = tuple(Variable(name) for name in ("e0", "e1", "e2", "e3"))
    masses = tuple(f"m{i}" for i in range(60))
    flat = model(
        coordinates=(*masses, *(coordinate(v.name, s) for v, s in zip(e, (1.0, 0.0, 0.0, 0.0), strict=True))),
        named=(frame("A", "world", RotateQuaternion(e)),),  # type: ignore[arg-type]
        bodies=(body("A", 1, inertia=inertia),),
        energies=tuple(energy("kinetic", f"der({name})^2") for name in masses),
        constraints=(constraint("unit", "e0^2 + e1^2 + e2^2 + e3^2 - 1"),),
    )
    assert codes(examined(flat)[1]) == found


def test_functions_that_exist_near_the_start_only() -> None:
    """sqrt(0.01 - (x - 0.3)^2) is real within 0.1 of the start; random points far away are drawn closer."""
    flat = plane(constraint("dome", "y - 0.4 - sqrt(0.01 - (x - 0.3)^2)"))
    found, sink = examined(flat)
    assert found.freedom == 1 and not sink.diagnostics


def test_bounds_are_respected_by_the_probes() -> None:
    x = replace(coordinate("x", 0.3), minimum=0.2, maximum=0.4)
    flat = model(coordinates=(x,), energies=(energy("kinetic", "1/(x - 0.15)*der(x)^2"),))
    assert not examined(flat)[1].diagnostics


def test_many_coordinates_are_abbreviated() -> None:
    names = [f"x{i}" for i in range(8)]
    flat = model(
        coordinates=tuple(names),
        energies=(energy("kinetic", " + ".join(f"der({n})^2" for n in names)),),
        constraints=(constraint("a", "x0^2 + x1^2 + x2^2 + x3^2 + x4^2 + x5^2 + x6^2 + 1"),),
    )
    _, sink = examined(flat)
    assert sink.diagnostics[0].notes[0].endswith("x5 = 0, ...")


@pytest.mark.parametrize(
    ("more", "value", "text", "rate"),
    [
        ({"type_name": "Angle"}, np.pi / 6, "30 deg", "deg/s"),
        ({"unit": "m"}, 0.25, "0.25 m", "m/s"),
        ({"unit": "m", "display_unit": "mm"}, 0.25, "250 mm", "mm/s"),
        ({"unit": "K", "display_unit": "degC"}, 300.0, "26.85 degC", "degC/s"),
        ({}, 1.5, "1.5", "1/s"),
    ],
)
def test_values_are_shown_in_display_units(more: Any, value: float, text: str, rate: str) -> None:
    shown = replace(coordinate("x"), **more)
    assert quantity_text(value, shown) == text
    assert display_rate(shown).unit == rate
    assert display_rate(shown).shift == 0.0


def test_display_without_unit_is_the_number_itself() -> None:
    assert display(coordinate("x")) == Display("")


def test_units_of_rows() -> None:
    from lagdsl.derivation.structure.names import unit_suffix

    assert unit_suffix(replace(CIRCLE, dimension=dimension(m=2, s=-1))) == " m2.s-1"
    assert unit_suffix(CIRCLE) == ""


def test_the_same_every_time() -> None:
    flat = plane(CIRCLE, constraint("b", "sqrt(x^2 + y^2) - 0.5"))
    assert examined(flat)[1].diagnostics == examined(flat)[1].diagnostics


def test_point_of_a_model_with_points() -> None:
    flat = model(coordinates=("x",), named=(point("P", "v(x, 0, 0)"),), masses=(mass(2, "p(P)"),))
    assert examined(flat)[0].freedom == 1


def test_functions_that_exist_at_the_start_only_are_examined_there() -> None:
    flat = model(
        coordinates=(coordinate("x", 0.3),), energies=(energy("kinetic", "sqrt(1e-14 - (x - 0.3)^2)*der(x)^2"),)
    )
    found, sink = examined(flat)
    assert found.freedom == 1 and not sink.diagnostics


def test_functions_that_exist_nowhere_are_left_to_the_start_values() -> None:
    found, sink = examined(plane(CIRCLE, energies=(energy("kinetic", "sqrt(-1 - x^2)*der(x)^2"),)))
    assert found.redundant == (False,) and not sink.diagnostics


def test_check_needs_no_scipy() -> None:
    code = (
        "import sys, lagdsl.derivation.structure.structure, lagdsl.motion.simulate.initialize, "
        "lagdsl.motion.simulate.simulate, lagdsl.motion.signals.table_io; "
        "sys.exit(any(name in sys.modules for name in ('scipy', 'matplotlib', 'pandas', 'pyarrow', 'sympy')))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
