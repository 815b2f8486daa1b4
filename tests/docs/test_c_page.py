"""The program of docs/reference/c_api.md compiles without warnings and gives the numbers of the Python API."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import lagdsl
from lagdsl.cli.main import lag
from lagdsl.runtime.building.compiler import machine_compiler

ROOT = Path(__file__).parents[2]


@pytest.mark.skipif(machine_compiler() is None, reason="no C compiler")
def test_the_program_calls_inverse_dynamics(tmp_path: Path) -> None:
    page = (ROOT / "docs" / "reference" / "c_api.md").read_text(encoding="utf-8")
    (program,) = re.findall(r"```c file=torque\.c\n(.*?)```", page, re.DOTALL)
    (tmp_path / "torque.c").write_text(program)
    model = ROOT / "models" / "double_pendulum.lag"
    done = CliRunner().invoke(lag, ["build", str(model), "--target", "c", "-o", str(tmp_path / "out")])
    assert done.exit_code == 0, done.output

    sources = ["torque.c", "out/DoublePendulum.c"]
    flags = ["-std=c11", "-O0", "-Wall", "-Wextra", "-Werror", "-pedantic", "-Iout"]
    subprocess.run(["cc", *flags, "-o", "torque", *sources, "-lm"], cwd=tmp_path, check=True)
    shown = subprocess.run(["./torque"], cwd=tmp_path, check=True, capture_output=True, text=True).stdout
    names, values = zip(*(line.split() for line in shown.splitlines()), strict=True)

    compiled = lagdsl.compile(model)
    assert list(names) == compiled.coordinates
    expected = compiled.inverse_dynamics(0.0, [0.5, -0.3], [1.0, 2.0], [-3.0, 4.0])
    assert np.allclose([float(value) for value in values], expected, rtol=1e-11)
