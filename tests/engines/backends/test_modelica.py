"""Files of Modelica give the accelerations of the graph, read by a grammar of Base Modelica of the tests' own, and the
motion of the runtime, simulated by Rumoca; pymoca parses them, too."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from base_modelica import Model
from choice import ALL, examples, spread
from fmi.test_values_before_events import COUNTS, DISTANCE, SHIFTS
from fmi.test_values_before_events import NAMES as NAMES_OF_INPUTS
from fmi.test_values_before_events import ROWS as ROWS_OF_INPUTS
from foreign_programs import PEERS, has, in_peers
from hypothesis import given, settings
from hypothesis import strategies as st
from models.kinds import MODELS

import lagdsl
from lagdsl.algebra.graph.evaluate import evaluate
from lagdsl.algebra.graph.operation import Group
from lagdsl.engines.backends.modelica.capability_checks import report_inexpressible
from lagdsl.engines.backends.modelica.emit import ModelicaBackend
from lagdsl.engines.backends.modelica.names import quoted, text
from lagdsl.engines.backends.modelica.variables import STABILIZATION, acceleration, independent, multiplier, rate
from lagdsl.engines.backends.start import start_of
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.exchange.verify.states import random_states
from lagdsl.foundation.diagnostics import Sink
from lagdsl.motion.simulate.initialize import initial_state

ROOT = Path(__file__).parents[3]
CLIENTS = Path(__file__).parent / "clients"
SOME = (
    "double_pendulum",
    "four_bar",
    "pendulum_two_dependent_constraints",
    "rolling_coin",
    "furuta_swing_up",
    "bouncing_ball_modelica",
    "library/blocks_sources",
    "library/parts_with_play",
    "van_der_pol",
)
EVERY = MODELS if ALL else SOME
# Models that flat Modelica has no statements for, with the first statement that is refused.
REFUSED = {
    "ball_on_moving_table": "contact `surface`",
    "billiard_ball_swerves": "contact `table`",
    "billiard_ball_with_draw": "contact `table`",
    "block_on_slope": "contact `ground`",
    "bouncing_ball": "contact `floor`",
    "capstan": "contact `drum[1]`",
    "clutch": "friction `clutch`",
    "coulomb_oscillator": "friction `floor`",
    "disc_starts_to_roll": "contact `road`",
    "drum_brake": "contact `leading`",
    "escapement": "contact `on_upper`",
    "flywheel_brake": "friction `pads`",
    "freewheel": "contact `ratchet`",
    "gripper": "contact `left`",
    "ladder_leaving_wall": "contact `wall`",
    "ladder_with_friction": "contact `ground`",
    "library/ball_on_an_incline": "contact `ground.touch`",
    "library/balls_in_contact": "contact `blow.touch`",
    "library/boxes_in_contact": "contact `front.touch`",
    "library/brakes_and_clutches": "friction `pads.pads`",
    "library/clutch_engagement": "friction `clutch.pads`",
    "library/cylinder_on_an_incline": "contact `ground.rim[1].touch`",
    "library/end_stops": "contact `ends.low`",
    "library/freewheels": "contact `hub.drive`",
    "library/journals": "friction `journal.journal`",
    "library/sliding_on_a_plane": "friction `pad.dry`",
    "library/stick_slip": "friction `belt.dry`",
    "library/stopping_by_friction": "friction `floor.dry`",
    "library/stribeck_bearing": "friction `bearing.dry`",
    "library/wheels_in_contact": "contact `road.touch`",
    "library/worm_hoist": "friction `gear.flanks`",
    "newtons_cradle": "contact `c[1]`",
    "painleve_rod": "contact `ground`",
    "particle_on_sphere": "contact `surface`",
    "pick_and_place": "contact `table`",
    "pinched_capsule": "contact `left`",
    "puck_with_side_force": "friction `ice`",
    "rimless_wheel": "constraint `stands`",
    "rocking_block": "contact `at_left`",
    "sliding_cube": "contact `at_rear`",
    "stacked_blocks": "contact `floor`",
    "standing_quadruped": "contact `leg[1].ground`",
    "stick_slip_belt": "friction `grip`",
    "table_on_four_legs": "contact `leg[1]`",
    "tipping_box": "contact `at_left`",
    "valve_train": "contact `tappet`",
    "wedge": "contact `ramp`",
    "wedge_under_load": "contact `floor`",
    "worm_gear": "contact `flank`",
}
# Models that Rumoca 0.10.2 does not simulate, with its own message.
EXPECTED_FAILURES = {
    "parallelogram": "non-finite",  # starts where its constraints coincide, which only a numerical rank sees
}
ROWS = 101
# A range that is smaller is none: [SI units].
SMALLEST = 1e-6


@cache
def model(name: str) -> lagdsl.Model:
    return lagdsl.compile(ROOT / "models" / f"{name}.lag", engine="tape")


@cache
def written(name: str) -> str:
    return written_of(model(name))


def written_of(model: Any) -> str:
    compilation = model._compilation
    initial = initial_state(compilation.flat, engine_of(compilation.program, "tape"))
    backend = ModelicaBackend(
        compilation.equations, compilation.structure, start_of(compilation.flat, initial.t, initial.x.tolist())
    )
    ((_, found),) = backend.emit(compilation.program).files.items()
    return found


def expressible(names: Any) -> list[str]:
    return [name for name in names if name not in REFUSED]


def state_of(name: str, states: Any, row: int) -> dict[str, float]:
    """Values of the symbols by identifier, without terms that bring a state back to the constraints."""
    flat = model(name)._compilation.flat
    known = {
        Group.Q: [quoted(each.name) for each in flat.coordinates],
        Group.QD: [rate(each.name) for each in flat.coordinates],
        Group.Z: [quoted(each.name) for each in flat.states],
        Group.U: [quoted(each.name) for each in flat.inputs],
        Group.W: [quoted(slot.name) for slot in model(name)._compilation.program.layout.discretes],
        Group.P: [quoted(each.name) for each in independent(flat)],
    }
    values = {n: float(v) for group, names in known.items() for n, v in zip(names, states[group][row], strict=True)}
    return {**values, "time": float(states[Group.TIME][row]), STABILIZATION: 0.0}


@pytest.mark.parametrize("name", spread(expressible(EVERY), 5))
def test_accelerations_are_those_of_the_runtime(name: str) -> None:
    compilation = model(name)._compilation
    program, flat = compilation.program, compilation.flat
    states = random_states(flat, program, 3)
    if not states:
        pytest.skip("no regular state is found")
    found = Model(written(name))
    a, lam = engine_of(program, "tape").solve_many(*(states[g] for g in (*_STATE,)))
    outputs = program.function("output").results[0].elements
    names = [*(acceleration(each.name) for each in flat.coordinates), *(quoted(each.name) for each in flat.outputs)]
    names += [multiplier(slot.name) for slot in program.layout.constraints]
    for row in range(len(states[Group.TIME])):
        solved = {group: states[group][row] for group in _STATE} | {Group.QDD: a[row], Group.LAMBDA: lam[row]}
        y = [float(value) for value in evaluate(program.graph, outputs, solved)]
        got = np.array(found.evaluate(names, state_of(name, states, row)))
        expected = np.array([*a[row], *y, *lam[row]])
        np.testing.assert_allclose(got, expected, rtol=1e-8, atol=1e-8 * np.max(np.abs(expected), initial=1e-3))


_STATE = (Group.TIME, Group.Q, Group.QD, Group.Z, Group.U, Group.W, Group.P)


@pytest.mark.parametrize("name", ["four_bar", "rolling_coin"])
def test_errors_of_constraints_decay_at_the_rate_of_the_parameter(name: str) -> None:
    """J qdd - gamma = -2 a d(phi)/dt - a^2 phi at a state off the constraints, on rows that are independent."""
    compilation = model(name)._compilation
    program, flat = compilation.program, compilation.flat
    states = random_states(flat, program, 1)
    for group in (Group.Q, Group.QD):
        states[group] = states[group] + np.random.default_rng(1).normal(scale=1e-3, size=states[group].shape)
    given = {group: states[group][0] for group in _STATE}
    rows = len(program.layout.constraints)

    def numbers(function: str, block: int) -> np.ndarray:
        elements = program.function(function).results[block].elements
        return np.array([float(value) for value in evaluate(program.graph, elements, given)])

    decay = 7.0
    names = [acceleration(each.name) for each in flat.coordinates]
    a = np.array(Model(written(name)).evaluate(names, state_of(name, states, 0) | {STABILIZATION: decay}))
    j = numbers("dynamics", 2).reshape(rows, -1)
    position = np.array(program.layout.position_level)
    speed = numbers("velocity_constraint", 0)
    terms = np.where(position, 2 * decay * speed + decay**2 * numbers("position_constraint", 0), decay * speed)
    kept = ~np.array(program.layout.redundant)
    assert np.max(np.abs(terms[kept])) > 1e-4
    np.testing.assert_allclose((j @ a - numbers("dynamics", 3) + terms)[kept], 0.0, atol=1e-9 * np.max(np.abs(a)))


@pytest.mark.parametrize("name", spread(SOME, 4))
def test_the_file_is_the_same_every_time_and_declares_each_name_once(name: str) -> None:
    first = written(name)
    written.cache_clear()
    model.cache_clear()
    assert written(name) == first
    declared = re.findall(r"^    (?:\w+ )*?(?:Real|Boolean|Integer) ((?:[A-Za-z]\w*|'[^']*'))", first, re.MULTILINE)
    assert len(declared) == len(set(declared))


@pytest.mark.parametrize("name", REFUSED if ALL else ("bouncing_ball", "clutch"))
def test_statements_without_a_counterpart_are_refused(name: str) -> None:
    sink = Sink()
    report_inexpressible(model(name)._compilation.flat, sink)
    first = sink.diagnostics[0]
    assert first.code == "E0915" and REFUSED[name] in first.message
    assert first.labels[0].span.text


@pytest.mark.skipif(not ALL, reason="it compiles every model: make check-all")
def test_no_other_model_has_such_a_statement() -> None:
    found = []
    for name in MODELS:
        sink = Sink()
        report_inexpressible(model(name)._compilation.flat, sink)
        found += [name] if sink.diagnostics else []
    assert sorted(found) == sorted(REFUSED)


def test_a_reset_that_constraints_pass_on_is_refused() -> None:
    sink = Sink()
    source = """
        model Wire
          coordinate Length x(start = 1 m), y;
          mass 1 kg at {x, y};
          constraint wire: x^2 + y^2 = 1 m2;
          gravity = -g_n*world.y;
          when y < -0.5 m then
            reinit(der(x), 0);
          end when;
        end Wire;
    """
    report_inexpressible(lagdsl.compile(source)._compilation.flat, sink)
    (diagnostic,) = sink.diagnostics
    assert diagnostic.code == "E0915" and "der(x)" in diagnostic.message


def test_delays_are_those_of_modelica() -> None:
    source = """
        model Late
          parameter Time T = 1 s;
          state Real y(start = 1);
        equation
          der(y) = -delay(y, T)/(1 s) + delay(sin(time/(1 s)), 2*T)/(1 s);
        end Late;
    """
    found = written_of(lagdsl.compile(source))
    assert "'delay(y, T)' = delay(y, T);" in found
    assert re.search(r"'delay\(sin\(time/\(1 s\)\), 2\*T\)' = delay\(sin\(.*\), 2\*T\);", found)


@settings(max_examples=examples(300))
@given(st.lists(st.text(min_size=1, max_size=6), min_size=2, max_size=2, unique=True))
def test_names_that_differ_have_identifiers_that_differ(names: list[str]) -> None:
    first, second = map(quoted, names)
    assert first != second
    assert re.fullmatch(r"[A-Za-z]\w*|'[-0-9A-Za-z_!#$%&()*+,./:;<>=?@\[\]{}|~ ^]+'", first, re.ASCII)
    assert not first.startswith("'#")


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ('a "b" \\', '"a \\"b\\" \\\\"'),
        ("line\nline", '"line\\nline"'),
        ("\x00\u2028", '"  "'),
        ("Drehmoment [N·m]", '"Drehmoment [N·m]"'),
    ],
)
def test_texts_cannot_end_their_string(words: str, expected: str) -> None:
    assert text(words) == expected


def by_rumoca(name: str, folder: Path) -> dict[str, Any]:
    """The motion of a file by Rumoca: `time` and `values` by identifier; or `message`."""
    (folder / "0.mo").write_text(written(name), encoding="utf-8")
    flat = model(name)._compilation.flat
    start, stop = flat.experiment.start_time, flat.experiment.stop_time
    job = {
        "file": "0.mo",
        "class": quoted(flat.name),
        "start": start,
        "stop": stop,
        "interval": (stop - start) / (ROWS - 1),
        "inputs": {quoted(each.name): default for each, default in _inputs(name)},
        "tolerance": 1e-11,
        "seconds": 60.0,
    }
    return rumoca_motion(job, folder)


def rumoca_motion(job: dict[str, Any], folder: Path) -> Any:
    (folder / "job.json").write_text(json.dumps([job]))
    in_peers(CLIENTS / "rumoca_motion.py", "job.json", "result.json", folder=folder)
    (found,) = json.loads((folder / "result.json").read_text())
    return found


def _inputs(name: str) -> Any:
    compilation = model(name)._compilation
    program = compilation.program
    given = {Group.TIME: 0.0, Group.P: np.array(program.layout.defaults)}
    defaults = evaluate(program.graph, program.function("start").results[3].elements, given)
    kinds: dict[str, Any] = {"Boolean": bool, "Integer": int, "Enumeration": int}
    inputs = compilation.flat.inputs
    return [(each, kinds.get(each.base, float)(value)) for each, value in zip(inputs, defaults, strict=True)]


@pytest.mark.parametrize("name", expressible(EVERY))
def test_rumoca_finds_the_motion_of_the_runtime(name: str, tmp_path: Path) -> None:
    if not has("rumoca"):
        pytest.skip(f"rumoca is not installed in {PEERS.parents[1]}")
    found = by_rumoca(name, tmp_path)
    if name in EXPECTED_FAILURES:
        assert EXPECTED_FAILURES[name] in found.get("message", "")
        return
    assert "message" not in found, found
    assert found["time"][-1] == pytest.approx(model(name)._compilation.flat.experiment.stop_time)
    flat = model(name)._compilation.flat
    length = flat.experiment.stop_time - flat.experiment.start_time
    ours = model(name).simulate(tolerance=1e-11, interval=length / (ROWS - 1), stop=flat.experiment.stop_time)
    columns = [(each.name, quoted(each.name), 1.0) for each in (*flat.coordinates, *flat.states, *flat.outputs)]
    columns += [(f"der({each.name})", rate(each.name), length) for each in flat.coordinates]
    for own, theirs, per in columns:
        size = _size(ours[own])
        if per != 1.0:
            size = max(size, _size(ours[own.removeprefix("der(")[:-1]]) / per)
        worst = _largest_difference(np.asarray(ours.time), ours[own], found["time"], found["values"][theirs])
        assert worst < 1e-5 * size, own


def test_rumoca_counts_changes_of_inputs(tmp_path: Path) -> None:
    if not has("rumoca"):
        pytest.skip(f"rumoca is not installed in {PEERS.parents[1]}")
    sink = Sink()
    compilation = lagdsl.compile(SHIFTS)._compilation
    report_inexpressible(compilation.flat, sink)
    assert not sink.diagnostics
    backend = ModelicaBackend(compilation.equations, compilation.structure, None)
    ((_, text),) = backend.emit(compilation.program).files.items()
    times, *columns = zip(*ROWS_OF_INPUTS, strict=True)
    inputs = ", ".join(
        f"{quoted(name)} = {_steps(times, column, truth=name == 'brake')}"
        for name, column in zip(NAMES_OF_INPUTS, columns, strict=True)
    )
    (tmp_path / "0.mo").write_text(f"{text}\nmodel Driven\n  Shifts.Shifts driven({inputs});\nend Driven;\n")
    job = {"file": "0.mo", "model": "Driven", "start": 0.0, "stop": 1.0, "interval": 0.05, "tolerance": 1e-9}
    found = rumoca_motion({**job, "inputs": {}, "seconds": 60.0}, tmp_path)
    assert {name: found["values"][name][-1] for name in COUNTS} == COUNTS
    assert found["values"]["x"][-1] == pytest.approx(DISTANCE, rel=1e-6)


def _steps(times: Sequence[float], values: Sequence[int], *, truth: bool) -> str:
    """A function of time that holds each value up to the next row."""
    words = [str(bool(value)).lower() if truth else str(value) for value in values]
    cases = " else ".join(f"if time < {end} then {word}" for end, word in zip(times[1:], words, strict=False))
    return f"{cases} else {words[-1]}"


def _size(values: np.ndarray) -> float:
    """The range of a column; of one that hardly changes, a part of its size."""
    return float(max(np.ptp(values), 1e-3 * np.max(np.abs(values)), SMALLEST))


def _largest_difference(time: np.ndarray, values: np.ndarray, other_time: list[float], others: list[float]) -> float:
    """Just before or just after an event, whichever is nearer: both tables have two rows there."""
    worst = 0.0
    close = 1e-9 * max(1.0, float(time[-1]))
    for t, value in zip(other_time, others, strict=True):
        first, last = np.searchsorted(time, (t - close, t + close))
        if last > first:
            worst = max(worst, float(np.min(np.abs(values[first:last] - value))))
    return worst


@pytest.mark.parametrize("name", expressible(EVERY) if ALL else ("furuta_swing_up", "library/parts_with_play"))
def test_pymoca_parses_the_file(name: str, tmp_path: Path) -> None:
    if not has("pymoca"):
        pytest.skip(f"pymoca is not installed in {PEERS.parents[1]}")
    (tmp_path / "file.mo").write_text(written(name), encoding="utf-8")
    program = "from pymoca.parser import parse; t = parse(open('file.mo').read()); print(*t.classes if t else '')"
    assert quoted(model(name)._compilation.flat.name) in in_peers("-c", program, folder=tmp_path).split()
