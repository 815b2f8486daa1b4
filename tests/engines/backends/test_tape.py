"""The interpreter of tapes computes what the evaluator of the graph does."""

from __future__ import annotations

import hashlib
import os
import re
import subprocess
import sys
from ctypes import POINTER, Structure, c_double, c_size_t, c_void_p
from pathlib import Path

import numpy as np
import pytest
from choice import ALL, examples, spread
from hypothesis import HealthCheck, given, settings
from random_programs import EXACT, SMOOTH, SYMBOLS, Step, as_outputs, grow, steps, values

from lagdsl.algebra.graph import Graph, Group, Op
from lagdsl.algebra.graph.evaluate import evaluate_with_size
from lagdsl.derivation.program.functions import STATE
from lagdsl.derivation.program.program import Program
from lagdsl.engines.backends.start import Start, start_of
from lagdsl.engines.backends.tape.emit import SIZES, Tapes, tape
from lagdsl.engines.backends.tape.instructions import ANGLES, CODE
from lagdsl.engines.backends.tape.listing import instructions
from lagdsl.engines.runtime.engines.buffers import aligned
from lagdsl.engines.runtime.engines.engine import SingularSystem
from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine
from lagdsl.engines.runtime.engines.one_state import OneState
from lagdsl.engines.runtime.engines.tape_engine import TapeEngine
from lagdsl.engines.runtime.engines.tape_model import DamagedTape, load_tape
from lagdsl.engines.runtime.library import runtime_library
from lagdsl.engines.runtime.structures import Model
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.resources import c_folder
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import compile_flat, flatten_file, read, with_names

ROOT = Path(__file__).parents[3]
EVERY = sorted(path.relative_to(ROOT) for path in (ROOT / "models").glob("**/*.lag"))
# Contacts, clauses with clocks, closed loops, rows left to run time, outputs, inputs, states, tables.
SOME = [
    Path("models", f"{name}.lag")
    for name in (
        "double_pendulum",
        "four_bar",
        *(("robot_arm",) if ALL else ()),
        "pick_and_place",
        "newtons_cradle",
        "clutch",
        "library/blocks_pid",
    )
]
EMPTY = np.zeros(0)


def _outputs(engine: TapeEngine, q: np.ndarray) -> np.ndarray:
    nothing = (EMPTY,) * 4
    return engine.evaluate("output", 0.75, q, np.zeros(SYMBOLS), *nothing, np.zeros(SYMBOLS), EMPTY)[0]


def _check(program: Program, exact: int, found: np.ndarray, q: np.ndarray) -> None:
    """The first `exact` outputs to the bit (up to the sign of zero), the others to roundings of their size."""
    roots = program.function("output").results[0].elements
    expected = evaluate_with_size(program.graph, roots, {Group.Q: q, Group.TIME: 0.75})
    for index, (value, (meaning, size)) in enumerate(zip(found, expected, strict=True)):
        if index < exact or not np.isfinite(size):
            same = value == meaning or (np.isnan(value) and np.isnan(meaning))
            assert same or (index >= exact and not np.isfinite(size)), (index, value, meaning)
        else:
            assert abs(value - meaning) <= 1e-12 * size + 1e-300, (index, value, meaning, size)


