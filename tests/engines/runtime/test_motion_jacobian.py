"""The motion with its derivatives by everything, written out: the expressions, a tape and C against passes over
directions."""

from __future__ import annotations

from ctypes import CFUNCTYPE, POINTER, Structure, c_int, c_size_t, c_void_p, cast, pointer
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import lagdsl
from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import ARGUMENT_NAMES, Group
from lagdsl.derivation.program.functions import STATE
from lagdsl.derivation.program.passes.motion_jacobian import motion_jacobian
from lagdsl.engines.backends.c.emit import engine_sources
from lagdsl.engines.backends.tape.emit import tape
from lagdsl.engines.runtime.building.build import build
from lagdsl.engines.runtime.building.compiler import ALIKE
from lagdsl.engines.runtime.engines.c_engine import CEngine, opened
from lagdsl.engines.runtime.engines.native_model import NativeModel
from lagdsl.engines.runtime.engines.tape_engine import TapeEngine
from lagdsl.engines.runtime.structures import Arguments, Model
from tests.choice import chosen

Floats = NDArray[np.float64]

_TIME = 0.2

MODELS = Path(__file__).parents[3] / "models"
# No constraint; one loop without a multiplier that is left to run time; states of first order.
FEW = ["double_pendulum", "four_bar", "crane_with_motor"]
NAMES = chosen([*FEW, "andrews_squeezer", "ball_on_turntable"], FEW)
MAXWELL = """
model Maxwell
  parameter Mass m = 2 kg;
  parameter Stiffness k = 8 N/m;
  parameter Time T = 0.1 s;
  input Force u;
  coordinate Length x;
  state Length y(start = 0);
  mass m at {x, 0};
  potential k*x^4/(4*(1 m2));
  force u + k*(y - x) on x;
equation
  der(y) = (x - y)/T + y^2*der(x)/(1 m2);
end Maxwell;
"""


class Tangents(Structure):
    """lag_tangents."""

    _fields_ = [
        *((name, c_size_t) for name in ("lanes", "workspace", "width")),
        *((name, c_void_p) for name in ("primal", "motion", "residual", "acceleration", "rates", "output", "jacobian")),
    ]


def _called(model: NativeModel, shapes: list[tuple[int, ...]], state: dict[Group, Floats]) -> list[Floats]:
    """Results of the function in C, in arrays that were zero."""
    tangents = cast(model.part_address, POINTER(Tangents)).contents
    workspace = np.zeros(model.workspace + 8)
    native = cast(model.address, POINTER(Model)).contents
    arguments = Arguments(t=_TIME, context=model.context)
    for group, values in state.items():
        setattr(arguments, ARGUMENT_NAMES[group], values.ctypes.data)
    arguments.workspace = workspace.ctypes.data
    results = [np.zeros(shape) for shape in shapes]
    assert native.prepare(pointer(arguments)) == 0
    function = CFUNCTYPE(c_int, POINTER(Arguments), *[c_void_p] * len(results))(tangents.jacobian)
    assert function(pointer(arguments), *(each.ctypes.data for each in results)) == 0
    return results


def _state(engine: CEngine, seed: int) -> dict[Group, Floats]:
    layout, rng = engine.layout, np.random.default_rng(seed)
    found = {group: 0.3 + 0.2 * rng.random(layout.size(group)) for group in STATE[1:]}
    return found | {Group.P: np.array(layout.defaults)}


@pytest.mark.parametrize("text", [*(str(MODELS / f"{name}.lag") for name in NAMES), MAXWELL])
def test_the_derivatives_written_out_are_those_along_directions(text: str) -> None:
    """(qdd, zd) by the state, the inputs and the parameters; expressions, tape and C agree, the last two to the bit
    where C is compiled so."""
    model = lagdsl.compile(text if "\n" in text else Path(text), engine="tape")
    engine = model._engine
    assert isinstance(engine, TapeEngine)
    program, state = engine.program, _state(engine, 1)
    found = motion_jacobian(program)
    assert found is not None
    n, nz = engine.layout.size(Group.Q), engine.layout.size(Group.Z)
    shapes = [block.shape for block in found.results]
    nodes = [node for block in found.results for node in block.elements]
    exact = np.array(evaluate(program.graph, nodes, {**state, Group.TIME: _TIME}), dtype=np.float64)
    library = build(engine_sources(program, ("jacobian",)), (ALIKE,))
    taped, compiled = engine.differentiated(), CEngine(program).differentiated()
    assert taped is not None and compiled is not None
    on_tape, in_c, alike = (
        _called(each, shapes, state) for each in (taped, compiled, opened(library, program, "jacobian"))
    )
    flat = np.concatenate([each.ravel() for each in on_tape])
    assert np.array_equal(flat, np.concatenate([each.ravel() for each in alike]))
    size = max(1.0, float(np.abs(flat).max()))
    assert flat == pytest.approx(exact, rel=1e-11, abs=1e-12 * size)
    assert np.concatenate([each.ravel() for each in in_c]) == pytest.approx(exact, rel=1e-11, abs=1e-12 * size)
    qdd, _, pivot, response, by_state, by_parameter = on_tape
    assert qdd == pytest.approx(engine.solve(*_arguments(state))[0], rel=1e-12, abs=1e-12)
    assert pivot > 0.0
    for by, columns in (
        ("state", by_state[:, : 2 * n + nz]),
        ("input", by_state[:, 2 * n + nz :]),
        ("parameter", by_parameter),
    ):
        rates = engine.jacobian_many(by, *_arguments(state))[0][n:]
        size = max(1.0, float(np.abs(rates).max(initial=0.0)))
        assert response @ columns == pytest.approx(rates, rel=1e-9, abs=1e-11 * size)


def _arguments(state: dict[Group, Floats]) -> tuple[Any, ...]:
    return (_TIME, *(state[group] for group in STATE[1:]))


def test_where_passes_over_directions_take_less_nothing_is_written_out() -> None:
    """A long chain has as many entries as the square of its links; multipliers that are left to run time have no
    expression."""
    for name in ("chain", "particle_on_sphere"):
        engine = lagdsl.compile(MODELS / f"{name}.lag", engine="tape")._engine
        assert isinstance(engine, TapeEngine)
        assert motion_jacobian(engine.program) is None
        assert engine.differentiated() is None


def test_tapes_without_derivatives_are_as_they_were() -> None:
    """The function stands behind everything else; without it there is no trace of it."""
    engine = lagdsl.compile(MODELS / "double_pendulum.lag", engine="tape")._engine
    assert isinstance(engine, TapeEngine)
    before = tape(engine.program)
    assert len(tape(engine.program, parts=("jacobian",))) > len(before)
    assert tape(engine.program) == before
