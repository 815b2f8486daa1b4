"""An FMU for co-simulation keeps the past of delayed values: over communication points, jumps of inputs and saved
states. Model exchange is refused."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from fmpy import simulate_fmu

from fmi.texts import export_text
from lagdsl.foundation.diagnostics import CompilationFailed

# y' = u - y(t - 1), and the input half a second late
TEXT = """model Late
  input Real u(start = 0);
  state Real y(start = 1);
  output Real late = delay(u, 0.5 s);
  output Real now = y;
equation
  der(y) = (u - delay(y, 1 s))/(1 s);
end Late;
"""


@pytest.mark.parametrize("solver_step", [0.0, 0.01])
def test_the_past_of_an_fmu(solver_step: float, tmp_path: Path) -> None:
    path = tmp_path / "late.fmu"
    export_text(TEXT, path, kinds=("cs",))
    u = np.array([(0.0, 0.0), (2.0, 0.0), (2.0, 3.0), (9.0, 3.0)], dtype=[("time", float), ("u", float)])
    starts = {"solver.step": solver_step} if solver_step else {}
    rows = simulate_fmu(str(path), stop_time=3.0, output_interval=0.05, input=u, start_values=starts)
    t = rows["time"]
    free = 1.0 + sum((-1.0) ** k * np.maximum(t - k + 1.0, 0.0) ** k / math.factorial(k) for k in range(1, 6))
    exact = free + 3.0 * np.maximum(t - 2.0, 0.0)
    assert np.max(np.abs(rows["now"] - exact)) < (1e-8 if solver_step else 1e-13)
    beside = np.abs(t - 2.5) > 1e-9
    assert np.array_equal(rows["late"][beside], np.where(t > 2.5, 3.0, 0.0)[beside])


def test_model_exchange_is_refused(tmp_path: Path) -> None:
    with pytest.raises(CompilationFailed, match="E0917"):
        export_text(TEXT, tmp_path / "late.fmu", kinds=("me",))
