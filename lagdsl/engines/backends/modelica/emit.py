"""One file with the equations of a model, in what flat Modelica and Base Modelica (MCP-0031) have in common."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.derivation.mechanics.equations import Equations
from lagdsl.derivation.program.program import Program
from lagdsl.derivation.structure.structure import Structure
from lagdsl.engines.backends.backend import Artifact
from lagdsl.engines.backends.identifier import identifier
from lagdsl.engines.backends.modelica.body import Body, body_of
from lagdsl.engines.backends.modelica.declarations import declarations
from lagdsl.engines.backends.modelica.equations import equations_of
from lagdsl.engines.backends.modelica.expressions import literal
from lagdsl.engines.backends.modelica.names import quoted, text
from lagdsl.engines.backends.reserved import MODELICA_NAMES
from lagdsl.engines.backends.start import Start
from lagdsl.language.flat.quantity import Experiment

_INTRODUCTION = """\
//! base 0.1.0
// Equations of motion of one model, generated: flat Modelica that is Base Modelica, too.
// All values in SI units. Names with characters that Modelica does not allow are quoted, as 'arm.theta';
// 'der(theta)' is the rate of theta; '#1', '#2' ... are intermediate results.
"""


class ModelicaBackend:
    """Target `modelica`. The program is one of `equations`; `start` is a consistent state for its defaults."""

    name = "modelica"

    def __init__(self, equations: Equations, structure: Structure, start: Start | None) -> None:
        self._equations, self._structure, self._start = equations, structure, start

    def emit(self, program: Program) -> Artifact:
        name = f"{identifier(program.name, MODELICA_NAMES)}.mo"
        return Artifact({name: source(body_of(self._equations, program, self._structure, self._start))})


def source(body: Body) -> str:
    """The text of the file."""
    flat = body.flat
    name = quoted(flat.name)
    doc = f" {text(flat.doc)}" if flat.doc else ""
    lines = [
        f"  model {name}{doc}",
        *_indented(declarations(body)),
        "  equation",
        *_indented(equations_of(body)),
        f"    annotation(experiment({_experiment(flat.experiment)}));",
        f"  end {name};",
    ]
    return _INTRODUCTION + "\n".join([f"package {name}", *lines, f"end {name};", ""])


def _indented(lines: Sequence[str]) -> list[str]:
    return [f"    {line}" for line in lines]


def _experiment(experiment: Experiment) -> str:
    given = {
        "StartTime": experiment.start_time,
        "StopTime": experiment.stop_time,
        "Tolerance": experiment.tolerance,
        "Interval": experiment.interval,
    }
    return ", ".join(f"{key} = {literal(value)[0]}" for key, value in given.items() if value is not None)
