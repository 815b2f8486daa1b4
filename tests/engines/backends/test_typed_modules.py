"""Generated modules pass `mypy --strict`. CasADi and JAX bring types of their own; where they stand in an environment
of peers (`make peers`) they are read there, elsewhere their names are of any type."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from choice import ALL
from foreign_programs import PEERS, has

import lagdsl
from lagdsl.derivation.mechanics.by_name import with_equation_terms, with_kinematics, with_regressor
from lagdsl.engines.backends.registry import BACKENDS

ROOT = Path(__file__).parents[3]
# Events and contacts; redundant rows, and functions that are lists of instructions for JAX.
MODELS = ("bouncing_ball", "four_bar")
CALLER = """import knife_edge_numpy as model

acceleration = model.forward_dynamics(0.0, [0.1, 0.2, 0.3], [0.0, 0.0, 0.0])
place = model.frame("skate").position(0.0, [0.1, 0.2, 0.3])
reveal_type(acceleration)
reveal_type(place)
model.forward_dynamics({"soon": 0.0}, 1.0)
"""


def _written(folder: Path) -> list[str]:
    """Names of the files of all modules, in `folder`."""
    for name in MODELS:
        compilation = lagdsl.compile(ROOT / "models" / f"{name}.lag", engine="tape")._compilation
        for target in ("numpy", "casadi", "jax"):
            ((_, text),) = BACKENDS[target].emit(compilation.program).files.items()
            (folder / f"{name}_{target}.py").write_text(text, encoding="utf-8")
    return [path.name for path in sorted(folder.glob("*.py"))]


def _with_terms(folder: Path) -> None:
    """A module with all functions that users ask for."""
    compilation = lagdsl.compile(ROOT / "models" / "knife_edge.lag", engine="tape")._compilation
    program = with_regressor(compilation.equations, with_equation_terms(compilation.equations, compilation.program))
    program = with_kinematics(compilation.equations, program, ["skate"])
    ((_, text),) = BACKENDS["numpy"].emit(program).files.items()
    (folder / "knife_edge_numpy.py").write_text(text, encoding="utf-8")


@pytest.mark.skipif(not ALL, reason="it takes mypy eight seconds")
def test_generated_modules_and_their_callers_are_typed(tmp_path: Path) -> None:
    _with_terms(tmp_path)
    names = _written(tmp_path)
    assert "Instructions(\n" in (tmp_path / f"{MODELS[-1]}_jax.py").read_text(encoding="utf-8")
    (tmp_path / "caller.py").write_text(CALLER, encoding="utf-8")
    peers = ["--python-executable", str(PEERS.absolute())] if has("jax") and has("casadi") else []
    options = ["--strict", "--config-file=", "--cache-dir=cache", *(peers or ["--ignore-missing-imports"])]
    done = subprocess.run(
        [sys.executable, "-m", "mypy", *options, "caller.py", *names],
        cwd=tmp_path, capture_output=True, text=True, check=False, timeout=300,
    )  # fmt: skip
    errors = [line for line in done.stdout.splitlines() if ": error:" in line]
    assert [line for line in errors if not line.startswith("caller.py")] == [], done.stderr
    # The caller has the types of arrays, and its faults are found.
    assert len(re.findall(r"note: Revealed type is \".*ndarray", done.stdout)) == 2, done.stdout
    assert errors and all(line.startswith("caller.py:7:") for line in errors)
