"""The lengths that shapes of arguments and results are written in."""

from __future__ import annotations

from lagdsl.derivation.program.functions import BY_NAME, COUNTED
from lagdsl.derivation.program.program import Layout, Program


def sizes(layout: Layout) -> dict[str, int]:
    """Lengths that the layout gives."""
    return {
        "nq": len(layout.coordinates),
        "nz": len(layout.states),
        "nu": len(layout.inputs),
        "nw": len(layout.discretes),
        "np": len(layout.parameters),
        "nc": len(layout.constraints),
        "ny": len(layout.outputs),
        "ni": len(layout.invariants),
        "na": len(layout.assertions),
        "nd": len(layout.definitions),
    }


def counted(program: Program) -> dict[str, int]:
    """The lengths of COUNTED: those of the first results that have them, zero where there are none."""
    found = dict.fromkeys(COUNTED, 0)
    for function in reversed(program.functions):
        for block, result in zip(function.results, BY_NAME[function.name].results, strict=False):
            if result.shape and result.shape[0] in COUNTED:
                found[result.shape[0]] = block.shape[0]
    return found
