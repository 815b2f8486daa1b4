"""Small motions of a model with delays have no finite state: they are refused with a reason."""

from __future__ import annotations

import pytest
from choice import together

import lagdsl
from lagdsl.foundation.diagnostics import CompilationFailed

DECAY = """
model Decay
  input Real u = 0;
  state Real y(start = 1);
equation
  der(y) = (u - delay(y, 1 s))/(1 s);
end Decay;
"""


@together("asked", ["linearize", "modes", "bode", "trim"])
def test_small_motions_are_refused(asked: str) -> None:
    with pytest.raises(CompilationFailed, match="E0868"):
        getattr(lagdsl.compile(DECAY, engine="tape"), asked)()
