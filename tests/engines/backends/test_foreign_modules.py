"""Modules for CasADi and JAX give the numbers of the graph. Their interpreters stand in an environment of their own
(`make peers`, or PEERS=folder of a virtual environment); where there is none, only the texts are looked at."""

from __future__ import annotations

import ast
import json
import re
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from choice import ALL
from foreign_programs import PEERS, has, in_peers
from models.kinds import MODELS

import lagdsl
from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group
from lagdsl.derivation.mechanics.by_name import with_equation_terms, with_kinematics, with_regressor
from lagdsl.derivation.program.functions import ALONG_MANY, STATE
from lagdsl.engines.backends.registry import BACKENDS
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.exchange.verify.states import random_states
from lagdsl.motion.pipeline import Compilation

CLIENTS = Path(__file__).parent / "clients"
ROOT = Path(__file__).parents[3]
TARGETS = pytest.mark.parametrize("target", ["casadi", "jax"])
SOME = ("double_pendulum", "four_bar", "bouncing_ball", "van_der_pol", "pendulum_two_dependent_constraints")
EVERY = MODELS if ALL else SOME
STATES = 50 if ALL else 5


@cache
def compiled(name: str) -> Compilation:
    return lagdsl.compile(ROOT / "models" / f"{name}.lag", engine="tape")._compilation


def written(name: str, target: str, folder: Path) -> str:
    """The name of the module of a model in `folder`."""
    files = BACKENDS[target].emit(compiled(name).program).files
    ((file, text),) = files.items()
    (folder / file).write_text(text, encoding="utf-8")
    return file.removesuffix(".py")


def values(name: str, path: Path) -> None:
    """Arguments and results of all functions at random states, those of the functions by the interpreter of the
    graph."""
    program = compiled(name).program
    states = random_states(compiled(name).flat, program, STATES)
    assert states
    found: dict[str, Any] = {}
    names = []
    for function in program.functions:
        if function.name in ALONG_MANY:
            continue
        blocks = [
            np.stack([_blocks(program.graph, function, states, row)[k] for row in range(len(states[Group.TIME]))])
            for k in range(len(function.results))
        ]
        names.append(function.name)
        _add(found, function.name, [states[group] for group in function.arguments], blocks)
    state = [states[group] for group in STATE]
    engine = engine_of(program, "tape")
    _add(found, "forward_dynamics", state, engine.solve_many(*state))
    found["jacobian"] = engine.jacobian_many("state", *state)[0]
    np.savez(path, functions=[*names, "forward_dynamics"], **found)


def _blocks(graph: Any, function: Any, states: Any, row: int) -> list[np.ndarray]:
    given = {group: states[group][row] for group in function.arguments}
    numbers = evaluate(graph, [node for block in function.results for node in block.elements], given)
    ends = np.cumsum([len(block.elements) for block in function.results])[:-1]
    parts = np.split(np.asarray(numbers, dtype=float), ends)
    return [part.reshape(block.shape) for part, block in zip(parts, function.results, strict=True)]


def _add(found: dict[str, Any], name: str, arguments: Any, blocks: Any) -> None:
    found[f"{name}/inputs"] = len(arguments)
    found |= {f"{name}/in/{k}": argument for k, argument in enumerate(arguments)}
    found |= {f"{name}/out/{k}": block for k, block in enumerate(blocks)}


@TARGETS
@pytest.mark.parametrize("name", EVERY)
def test_values_are_those_of_the_graph(name: str, target: str, tmp_path: Path) -> None:
    if not has(target):
        pytest.skip(f"{target} is not installed in {PEERS.parents[1]}")
    values(name, tmp_path / "values.npz")
    module = written(name, target, tmp_path)
    worst = json.loads(in_peers(CLIENTS / f"{target}_module.py", tmp_path, module, "values.npz", folder=tmp_path))
    derivative = worst.pop("jacobian", 0.0)
    assert max(worst.values()) < 1e-12, worst
    assert derivative < 1e-10


@TARGETS
@pytest.mark.parametrize("name", SOME)
def test_texts_are_python_and_the_same_every_time(name: str, target: str) -> None:
    first, second = (BACKENDS[target].emit(compiled(name).program).files for _ in range(2))
    assert first == second
    ((file, text),) = first.items()
    imported = {
        alias.name for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Import) for alias in node.names
    }
    assert imported <= {"casadi", "jax", "jax.numpy"}
    assert file.endswith(".py") and "lagdsl" not in text.replace("generated", "")


def program_of_page(name: str) -> str:
    page = (ROOT / "docs/howto/optimize_and_differentiate.md").read_text(encoding="utf-8")
    (found,) = re.findall(rf"^```python fragment program={name}\n(.*?)^```$", page, re.DOTALL | re.MULTILINE)
    return found


def test_program_of_the_comparison_with_pinocchio_and_mujoco(tmp_path: Path) -> None:
    if not (has("pinocchio") and has("mujoco")):
        pytest.skip(f"pinocchio and mujoco are not installed in {PEERS.parents[1]}")
    page = (ROOT / "docs/explanation/pinocchio_and_mujoco.md").read_text(encoding="utf-8")
    (urdf,) = re.findall(r"^```xml file=arm.urdf\n(.*?)^```$", page, re.DOTALL | re.MULTILINE)
    (program,) = re.findall(r"^```python fragment program=compare\n(.*?)^```$", page, re.DOTALL | re.MULTILINE)
    (tmp_path / "arm.urdf").write_text(urdf)
    compilation = lagdsl.compile(lagdsl.import_robot(tmp_path / "arm.urdf"))._compilation
    extended = with_regressor(compilation.equations, with_equation_terms(compilation.equations, compilation.program))
    extended = with_kinematics(compilation.equations, extended, ("lower.frame_a",), ())
    (tmp_path / "Arm.py").write_text(BACKENDS["numpy"].emit(extended).files["Arm.py"])
    in_peers("-c", program, folder=tmp_path)


def test_programs_of_the_page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    if not (has("casadi") and has("jax")):
        pytest.skip(f"casadi and jax are not installed in {PEERS.parents[1]}")
    page = (ROOT / "docs/howto/optimize_and_differentiate.md").read_text(encoding="utf-8")
    (text,) = re.findall(r"^```modelica file=swing.lag\n(.*?)^```$", page, re.DOTALL | re.MULTILINE)
    (tmp_path / "swing.lag").write_text(text)
    for target, program in (("casadi", "collocation"), ("jax", "gradient")):
        module = BACKENDS[target].emit(lagdsl.compile(text)._compilation.program).files["Swing.py"]
        (tmp_path / "Swing.py").write_text(module)
        in_peers("-c", program_of_page(program), folder=tmp_path)
    monkeypatch.chdir(tmp_path)
    exec(program_of_page("confirm"), {})
