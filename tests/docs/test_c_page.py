"""The program of docs/reference/c_api.md compiles without warnings and gives the numbers of the Python API."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import lagdsl
from lagdsl.derivation.program.functions import BY_NAME
from lagdsl.engines.runtime.building.compiler import machine_compiler
from lagdsl.interfaces.cli.main import lag

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


def _page() -> str:
    return (ROOT / "docs" / "reference" / "c_api.md").read_text(encoding="utf-8")


def test_the_seven_results_of_elimination_are_those_of_the_table() -> None:
    section = _page().split("## Elimination")[1]
    rows = re.findall(r"^\| `(\w+)` \| (\(.*?\)|one number) \|", section, re.MULTILINE)
    shapes = {name: () if shape == "one number" else tuple(shape.strip("()").split(", ")) for name, shape in rows}
    assert shapes == {result.name: result.shape for result in BY_NAME["elimination"].results}
    assert len(shapes) == 7


@pytest.mark.parametrize(("name", "kept"), [("four_bar", 0), ("ladder_with_friction", 4)])
def test_elimination_is_put_together_as_the_page_says(name: str, kept: int) -> None:
    model = lagdsl.compile(ROOT / "models" / f"{name}.lag", engine="tape")
    program, engine = model._compilation.program, model._engine
    start = model.initial_state()
    w = engine.evaluate("discrete_start", 0.0, start.p)[0] if program.layout.discretes else np.zeros(0)
    if kept:  # the ladder stands on the floor and at the wall, and sticks at both
        w = np.where(np.isin(program.layout.kinds, ("contact", "sticks")), 1.0, w)
    state = (0.0, start.q, start.qd, start.z, np.zeros(len(program.layout.inputs)), w, start.p)
    a, l, y, k, jacobian, gamma, pivot = engine.evaluate("elimination", *state)
    rows = list(program.kept_rows)
    assert len(rows) == kept and pivot > (1e-4 if kept else 1e-8)
    own = np.eye(len(l))[rows]
    assert np.all(l[rows] == 0) and np.all(k * np.any(own, axis=0) == 0)
    np.testing.assert_allclose(jacobian @ y.T, (jacobian @ y.T).T, atol=1e-12)
    left = np.linalg.lstsq(jacobian @ y.T, gamma - jacobian @ a, rcond=None)[0]
    qdd, lam = a + y.T @ left, l + (k + own).T @ left
    mass, force, rows_of_all, bias = engine.evaluate("dynamics", *state)
    scale = np.abs(force).max()
    np.testing.assert_allclose(mass @ qdd - rows_of_all.T @ lam, force, atol=1e-10 * scale)
    np.testing.assert_allclose(rows_of_all @ qdd, bias, atol=1e-10 * max(1.0, np.abs(qdd).max()))
