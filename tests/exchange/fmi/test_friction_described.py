"""Dry friction in the description of an FMU: a truth, a force, and loads that depend on everything."""

from __future__ import annotations

import pytest
from friction_texts import GEAR, PUCK, SLOPE

from fmi.described import of_text, table_of
from lagdsl.algebra.graph.operation import Group
from lagdsl.exchange.fmi.variables.dependencies import dependencies
from lagdsl.exchange.fmi.variables.scalar import Role
from lagdsl.exchange.fmi.variables.variables import Version
from lagdsl.motion.pipeline import with_names


@pytest.mark.parametrize("version", [2, 3])
def test_an_fmu_tells_whether_a_friction_sticks(version: Version) -> None:
    variables = {variable.name: variable for variable in table_of(of_text(SLOPE), version).variables}
    sticks = variables["floor.friction.sticks"].attributes
    assert (sticks.role, sticks.type, sticks.variability) == (Role.DISCRETE, "BOOLEAN", "discrete")
    force = variables["floor.friction.multiplier"].attributes
    assert (force.unit, force.doc) == ("N", "force of floor.friction while it sticks, zero while it slides")
    assert "floor.closed" in variables
    assert not [name for name in variables if "direction" in name or "limit" in name]


def test_what_a_load_moves_depends_on_everything() -> None:
    program = with_names(of_text(GEAR))
    found = dependencies(program).moving
    n = program.layout.size(Group.Q)
    states = {(Role.STATE, index) for index in range(2 * n)}
    for acceleration in range(n, 2 * n):
        row = {entry for entry, _ in found[Role.DERIVATIVE, acceleration]}
        assert states | {(Role.INPUT, 0), (Role.TIME, 0)} <= row
        assert all(role is not Role.DISCRETE for role, _ in row)


def test_rates_depend_on_no_load() -> None:
    found = dependencies(with_names(of_text(PUCK))).moving
    assert [entry for entry, _ in found[Role.DERIVATIVE, 0]] == [(Role.STATE, 3)]
