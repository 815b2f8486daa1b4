"""Inputs that prescribe a speed: a jump of one is a blow, as momenta are kept; that of a position has no law."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import chain

from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.program.program import Program
from lagdsl.language.flat.model import FlatModel

# Functions that would miss the jump of a value whose derivative they read.
_READING = (
    "power",
    "energies",
    "momenta",
    "velocity_constraint",
    "state_derivative",
    "indicator",
    "contact",
    "friction",
    "load",
)


def speeds(flat: FlatModel, program: Program) -> tuple[bool, ...]:
    """Flags of inputs with one derivative, as `w(smooth = 1)` and `der(s)` of `s(smooth = 2)`, whose values have a part
    in rates of constraints or in momenta, and whose derivatives have none in loads, energies, states and relations:
    what integrates them would jump."""
    if not flat.inputs:
        return ()
    rates = {item.derivative_of: index for index, item in enumerate(flat.inputs)}
    prescribed, reading = _present(program, ("velocity_constraint", "momenta")), _present(program, _READING)
    return tuple(
        item.name in rates
        and item.smooth <= 1
        and program.graph.symbol(Group.U, index) in prescribed
        and program.graph.symbol(Group.U, rates[item.name]) not in reading
        for index, item in enumerate(flat.inputs)
    )


def _present(program: Program, names: Sequence[str]) -> set[int]:
    functions = [program.function(name) for name in names if program.has(name)]
    blocks = [block for each in functions for block in each.results]
    return set(program.graph.live(chain.from_iterable(block.nodes for block in blocks)))


def with_speeds(flat: FlatModel, program: Program) -> Program:
    """The same with these flags in its layout."""
    return replace(program, layout=replace(program.layout, speeds=speeds(flat, program)))
