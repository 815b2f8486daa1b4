"""Lengths and names of the arrays of a program, as the functions in NumPy take them."""

from __future__ import annotations

from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.python.support.motion import Sizes


def argument_names(program: Program) -> dict[str, list[str]]:
    """Names of the entries of arguments and of y."""
    layout = program.layout
    slots = {
        **dict.fromkeys(("q", "qd", "qdd"), layout.coordinates),
        "z": layout.states,
        "u": layout.inputs,
        "w": layout.discretes,
        "p": layout.parameters,
        "y": layout.outputs,
    }
    return {label: [slot.name for slot in found] for label, found in slots.items()}


def motion_sizes(program: Program) -> Sizes:
    """Lengths of the arrays, and the largest number of rows of J that can be independent."""
    layout = program.layout
    return Sizes(
        q=len(layout.coordinates),
        z=len(layout.states),
        u=len(layout.inputs),
        w=len(layout.discretes),
        p=len(layout.parameters),
        c=len(layout.constraints),
        rank=len(layout.constraints) - sum(layout.redundant),
        kept=program.kept_rows if program.has("elimination") else None,
        independent=tuple(not layout.redundant[row] for row in program.kept_rows),
        loads=layout.kinds.count("load"),
    )
