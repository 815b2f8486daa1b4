"""The layout tells the relations with which energies or rows of constraints may jump."""

from __future__ import annotations

import pytest
from compiled_programs import program_of

MODEL = """model M
  coordinate Real x, y; kinetic 1/2*der(x)^2 + 1/2*der(y)^2;
  {}
  annotation(units = "none");
end M;
"""
CASES = {
    "force (if x > 1 then 1 else 0) on y;": {"x > 1": False},
    "potential (if x > 1 then 1 else 0);": {"x > 1": True},
    "Real e = if x > 1 then 1 else 0; potential e*y;": {"x > 1": True},
    "kinetic (if x > 1 then 1 else 2)*der(y)^2;": {"x > 1": True},
    "constraint c: (if x > 1 then y - 2 else 0) = 0;": {"x > 1": True},
    "potential (if y > (if x > 1 then 1 else 2) then 1 else 0);": {"x > 1": True, "y > (if x > 1 then 1 else 2)": True},
    "contact c: y >= (if x > 1 then 1 else 0) with restitution = 0; force (if y > 3 then 1 else 0) on x;": {
        "x > 1": False,
        "y > 3": False,
    },
    "potential (if x > 1 then 1 else 0); force (if y > 1 then 1 else 0) on y;": {"x > 1": True, "y > 1": False},
}


@pytest.mark.parametrize("text", CASES)
def test_relations_with_which_energies_or_rows_may_jump(text: str) -> None:
    layout = program_of(MODEL.format(text)).layout
    names = [slot.name for slot, kind in zip(layout.discretes, layout.kinds, strict=True) if kind == "relation"]
    assert dict(zip(names, layout.instants.jumping, strict=True)) == CASES[text]
