"""Dry friction, contacts of rates and loads that depend on multipliers: their equations against hand-written ones."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from compiled_programs import program_of
from friction_texts import BEARING, BLOCK, FREEWHEEL, PUCK, SLOPE

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Program
from lagdsl.derivation.program.verify import verify
from lagdsl.exchange.verify.states import values

M, MU, G = 2.0, 0.3, 9.80665


def at(program: Program, function: str, w: dict[str, float], **given: Any) -> list[Any]:
    """Results at one state; `w` by name, everything else that is not given is zero."""
    layout = program.layout
    state = {group: np.zeros(layout.size(group)) for group in Group if not group.name.startswith("RELEASE")}
    state |= {Group.TIME: 0.0, Group.P: np.array(layout.defaults)}
    state |= {Group[name.upper()]: np.array(value, dtype=float) for name, value in given.items()}
    state[Group.W] = np.array([w.get(slot.name, 0.0) for slot in layout.discretes])
    return values(program, function, state)


def close(found: Any, expected: Any) -> None:
    """Equal, one after the other; either may be several arrays."""
    one, other = (
        np.concatenate([np.ravel(x) for x in each]) if isinstance(each, tuple) else np.ravel(each)
        for each in (found, expected)
    )
    np.testing.assert_allclose(one, other, rtol=1e-13, atol=1e-13)


def test_a_block_that_slides() -> None:
    program = program_of(BLOCK)
    verify(program)
    limit, slope = 0.3 * M * G * (1.0 + 0.7**2), 0.3 * M * G * 2.0 * 0.7
    for sense in (-1.0, 0.0, 1.0):
        w = {"direction(dry)": sense}
        given = {"q": [0.2], "qd": [0.7], "u": [5.0], "qdd": [1.5], "lambda": [3.0]}
        motion, rows = at(program, "residual", w, **given)
        close(motion, M * 1.5 - (5.0 - sense * limit))  # the multiplier has no part in it
        close(rows, 0.0)
        mass, force, jacobian, gamma = at(program, "dynamics", w, **given)
        close((mass, force), (M, 5.0 - sense * limit))
        close((jacobian, gamma), (0.0, 0.0))
        close(at(program, "output", w, **given), -sense * limit)
        load, dissipated = at(program, "power", w, **given)
        close((load, dissipated), ((5.0 - sense * limit) * 0.7, 0.0))
        change = at(program, "residual_tangent", w, **given, direction_qd=[1.0])[0]
        close(change, sense * slope)  # Stribeck's curve is differentiated


def test_a_block_that_sticks() -> None:
    program = program_of(BLOCK)
    given = {"q": [0.2], "qd": [0.7], "u": [5.0], "qdd": [1.5], "lambda": [3.0]}
    for sense in (-1.0, 0.0, 1.0):  # the sense of the slip before is forgotten
        w = {"sticks(dry)": 1.0, "direction(dry)": sense}
        motion, rows = at(program, "residual", w, **given)
        close((motion, rows), (M * 1.5 - 5.0 - 3.0, 1.5))
        residual, jacobian = at(program, "velocity_constraint", w, **given)
        close((residual, jacobian), (0.7, 1.0))
        close(at(program, "position_constraint", w, **given)[0], 0.0)
        close(at(program, "output", w, **given), 3.0)
        qdd, lam, *_ = at(program, "elimination", w, **given)
        close((qdd, lam), (2.5, 0.0))  # the row comes and goes: its multiplier is left to run time
    assert program.kept_rows == (0,)


def test_the_law_of_a_block() -> None:
    slip, jacobian, limit, sticking, gain, sticking_gain = at(program_of(BLOCK), "friction", {}, qd=[0.7])
    close((slip, jacobian, limit, sticking), (0.7, 1.0, 0.3 * M * G * 1.49, 9.0))
    close((gain, sticking_gain), (0.0, 0.0))


def test_entries_of_w_and_their_kinds() -> None:
    layout = program_of(PUCK).layout
    names = [slot.name for slot in layout.discretes]
    assert names[:5] == ["closed(floor)", "impacts(floor)", "sticks(pad)", "direction(pad)[1]", "direction(pad)[2]"]
    assert layout.kinds == ("contact", "impacts", "sticks", "direction", "direction", "load")
    assert [slot.name for slot in layout.constraints] == ["floor", "pad[1]", "pad[2]"]
    instants = layout.instants
    assert (instants.frictions, instants.friction_rows) == (("pad",), (1, 2))
    assert (instants.friction_slips, instants.friction_contacts, instants.contact_rows) == (
        (2,),
        (1,),
        (0,),
    )  # it acts under no contact


@pytest.mark.parametrize("tiny", [(0.0, 0.0), (3e-9, -4e-9)])
def test_a_puck_slides_against_its_slip(tiny: tuple[float, float]) -> None:
    program = program_of(PUCK)
    load = program.layout.discretes[-1].name
    normal = 7.0  # the load entry is what the equations read, the multiplier what it has to be
    w = {"closed(floor)": 1.0, load: 0.3 * normal, "direction(pad)[1]": tiny[0], "direction(pad)[2]": tiny[1]}
    slip = np.array([0.3, -0.4])
    given = {"qd": [*slip, 0.0], "lambda": [normal, 5.0, 6.0]}
    motion, rows = at(program, "residual", w, **given)
    close(motion, [0.3 * normal * 0.6, -0.3 * normal * 0.8, M * G - normal])
    close(rows, np.zeros(3))
    slips, jacobian, limit, sticking, gain, sticking_gain = at(program, "friction", w, **given)
    close(slips, slip)
    close(jacobian, np.eye(3)[:2])
    close((limit, sticking), (0.3 * normal, 0.4 * normal))
    close((gain, sticking_gain), ([0.3, 0.0, 0.0], [0.4, 0.0, 0.0]))
    close(at(program, "output", w, **given), [-0.3 * normal * 0.6, 0.3 * normal * 0.8])


def test_a_puck_at_rest_slips_where_it_is_told_to() -> None:
    program = program_of(PUCK)
    load = program.layout.discretes[-1].name
    for direction, force in (((0.0, 0.0), (0.0, 0.0)), ((3e-200, 4e-200), (0.0, 0.0)), ((-3e-9, 4e-9), (0.6, -0.8))):
        w = {load: 1.0, "direction(pad)[1]": direction[0], "direction(pad)[2]": direction[1]}
        motion, _ = at(program, "residual", w)
        close(motion[:2], -np.array(force))


def test_a_puck_sticks_in_both_directions() -> None:
    program = program_of(PUCK)
    load = program.layout.discretes[-1].name
    w = {"closed(floor)": 1.0, "sticks(pad)": 1.0, load: 3.0, "direction(pad)[1]": 1.0}
    given = {"qd": [0.3, -0.4, 0.0], "qdd": [1.0, 2.0, 3.0], "lambda": [7.0, 5.0, 6.0]}
    motion, rows = at(program, "residual", w, **given)
    close(motion, [M - 5.0, 2.0 * M - 6.0, 3.0 * M + M * G - 7.0])
    close(rows, [3.0, 1.0, 2.0])
    close(at(program, "output", w, **given), [5.0, 6.0])


def test_a_load_with_feedback_tells_its_value_and_its_derivatives() -> None:
    program = program_of(PUCK)
    value, by_acceleration, by_multiplier = at(program, "load", {}, **{"lambda": [7.0, 5.0, 6.0]})
    close(value, 2.1)
    close(by_acceleration, np.zeros(3))
    close(by_multiplier, [0.3, 0.0, 0.0])


def test_a_bearing_feels_its_reaction() -> None:
    """At phi = 0: the pin holds m (x'' , y'' + g) with x'' = -l w^2 and y'' = l alpha."""
    program = program_of(BEARING)
    w, rate, alpha, l = {"direction(journal)": 1.0}, 3.0, -4.0, 0.5
    given = {"qd": [rate], "qdd": [alpha]}
    pin = np.array([-M * l * rate**2, M * (l * alpha + G)])
    size = np.linalg.norm(pin)
    value, by_acceleration, by_multiplier = at(program, "load", w, **given)
    close(value, 0.01 * size)
    close(by_acceleration, 0.01 * pin[1] * M * l / size)
    close(by_multiplier, 0.0)
    load = program.layout.discretes[-1].name
    motion, _ = at(program, "residual", w | {load: 0.05}, **given)
    close(motion, M * l**2 * alpha + M * G * l + 0.05)
    given["qdd"] = [-(M * G * l + 0.05) / (M * l**2)]  # it moves: about its axis the pin exerts the friction alone
    close(at(program, "output", w | {load: 0.05}, **given)[0][1], -0.05)


def test_a_freewheel() -> None:
    program = program_of(FREEWHEEL)
    given = {"q": [1.0, 2.0], "qd": [0.5, 0.25], "u": [1.0], "qdd": [3.0, 5.0], "lambda": [7.0]}
    gap, speed, jacobian, restitution, *_ = at(program, "contact", {}, **given)
    close((gap, speed, restitution), (0.0, -0.75, 0.0))
    close(jacobian, [-2.0, 1.0])
    motion, rows = at(program, "residual", {"closed(wheel)": 1.0}, **given)
    close(motion, [2.0 * 3.0 - 1.0 + 2.0 * 7.0, 3.0 * 5.0 - 7.0])
    close(rows, -1.0)
    motion, rows = at(program, "residual", {}, **given)
    close((*motion, *rows), (5.0, 15.0, 0.0))
    assert (program.layout.instants.one_way, program.layout.position_level) == ((True,), (False,))


def test_friction_of_a_contact_is_its_own() -> None:
    program = program_of(SLOPE)
    instants = program.layout.instants
    assert (instants.frictions, instants.friction_contacts) == (("floor.friction",), (0,))
    given = {"qd": [0.5, 0.0], "lambda": [7.0, 5.0]}
    *_, limit, sticking, gain, sticking_gain = at(program, "friction", {}, **given)
    close((limit, sticking, gain, sticking_gain), (2.1, 4.2, [0.3, 0.0], [0.6, 0.0]))


def test_slips_and_forces_are_as_the_rows_are() -> None:
    """A row far shorter than those beside it is multiplied; the force on it is smaller by as much."""
    text = """
model Far
  coordinate Length x(start = 0 m), y(start = 0 m);
  mass 1 kg at {x, y, 0 m};
  constraint tied: x - 1e5*y = 0 m;
  friction dry: 1e-3*der(x) with limit = 3 N + 0.5*multiplier(tied)*(1 m), sticking = 4 N;
end Far;
"""
    program = program_of(text.replace("*(1 m)", ""))
    given = {"qd": [0.5, 2.0], "lambda": [7.0, 8.0]}
    slip, jacobian, limit, sticking, gain, _ = at(program, "friction", {}, **given)
    residual, rows = at(program, "velocity_constraint", {"sticks(dry)": 1.0}, **given)
    factor = rows[1, 0] / 1e-3
    assert factor > 1e3
    close((slip, jacobian), (residual[1], rows[1]))
    close((limit, sticking, gain), (6.5 / factor, 4.0 / factor, [0.5 / factor, 0.0]))
