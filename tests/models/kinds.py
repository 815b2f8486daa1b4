"""Models that show one of each kind, and what a kind is."""

from __future__ import annotations

from dataclasses import fields, is_dataclass
from typing import Any

import pytest
from choice import chosen

from models.corpus import MODELS, compiled

OF_EACH_KIND = (
    "double_pendulum",  # minimal coordinates
    "four_bar",  # a closed loop of components, an input
    "four_bar_spatial",  # a closed loop in space
    "pendulum_two_dependent_constraints",  # redundant rows
    "rolling_coin",  # nonholonomic
    "bead_on_circular_wire",  # a force at a point, a reaction along a direction
    "ball_on_turntable",  # velocity of the material at a contact
    "watt_governor",  # mirrored parts
    "centrifugal_governor",  # initial equations
    "reaction_wheel_pendulum",  # a torque between frames
    "sliding_ladder",  # an assertion
    "two_masses_and_spring",  # momentum as an invariant
    "relativistic_particle",  # energy that is not quadratic
    "pendulum_by_energies",  # Lagrangian as written
    "free_rigid_body",  # a body
    "kapitza_pendulum",  # prescribed motion
    "van_der_pol",  # states of first order only, stiff
    "chain",  # arrays
    "bouncing_ball_modelica",  # relations, reinit
    "newtons_cradle",  # contacts
    "furuta_swing_up",  # a clock, sampled control
    "clutch",  # constraints that come and go
    "rimless_wheel",  # impacts that switch rows
    "valve_train",  # a table
    "library/blocks_pid",  # blocks
    "library/dc_motor",  # circuits
    "library/parts_with_play",  # components with contacts
    "library/ladder_filter",  # many coordinates under constraints
    "servo_drive",  # inputs of every type
    "library/blocks_table",  # corners along the motion
    "stick_slip_belt",  # dry friction, with another limit at rest
    "ladder_with_friction",  # friction under contacts
    "freewheel",  # a contact of rates
    "puck_with_side_force",  # friction in a plane
    "viscoelastic_mount",  # coordinates without inertia
    "library/flexible_strip",  # momenta by directions
    "robot_arm",  # what a motion requires
)


def over(names: list[str]) -> pytest.MarkDecorator:
    """The test for each of these models."""
    return pytest.mark.parametrize("name", names)


# Models that show a rule of all models.
SOME = over(chosen(MODELS, OF_EACH_KIND))
# Every other one, for a rule whose reference takes long.
HALF = over(chosen(MODELS, OF_EACH_KIND[::2]))
# Models that show a rule which other tests show of each kind, too.
FEW = over(chosen(MODELS, OF_EACH_KIND[1::3]))
# Models for a rule of code that is compiled, which takes a second each.
RARE = over(chosen(MODELS, OF_EACH_KIND[1::6]))


def kinds(name: str) -> set[str]:
    """All that the model is made of: nodes of its flat form, functions, what is special about
    its rows, kinds of its discretes."""
    program = compiled(name).graph
    layout = program.layout
    special = {
        "redundant rows": any(layout.redundant),
        "rows of rates": not all(layout.position_level),
        "rows left to run time": bool(program.kept_rows),
        "switched rows": bool(layout.instants.switched_rows),
        "no constraints": not layout.constraints,
        "no coordinates": not layout.coordinates,
        "inputs": bool(layout.inputs),
    }
    return {
        *_nodes(compiled(name).flat),
        *(f"discrete: {kind}" for kind in layout.kinds),
        *(f"function: {function.name}" for function in program.functions if function.results),
        *(what for what, there in special.items() if there),
    }


def _nodes(top: Any) -> set[str]:
    """Names of the classes of what hangs on a record."""
    found, seen, waiting = set(), set(), [top]
    while waiting:
        item = waiting.pop()
        if isinstance(item, tuple | list):
            waiting.extend(item)
        elif isinstance(item, dict):
            waiting.extend(item.values())
        elif is_dataclass(item) and id(item) not in seen:
            seen.add(id(item))
            found.add(type(item).__name__)
            waiting.extend(getattr(item, field.name) for field in fields(item))
    return found
