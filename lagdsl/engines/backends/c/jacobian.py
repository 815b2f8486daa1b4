"""The motion at one state with its derivatives by everything, as a file of its own."""

from __future__ import annotations

from lagdsl.derivation.program.passes.hoist import hoisted
from lagdsl.derivation.program.passes.motion_jacobian import RESULTS, motion_jacobian
from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.c.dialect import PREPARED, SINGLE, Place
from lagdsl.engines.backends.c.function import Head, code
from lagdsl.engines.backends.c.results import definition, filled
from lagdsl.engines.backends.identifier import comment_text


def jacobian_source(program: Program, stem: str) -> str:
    """Text of a file that defines `stem`_jacobian, of type lag_tangents, whose only function is `jacobian`; there is
    none where the program does not write it out."""
    found = motion_jacobian(program)
    name = f"const lag_tangents {stem}_jacobian"
    lines = [
        f"/* Derivatives of the motion of {comment_text(program.name)}, generated: see lag/parallel.h. */",
        "#include <math.h>\n",
        '#include "lag/elementary.h"\n#include "lag/lanes.h"',
        '#include "lag/parallel.h"\n#include "lag/trigonometry.h"\n',
        f"extern {name};\n",
    ]
    if found is None:
        return "\n".join([*lines, f"{name} = {{0}};\n"])
    prepared = {node: Place(PREPARED, index) for index, node in enumerate(hoisted(program))}
    contents = filled(((own, block, ()) for own, block in zip(RESULTS, found.results, strict=True)), SINGLE)
    parameters = ["const lag_arguments *at", *(f"double *{own}" for own in RESULTS)]
    head = Head("model_jacobian", parameters, ["at", *RESULTS], fused=True)
    made = code(program.graph, contents.stores, prepared, SINGLE, head)
    text = definition(head, made, contents, SINGLE, f"at->workspace + {len(prepared)}")
    members = f".workspace = {len(prepared) + made.scratch}, .width = LAG_LANES, .jacobian = model_jacobian"
    return "\n".join([*lines, text, f"{name} = {{{members}}};\n"])
