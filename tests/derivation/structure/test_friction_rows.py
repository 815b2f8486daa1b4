"""Rows of dry friction and of one-way contacts come and go: no freedom is taken by them, none of them is redundant."""

from __future__ import annotations

import pytest

from lagdsl.derivation.structure.structure import structure_text
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import compile_flat, flatten_file

BESIDE = "coordinate Real a, b; kinetic 1/2*der(a)^2 + 1/2*der(b)^2;"


@pytest.mark.parametrize(
    "items",
    [
        "friction one: der(a) with limit = 1; friction other: der(a) with limit = 2;",
        "constraint held: a = sin(time); friction on: der(a) with limit = 1; friction there: der(b) with limit = 1;",
        "constraint tied: a - b = 0; contact way: der(a) >= der(b); friction both: {der(a), der(b)} with limit = 1;",
        "contact floor: a >= 0 with restitution = 0, friction = 0.5, slip = der(b);",
    ],
)
def test_they_are_not_counted(items: str) -> None:
    sink = Sink()
    flat = flatten_file(
        SourceFile("<text>", f'model M\n  {BESIDE} {items}\n  annotation(units = "none");\nend M;\n'), sink
    )
    assert flat is not None, sink.diagnostics
    found = compile_flat(flat, sink)
    assert found is not None, sink.diagnostics
    structure = found.structure
    lasting = sum(len(each.rows) for each in flat.constraints if not each.of_law)
    assert not any(structure.redundant)
    assert len(structure.contacts) == len(structure.redundant) - lasting > 0
    assert f"{2 - lasting} degree" in structure_text(structure)
    assert [each.code for each in sink.diagnostics if each.code.startswith(("N0", "E0", "W06"))] == []
