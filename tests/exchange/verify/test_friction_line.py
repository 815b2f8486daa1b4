"""The line on dry friction holds for sound models, and tells the friction, the time and the kind of a planted fault."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from models.corpus import compiled
from named_models import compiled as from_text

from lagdsl.derivation.mechanics import arrange
from lagdsl.derivation.program.program import Function
from lagdsl.engines.runtime.engines.tape_engine import TapeEngine
from lagdsl.exchange.verify.certificate import Line
from lagdsl.exchange.verify.certify import certify
from lagdsl.exchange.verify.equations import solutions
from lagdsl.exchange.verify.friction import friction
from lagdsl.exchange.verify.states import random_states
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.model import RateForce
from lagdsl.language.semantics.items import frictions
from lagdsl.motion.pipeline import Compilation

# Pulled by 2 t, held up to 3 N until t = 1.5 s; then it slides against 2 N, until 4.5 N of drag stop it.
PULLED = """
model Pulled
  coordinate Length s;
  kinetic 1/2*(1 kg)*der(s)^2;
  force (if time < 2 s then 2*time/(1 s) else 0)*(1 N) on s;
  friction dry: der(s) with limit = 2 N, sticking = 3 N;
  annotation(experiment(StopTime = 3));
end Pulled;
"""


def line(compilation: Compilation) -> Line:
    (found,) = friction(compilation, interval=compilation.flat.experiment.stop_time / 200)
    return found


# Along a line and in a plane; a clutch; a limit that follows the slip; forces that four rows share in three ways.
@pytest.mark.parametrize(
    "name", ["clutch", "stick_slip_belt", "puck_with_side_force", "block_on_slope", "wedge_under_load"]
)
def test_the_law_holds(name: str) -> None:
    found = line(compiled(name).compilation)
    assert found.verdict == "held", found
    assert found.figure is not None
    assert found.figure < 1e-14


def test_a_model_without_friction_has_no_such_line() -> None:
    assert list(friction(compiled("pendulum").compilation, 0.1)) == []


def changed_loads(factor: float) -> Callable[[pytest.MonkeyPatch], Compilation]:
    """Sliding friction times a factor."""

    def plant(_: pytest.MonkeyPatch) -> Compilation:
        compilation = from_text(PULLED)
        loads = tuple(
            replace(each, value=fx.Binary("*", fx.Number(factor), each.value)) if isinstance(each, RateForce) else each
            for each in compilation.flat.loads
        )
        return replace(compilation, flat=replace(compilation.flat, loads=loads))

    return plant


def wrong_sense(patch: pytest.MonkeyPatch) -> Compilation:
    """The same sign in loads and in the force that is told."""
    patch.setattr(frictions, "_against", lambda limit, way: fx.Binary("*", limit, way))
    return from_text(PULLED)


def scaled_limit(patch: pytest.MonkeyPatch) -> Compilation:
    """The runtime holds up to 1.1 times the limit at rest."""
    sound = arrange.friction_functions

    def off(lowering: Any, flat: Any) -> tuple[Function, ...]:
        (function,) = sound(lowering, flat)
        blocks = list(function.results)
        graph = lowering.graph
        blocks[3] = blocks[3].with_nodes([graph.multiply(graph.constant(1.1), each) for each in blocks[3].nodes])
        return (replace(function, results=tuple(blocks)),)

    patch.setattr(arrange, "friction_functions", off)
    return from_text(PULLED)


def creeping(_: pytest.MonkeyPatch) -> Compilation:
    """Its rows hold another slip than zero: 1 mm/s."""
    compilation = from_text(PULLED)
    (row,) = compilation.flat.constraints
    (part,) = row.residuals
    assert isinstance(part, fx.Binary)
    moved = replace(part, right=fx.Binary("-", part.right, fx.Number(1e-3)))
    return replace(compilation, flat=replace(compilation.flat, constraints=(replace(row, residuals=(moved,)),)))


# The note, and the largest deviation where it has a closed form.
FAULTS: dict[str, tuple[Callable[[pytest.MonkeyPatch], Compilation], str, float | None]] = {
    "the sign of the force": (wrong_sense, "power that is not -R |slip|", None),
    "a limit that is too small": (changed_loads(0.9), "force off its limit while it slides", 0.2 / 3.0),
    "a limit at rest that is too large": (scaled_limit, "force beyond its limit while it sticks", 0.3 / 3.3),
    "rows that creep": (creeping, "slip while it sticks", None),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_is_found(fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    plant, kind, part = FAULTS[fault]
    found = line(plant(monkeypatch))
    assert found.verdict == "failed", found
    assert found.figure is not None
    assert found.note.startswith("largest in dry at t = "), found.note
    assert found.note.endswith(f" s: {kind}")
    if part is not None:
        assert abs(found.figure - part) < 1e-12


def test_the_certificate_has_the_line() -> None:
    found = {each.name: each.verdict for each in certify(compiled("block_on_slope").compilation).lines}
    assert found["friction"] == "held"
    assert "failed" not in found.values()


@pytest.mark.parametrize("name", ["ladder_with_friction", "table_on_four_legs"])
def test_accelerations_are_those_with_the_loads_that_they_cause(name: str) -> None:
    compilation = compiled(name).compilation
    states = random_states(compilation.flat, compilation.program)
    assert solutions(compilation.program, TapeEngine(compilation.program), states).verdict == "held"