@settings(max_examples=examples(150), deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(steps, steps, values)
def test_a_tape_means_what_the_evaluator_means(a: list[Step], b: list[Step], state: list[float]) -> None:
    graph = Graph()
    exact, smooth = grow(graph, a, b)
    program = as_outputs(graph, exact + smooth)
    _check(program, len(exact), _outputs(TapeEngine(program), np.array(state)), np.array(state))


@pytest.mark.parametrize("seed", spread(range(5), 2))
def test_every_operation_many_times(seed: int) -> None:
    draw = np.random.default_rng(seed)
    graph = Graph()

    def walk(count: int) -> list[Step]:
        return [(i, *(int(x) for x in draw.integers(0, 25, 3))) for i in range(count)]

    exact, smooth = grow(graph, walk(20 * len(EXACT)), walk(6 * len(SMOOTH)))
    program = as_outputs(graph, exact + smooth)
    engine = TapeEngine(program)
    for state in draw.normal(size=(20, SYMBOLS)) * 3.0:
        _check(program, len(exact), _outputs(engine, state), state)


def _program(path: Path) -> Program:
    sink = Sink()
    source = read(ROOT / path, sink)
    assert source is not None
    flat = flatten_file(source, sink)
    assert flat is not None
    compilation = compile_flat(flat, sink)
    assert compilation is not None
    return with_names(compilation)


@pytest.mark.parametrize("path", EVERY if os.environ.get("LAGDSL_EXPLORE") else SOME, ids=str)
def test_every_function_of_a_model(path: Path) -> None:
    program = _program(path)
    engine = TapeEngine(program)
    draw = np.random.default_rng(1)
    numbers = 0
    for function in program.functions:
        if function.name == "acceleration_tangent":  # for many directions only
            continue
        arguments = {g: draw.normal(size=program.layout.size(g)) for g in function.arguments}
        arguments[Group.P] = np.array(program.layout.defaults) * draw.uniform(0.9, 1.1, len(program.layout.defaults))
        arguments = {g: arguments[g] for g in function.arguments}
        arguments[Group.TIME] = 0.7
        found = [block.ravel() for block in engine.evaluate(function.name, *arguments.values())]
        roots = [node for block in function.results for node in block.elements]
        with np.errstate(all="ignore"):
            expected = evaluate_with_size(program.graph, roots, arguments)
        for value, (meaning, size) in zip(np.concatenate([*found, EMPTY]), expected, strict=True):
            assert not np.isfinite(size) or abs(value - meaning) <= 1e-13 * size + 1e-300, function.name
        numbers += len(roots)
    assert numbers > 20


def _state(program: Program, draw: np.random.Generator, count: int) -> list[np.ndarray]:
    layout = program.layout
    vectors = [draw.normal(size=(count, layout.size(group))) for group in STATE[1:-1]]
    return [draw.normal(size=count), *vectors, np.array(layout.defaults) * draw.uniform(0.9, 1.1, (count, 1))]


@pytest.mark.parametrize("path", EVERY if os.environ.get("LAGDSL_EXPLORE") else SOME, ids=str)
def test_states_in_lanes_have_the_bits_of_single_ones(path: Path) -> None:
    program = _program(path)
    engine, draw = TapeEngine(program), np.random.default_rng(2)
    state = _state(program, draw, 2053)  # more than half of the lanes of the last ones are empty
    state[1][7] *= 1e6  # angles beyond what vectors take
    try:
        together = engine.solve_many(*state)
    except SingularSystem:
        pytest.skip("some drawn states are singular")
    for index in (0, 1, 7, 8, 9, 2051, 2052):
        alone = engine.solve(float(state[0][index]), *(vector[index] for vector in state[1:]))
        for found, expected in zip(together, alone, strict=True):
            assert np.array_equal(found[index], expected, equal_nan=True)


@pytest.mark.parametrize("path", EVERY if os.environ.get("LAGDSL_EXPLORE") else SOME, ids=str)
def test_directions_in_lanes(path: Path) -> None:
    program = _program(path)
    engine, draw = TapeEngine(program), np.random.default_rng(3)
    state = _state(program, draw, 3)
    for by in ("state", "input", "parameter"):
        try:
            expected = NumpyEngine(program).jacobian_many(by, *state)
            found = engine.jacobian_many(by, *state)
        except SingularSystem:
            pytest.skip("a drawn state is singular")
        for block, other in zip(found, expected, strict=True):
            scale = np.max(np.abs(other), axis=(1, 2), keepdims=True, initial=1.0)
            finite = np.isfinite(other)
            assert np.array_equal(finite, np.isfinite(block))
            assert np.all((np.abs(block - other) / scale)[finite] < 1e-8)
    one = engine.jacobian(float(state[0][0]), *(vector[0] for vector in state[1:]))
    assert np.array_equal(one, engine.jacobian_many("state", *state)[0][0], equal_nan=True)


@pytest.mark.parametrize("name", spread(["four_bar", "stewart_platform", "newtons_cradle", "knife_edge"], 2))
def test_where_the_jacobian_can_be_nonzero(name: str) -> None:
    program = _program(Path("models", f"{name}.lag"))
    engine, draw = TapeEngine(program), np.random.default_rng(5)
    model = Model.from_address(engine.native.context)  # of a tape it is where its model stands
    pattern = Pattern.from_address(c_void_p.from_address(model.patterns).value)  # the first member of lag_patterns
    listed = np.zeros((pattern.rows, pattern.columns), dtype=bool)
    listed[[pattern.row[i] for i in range(pattern.count)], [pattern.column[i] for i in range(pattern.count)]] = True
    seen = np.zeros_like(listed)
    for _ in range(3):
        state = [vector[0] for vector in _state(program, draw, 1)]
        seen |= engine.evaluate("velocity_constraint", float(state[0]), *state[1:])[1] != 0.0
        seen |= engine.evaluate("position_constraint", float(state[0]), *state[1:])[1] != 0.0
    assert listed.any() and not (seen & ~listed).any()
    assert not (listed & ~seen).any()  # for these models none is zero by accident


class Pattern(Structure):
    """lag_pattern."""

    _fields_ = (
        *((name, c_size_t) for name in ("rows", "columns", "count")),
        ("row", POINTER(c_size_t)),
        ("column", POINTER(c_size_t)),
    )


def test_the_same_bytes_under_any_hash_seed() -> None:
    text = (
        "import sys, hashlib; sys.path.insert(0, 'tests/engines/backends'); from test_tape import _program, SOME; "
        "from lagdsl.engines.backends.tape.emit import tape; print(hashlib.sha256(tape(_program(SOME[1]))).hexdigest())"
    )
    done = subprocess.run(
        [sys.executable, "-c", text],
        cwd=ROOT,
        env={**os.environ, "PYTHONHASHSEED": "1", "PYTHONPATH": os.pathsep.join(sys.path)},
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.strip() == hashlib.sha256(tape(_program(SOME[1]))).hexdigest()  # this process drew its seed


def test_functions_of_one_state_beside_others() -> None:
    """In a tape with derivatives they lie elsewhere in the row, and have the same bits."""
    program = _program(Path("models", "newtons_cradle.lag"))
    tapes = Tapes(program)
    made = tapes.tape(), tapes.tape(parts=("tangents",))
    assert tapes.tape() == made[0] == tape(program)
    state = [vector[0] for vector in _state(program, np.random.default_rng(6), 1)]
    solved = []
    for one in (OneState(load_tape(each), program.layout) for each in made):
        one.set(float(state[0]), *state[1:])
        one.prepare(state[-1])
        solved.append([block.copy() for block in one.solve()[1:]])
    assert all(map(np.array_equal, *solved))
    assert np.all(solved[0][0] != 0.0)


def test_instructions_can_be_listed() -> None:
    program = _program(Path("models", "robot_arm.lag"))
    made = tape(program)
    listed = {name: instructions(made, name) for name in ("prepare", "elimination", "inverse_dynamics", "energies")}
    assert [each.name for each in listed["prepare"]][:2] == ["CONSTANTS", "LOAD"]
    assert [own[-1].name for own in listed.values()] == ["END"] * 4
    assert [sum(each.name == "SINCOS" for each in own) for own in listed.values()] == [1, 1, 1, 1]
    quotients = sum(each.times for each in listed["elimination"] if each.name == "DIVIDE")
    graph = program.graph
    live = graph.live([node for block in program.function("elimination").results for node in block.elements])
    moving = [node for node in live if graph.groups[node] & ~(1 << Group.P)]  # prepare() does the others
    assert quotients == sum(graph.op[node] is Op.DIVIDE for node in moving) > 0


FREE = """model Clock
  parameter Length l(fixed = false, start = 0.5 m) "such that the mass begins 0.4 m aside";
  coordinate Angle phi(start = 30 deg, fixed = true);
  mass 1 kg at {l*sin(phi), -l*cos(phi)};
  gravity = -g_n*world.y;
  output Length length = l;
initial equation
  l*sin(phi) = 0.4 m;
end Clock;
"""


def test_a_tape_alone_finds_free_parameters() -> None:
    """l = 0.4 m / sin(30 deg); the guess is another one."""
    sink = Sink()
    flat = flatten_file(SourceFile("clock.lag", FREE), sink)
    assert flat is not None, sink.diagnostics
    compilation = compile_flat(flat, sink)
    assert compilation is not None, sink.diagnostics
    model = load_tape(tape(compilation.program, start_of(flat, 0.0, (np.pi / 6.0, 0.0))))
    runtime = runtime_library()
    start = runtime.tape_start(model.address)
    block = aligned(runtime.session_size(model.address, start) // 8 + 1)
    session = runtime.session_place(block.ctypes.data, model.address, start, 1e-8, 1.0)
    assert runtime.session_begin(session, 0.0) == 0
    row = (c_double * runtime.session_width(session)).from_address(runtime.session_row(session))
    assert row[1] == pytest.approx(np.pi / 6.0)
    assert row[3] == pytest.approx(0.8, rel=1e-9)


def test_what_is_changed_or_cut_is_refused() -> None:
    whole = tape(_program(SOME[0]), Start(0.5, (1.0, 2.0, 3.0, 4.0)))
    load_tape(whole)
    for damaged in (b"", whole[:-1], whole[:40], whole + bytes(8), whole[:100] + b"\xff" + whole[101:]):
        with pytest.raises(DamagedTape):
            load_tape(damaged)


def test_instructions_are_those_of_the_header() -> None:
    header = (c_folder() / "lag" / "tape" / "tape_code.h").read_text(encoding="utf-8")
    special = re.findall(r"^    LAG_TAPE_(\w+),$", header, re.M)
    functions = re.findall(r"^    X\((\w+), [^\d]", header, re.M)
    strided = [f"STRIDED_{name}" for name in re.findall(r"^    X\((\w+), \d\)", header, re.M)]
    assert [*special[:-1], *functions, special[-1], *strided] == list(CODE)
    assert f"#define LAG_TAPE_ANGLES {ANGLES}\n" in header
    head = (c_folder() / "lag" / "tape.h").read_text(encoding="utf-8")
    sizes = re.search(r"enum lag_tape_size \{(.*?)LAG_TAPE_NUMBER_OF_SIZES", head, re.S)
    assert sizes is not None
    assert re.findall(r"LAG_TAPE_(\w+),", sizes[1]) == [name.upper() for name in SIZES]
