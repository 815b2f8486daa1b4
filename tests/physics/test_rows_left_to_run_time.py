"""All ways to solve a linkage with dependent rows whose multipliers are left to run time: they agree on the motion, and
on multipliers of least norm."""

from __future__ import annotations

from types import ModuleType

import linkages
import numpy as np
import pytest
from compiled_programs import program_of
from models.many_states import left_in_equations, onto_constraints
from models.test_elimination import without_dense, without_elimination

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.functions import STATE
from lagdsl.derivation.structure import redundant_multipliers
from lagdsl.engines.backends.python.emit import module
from lagdsl.engines.runtime.engines.c_engine import CEngine
from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine


def test_every_engine_and_the_exported_module_agree(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(redundant_multipliers, "_WELL_CONDITIONED", np.inf)  # every loop counts as weak
    program = program_of(linkages.THREE_BARS)
    assert 0 < sum(program.layout.redundant[row] for row in program.kept_rows) < len(program.kept_rows)

    random, count = np.random.default_rng(4), 16
    angle = random.uniform(0.3, 1.2, (count, 1))
    state = {
        Group.TIME: np.zeros(count),
        Group.Q: angle * np.array([1.0, -1.0, 1.0, 1.0]),
        Group.QD: random.normal(size=(count, 4)),
        Group.P: np.tile(program.layout.defaults, (count, 1)),
        **{group: np.zeros((count, 0)) for group in (Group.Z, Group.U, Group.W)},
    }
    state = onto_constraints(program, state)
    arguments = [state[group] for group in STATE]
    qdd, lam = NumpyEngine(without_elimination(program)).solve_many(*arguments)

    exported = ModuleType("exported")
    exec(compile(module(program), "exported", "exec"), exported.__dict__)
    at = {"z": state[Group.Z], "u": state[Group.U], "w": state[Group.W], "p": state[Group.P]}
    moving = (state[Group.TIME], state[Group.Q], state[Group.QD])
    one_by_one = [CEngine(program).solve(float(row[0]), *row[1:]) for row in zip(*arguments, strict=True)]
    for found in (
        NumpyEngine(program).solve_many(*arguments),
        NumpyEngine(without_dense(program)).solve_many(*arguments),
        CEngine(without_dense(program)).solve_many(*arguments),
        CEngine(program).solve_batch(2, *arguments),
        tuple(np.array(block) for block in zip(*one_by_one, strict=True)),
        (exported.forward_dynamics(*moving, **at), exported.multipliers(*moving, **at)),
    ):
        assert left_in_equations(program, state, *found) < 1e-12
        np.testing.assert_allclose(found[0], qdd, rtol=1e-9, atol=1e-9 * np.abs(qdd).max())
        np.testing.assert_allclose(found[1], lam, rtol=1e-8, atol=1e-8 * np.abs(lam).max())
