"""A certificate holds for sound models, and names the line where a fault is planted."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from choice import ALL, EXPLORE, chosen, spread
from click.testing import CliRunner
from models.corpus import MODELS, compiled, path_of
from named_models import compiled as from_text

import lagdsl
from lagdsl.derivation.mechanics.lagrange import lagrange
from lagdsl.derivation.mechanics.lagrange.through_states import ThroughStates
from lagdsl.derivation.program.program import Program
from lagdsl.engines.runtime.engines.c_engine import CEngine
from lagdsl.engines.runtime.engines.numpy_engine import NumpyEngine
from lagdsl.engines.runtime.engines.tape_engine import TapeEngine
from lagdsl.exchange.verify import certify as certify_module
from lagdsl.exchange.verify import motion as motion_module
from lagdsl.exchange.verify import order as order_module
from lagdsl.exchange.verify.certificate import Certificate
from lagdsl.exchange.verify.certify import certify
from lagdsl.exchange.verify.conserved import find as find_module
from lagdsl.exchange.verify.forms import FORMS
from lagdsl.interfaces.cli.main import lag
from lagdsl.motion.pipeline import Compilation

NAME = "bead_on_circular_wire_redundant"  # a constraint, a load, dissipation


# Certificates take half a minute each, and their lines stand in tests of their own for all models.
SOME = ("double_pendulum", NAME, "servo_drive", "van_der_pol")
# No regular state of it is near the start; complex steps through friction at many corners are no derivatives.
LEFT_OUT = ("capstan", "library/boxes_in_contact")
SOUND = [name for name in MODELS if name not in LEFT_OUT]
EVERY = SOUND if EXPLORE else [*SOME, *(name for name in SOUND[::6] if name not in SOME)]


@pytest.mark.parametrize("name", chosen(EVERY, SOME))
def test_every_line_holds(name: str) -> None:
    found = certify(compiled(name).compilation)
    assert [(line.name, line.figure) for line in found.lines if line.verdict == "failed"] == []
    assert sum(line.verdict == "held" for line in found.lines) >= 6


def failing(found: Certificate) -> set[str]:
    return {line.name for line in found.lines if line.verdict == "failed"}


def wrong(program: Program, function: str, block: int) -> Program:
    """The same with the sign of the first element of a result that is not zero turned."""
    blocks = list(program.function(function).results)
    first, *others = blocks[block].nodes
    blocks[block] = blocks[block].with_nodes([program.graph.negate(first), *others])
    functions = [replace(each, results=tuple(blocks)) if each.name == function else each for each in program.functions]
    return replace(program, functions=tuple(functions))


def in_program(function: str, block: int) -> Callable[[pytest.MonkeyPatch], Compilation]:
    def plant(_: pytest.MonkeyPatch) -> Compilation:
        compilation = compiled(NAME).compilation
        return replace(compilation, program=wrong(compilation.program, function, block))

    return plant


def in_method(engine: type, method: str) -> Callable[[pytest.MonkeyPatch], Compilation]:
    """An engine that gives something else by a millionth of a part."""

    def plant(patch: pytest.MonkeyPatch) -> Compilation:
        sound = getattr(engine, method)

        def off(self: Any, *arguments: Any) -> Any:
            found = sound(self, *arguments)
            return tuple(1.000001 * block for block in found) if isinstance(found, tuple) else 1.000001 * found

        patch.setattr(engine, method, off)
        return compiled(NAME).compilation

    return plant


def dropped_load(_: pytest.MonkeyPatch) -> Compilation:
    compilation = compiled(NAME).compilation
    return replace(compilation, flat=replace(compilation.flat, loads=()))


def states_not_held(patch: pytest.MonkeyPatch) -> Compilation:
    """Forces by which a carriage that follows its passenger would be moved by it."""
    none = ThroughStates([0], [0])
    patch.setattr(lagrange, "through_states", lambda *_: none)
    return from_text(
        "model Carriage coordinate Length x(start = 1 m); state Length p; mass 1 kg at {x + p, 0 m};"
        "kinetic 1/2*(1 kg)*der(x)^2; equation der(p) = x/(1 s); end Carriage;"
    )


def drifting(patch: pytest.MonkeyPatch) -> Compilation:
    sound = motion_module.simulate

    def off(*arguments: Any, **options: Any) -> Any:
        found = sound(*arguments, **options)
        return replace(found, checks=found.checks[:3] + 1e-3)

    patch.setattr(motion_module, "simulate", off)
    return compiled(NAME).compilation


def false_claim(_: pytest.MonkeyPatch) -> Compilation:
    text = path_of(NAME).read_text().replace("  constraint wire", "  invariant x_stays: x;\n  constraint wire")
    return from_text(text)


def gaining(patch: pytest.MonkeyPatch) -> Compilation:
    """A motion whose rates grow by a part of 1e-6."""
    sound = motion_module.simulate

    def off(*arguments: Any, **options: Any) -> Any:
        found = sound(*arguments, **options)
        columns = tuple(
            replace(column, values=column.values * (1 + 1e-6 * found.time)) if column.kind == "rate" else column
            for column in found.columns
        )
        return replace(found, columns=columns)

    patch.setattr(motion_module, "simulate", off)
    return compiled("double_pendulum").compilation


def believing(patch: pytest.MonkeyPatch) -> Compilation:
    """A search that takes everything for constant."""
    patch.setattr(find_module, "ZERO", 10.0)
    return compiled("double_pendulum").compilation


def of_another_order(patch: pytest.MonkeyPatch) -> Compilation:
    patch.setattr(order_module, "_METHOD", "ros2")
    return compiled(NAME).compilation


FAULTS = {
    "a value in the NumPy emitter": (in_method(NumpyEngine, "evaluate"), "engine numpy"),
    "a value on the tape": (in_method(TapeEngine, "evaluate"), "engine tape"),
    "a value in the C emitter": (in_method(CEngine, "evaluate"), "engine c"),
    "a sign in the mass matrix": (in_program("mass_matrix", 0), "two derivations"),
    "a wrong gamma": (in_program("dynamics", 3), "two derivations"),
    "a sign in the residual": (in_program("residual", 0), "two derivations"),
    "a sign in the power of the loads": (in_program("power", 0), "power balance"),
    "a dropped load": (dropped_load, "two derivations"),
    "a wrong tangent": (in_method(TapeEngine, "jacobian"), "tangents"),
    "a wrong solution": (in_method(TapeEngine, "solve"), "solution"),
    "states that are not held": (states_not_held, "power balance"),
    "constraints that drift": (drifting, "constraints"),
    "an invariant that is none": (false_claim, "motion"),
    "a motion that gains energy": (gaining, "conserved energy()"),
    "a search that believes everything": (believing, "conserved momentum(a)"),
    "a wrong tangent of the constraints": (in_program("constraint_tangent", 1), "tangents of the motion"),
    "a method of another order": (of_another_order, "order of the steps"),
}


@pytest.mark.parametrize("fault", spread(FAULTS, 5))
def test_the_line_of_a_fault_fails(fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    plant, line = FAULTS[fault]
    found = certify(plant(monkeypatch))
    assert line in failing(found)
    assert not found.holds


def test_forms() -> None:
    found = replace(certify(compiled("pendulum").compilation), model="<b>&")
    told = json.loads(FORMS["json"](found))
    assert told["holds"] is True
    assert [line["name"] for line in told["lines"]] == [line.name for line in found.lines]
    assert "<b>&" not in FORMS["html"](found)
    assert "&lt;b&gt;&amp;" in FORMS["html"](found)
    assert str(found) == FORMS["text"](found)
    assert "lines held" in str(found)


def test_the_command_says_the_same(tmp_path: Any) -> None:
    target = tmp_path / "certificate.json"
    done = CliRunner().invoke(lag, ["verify", str(path_of("pendulum")), "-o", str(target)])
    assert done.exit_code == 0, done.output
    assert json.loads(target.read_text())["model"] == "Pendulum"
    assert lagdsl.compile(path_of("pendulum")).verify().holds


def test_a_failed_line_is_the_status_of_the_command(monkeypatch: pytest.MonkeyPatch) -> None:
    in_method(NumpyEngine, "evaluate")(monkeypatch)
    done = CliRunner().invoke(lag, ["verify", str(path_of("pendulum"))])
    assert done.exit_code == 3
    assert "FAILED  engine numpy" in done.output


def test_no_regular_state_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(certify_module, "random_states", lambda *_: {})
    found = certify(compiled("pendulum").compilation)
    assert found.lines[0].verdict == "left out"
    assert np.all([line.name != "two derivations" for line in found.lines])


@pytest.mark.parametrize("part", [0.0, 1e-2])
def test_a_wrong_fmu_is_named(part: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """An importer that gives the motion of the runtime, and one that gives another."""
    from lagdsl.exchange.verify import fmu as fmu_module

    compilation = compiled("pendulum").compilation
    sound = lagdsl.compile(path_of("pendulum"))

    def run(_: Any, version: int, kind: str, stop: float, rows: int, names: list[str]) -> Any:
        motion = sound.simulate(stop=stop, interval=stop / (rows - 1))
        off = part if (version, kind) == (3, "me") else 0.0
        return motion.time, (1.0 + off) * np.stack([motion[name] for name in names], axis=1)

    monkeypatch.setattr(fmu_module, "motion_by_fmpy", run)
    lines = list(fmu_module.round_trips(compilation, TapeEngine(compilation.program)))
    assert len(lines) == 4
    assert [line.name for line in lines if line.verdict != "held"] == (["FMI 3.0 model exchange"] if part else [])


@pytest.mark.skipif(not ALL, reason="exports four FMUs: tests/exchange/fmi runs each kind")
@pytest.mark.parametrize("name", ["bead_on_circular_wire", "bouncing_ball"])
def test_fmus_in_fmpy_have_the_motion(name: str) -> None:
    pytest.importorskip("fmpy")
    found = [line for line in certify(compiled(name).compilation, fmu=True).lines if line.name.startswith("FMI")]
    assert [line.verdict for line in found] == ["held"] * 4
