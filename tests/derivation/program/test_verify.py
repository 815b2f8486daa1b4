"""Rules of a well-formed program."""

from __future__ import annotations

from dataclasses import replace

import pytest
from sample_programs import closed_chain, pendulum, quaternion_body

from lagdsl.algebra.graph import Group
from lagdsl.derivation.program.program import Block, Function, Program
from lagdsl.derivation.program.verify import InvalidProgram, verify


def _with(program: Program, name: str, **changes: object) -> Program:
    functions = tuple(replace(f, **changes) if f.name == name else f for f in program.functions)  # type: ignore[arg-type]
    return replace(program, functions=functions)


def test_samples_are_well_formed() -> None:
    for program in (pendulum(), closed_chain(2), quaternion_body()):
        verify(program)


def test_a_missing_function_is_found() -> None:
    program = pendulum()
    with pytest.raises(InvalidProgram, match="functions are"):
        verify(replace(program, functions=program.functions[1:]))


def test_a_wrong_shape_is_found() -> None:
    program = pendulum()
    block = Block(name="M", shape=(1,), nodes=(program.graph.one,))
    with pytest.raises(InvalidProgram, match=r"M of mass_matrix has shape \(1,\), not \(1, 1\)"):
        verify(_with(program, "mass_matrix", results=(block,)))
    with pytest.raises(InvalidProgram, match="number of results"):
        verify(_with(program, "mass_matrix", results=()))


def test_a_symbol_that_is_no_argument_is_found() -> None:
    program = pendulum()
    for group, words in ((Group.QDD, "depends on QDD"), (Group.RELEASE, "release")):
        block = Block(name="M", shape=(1, 1), nodes=(program.graph.symbol(group),), places=(0,))
        with pytest.raises(InvalidProgram, match=words):
            verify(_with(program, "mass_matrix", results=(block,)))


def test_an_index_beyond_the_layout_is_found() -> None:
    program = pendulum()
    block = Block(name="M", shape=(1, 1), nodes=(program.graph.symbol(Group.Q, 1),), places=(0,))
    with pytest.raises(InvalidProgram, match=r"Q\[1\]"):
        verify(_with(program, "mass_matrix", results=(block,)))


def test_a_node_that_does_not_exist_is_found() -> None:
    program = pendulum()
    block = Block(name="M", shape=(1, 1), nodes=(len(program.graph),), places=(0,))
    with pytest.raises(InvalidProgram, match="no node"):
        verify(_with(program, "mass_matrix", results=(block,)))


def test_a_wrong_signature_is_found() -> None:
    with pytest.raises(InvalidProgram, match="signature of energies"):
        verify(_with(pendulum(), "energies", arguments=(Group.TIME,)))


@pytest.mark.parametrize("field", ["defaults", "position_level", "redundant"])
def test_tables_of_the_layout_have_one_length(field: str) -> None:
    program = closed_chain()
    with pytest.raises(InvalidProgram):
        verify(replace(program, layout=replace(program.layout, **{field: ()})))


def test_a_cycle_is_found() -> None:
    program = pendulum()
    program.graph.operands[-1] = (len(program.graph) - 1,)
    with pytest.raises(InvalidProgram, match="is computed from node"):
        verify(program)


def test_functions_are_found_by_name() -> None:
    function: Function = pendulum().function("energies")
    assert function.name == "energies"
