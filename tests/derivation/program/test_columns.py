"""A program that does not write M out gives the same mass matrix and dynamics, by every engine and exported."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from choice import chosen
from derived_programs import derive

from lagdsl.derivation.program.functions import WRITTEN_OUT
from lagdsl.derivation.program.program import Layout
from lagdsl.derivation.program.verify import verify
from lagdsl.derivation.structure.functions import ProgramFunctions
from lagdsl.engines.backends.python.emit import module
from lagdsl.engines.runtime.engines.c_engine import CEngine
from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine
from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion import pipeline

MODELS = ("chain", "four_bar", "heavy_top", "relativistic_particle", "rolling_coin", "charged_particle", "quarter_car")


def _flat(path: Path, **structural: float) -> FlatModel:
    sink = Sink()
    file = pipeline.read(path, sink)
    assert file is not None
    flat = pipeline.flatten_file(file, sink, structural=structural)
    assert flat is not None
    return flat


def _states(layout: Layout) -> list[tuple[float | np.ndarray, ...]]:
    rng = np.random.default_rng(7)
    p = np.array(layout.defaults)
    rest = (np.zeros(len(layout.states)), np.zeros(len(layout.inputs)), np.zeros(0), p)
    return [(0.3, *rng.uniform(0.1, 0.6, (2, len(layout.coordinates))), *rest) for _ in range(3)]


@pytest.mark.parametrize("name", chosen(MODELS, ("chain", "relativistic_particle", "rolling_coin")))
def test_columns_agree_with_the_matrix_written_out(root: Path, name: str) -> None:
    flat = _flat(root / "models" / f"{name}.lag")
    whole = NumpyEngine(derive(flat, dense=True))
    program = derive(flat, dense=False)
    verify(program)
    assert set(WRITTEN_OUT).isdisjoint(f.name for f in program.functions)
    namespace: dict[str, object] = {}
    exec(compile(module(program), "<module>", "exec"), namespace)
    exported = namespace["evaluate"]
    assert callable(exported)
    for state in _states(whole.layout):
        for function in WRITTEN_OUT:
            expected = whole.evaluate(function, *state)
            for evaluate in (NumpyEngine(program).evaluate, CEngine(program).evaluate, exported):
                for ours, theirs in zip(evaluate(function, *state), expected, strict=True):
                    _assert_close(ours, theirs, 1e-12)
        _assert_close(ProgramFunctions(program).evaluate("mass_matrix", *state)[0], expected[0], 1e-12)
        for make in (NumpyEngine, CEngine):
            for ours, theirs in zip(make(program).solve(*state), whole.solve(*state), strict=True):
                _assert_close(ours, theirs, 1e-9)


def test_columns_broadcast(root: Path) -> None:
    flat = _flat(root / "models" / "four_bar.lag")
    program = derive(flat, dense=False)
    states = _states(program.layout)
    t, *_ = states[0]
    q, qd = (np.array([state[k] for state in states]) for k in (1, 2))
    for make in (NumpyEngine, CEngine):
        engine = make(program)
        mass, force, jacobian, gamma = engine.evaluate_many("dynamics", t, q, qd, *states[0][3:])
        for i, state in enumerate(states):
            for many, one in zip((mass, force, jacobian, gamma), engine.evaluate("dynamics", *state), strict=True):
                _assert_close(many[i], one, 1e-14)


def test_programs_of_many_coordinates_do_not_write_the_matrix_out(root: Path) -> None:
    chain = root / "benchmarks" / "models" / "planar_chain.lag"
    assert derive(_flat(chain, N=11)).has("mass_matrix")
    many = derive(_flat(chain, N=12))
    verify(many)
    assert many.has("momentum_tangent")
    assert many.has("elimination")
    assert not many.has("mass_matrix")
    loops = root / "benchmarks" / "models" / "four_bars.lag"
    assert derive(_flat(loops, N=13)).has("mass_matrix")
    assert not derive(_flat(loops, N=14)).has("mass_matrix")


def test_equations_that_are_not_eliminated_have_the_matrix(tmp_path: Path) -> None:
    """M has zeros on its diagonal, so that no coordinate can be solved for by itself."""
    path = tmp_path / "crossed.lag"
    path.write_text(
        "model Crossed\n  coordinate Length x[7], y[7];\n  parameter Mass m = 1 kg;\n  parameter Stiffness k = 2 N/m;\n"
        "equation\n  for i in 1:7 loop\n    kinetic m*der(x[i])*der(y[i]);\n    potential k*x[i]*y[i];\n"
        "  end for;\nend Crossed;\n",
        encoding="utf-8",
    )
    program = derive(_flat(path))
    verify(program)
    assert not program.has("elimination")
    assert program.has("mass_matrix")


def _assert_close(ours: np.ndarray, theirs: np.ndarray, part: float) -> None:
    np.testing.assert_allclose(ours, theirs, rtol=part, atol=part * (1.0 + np.max(np.abs(theirs), initial=0.0)))
