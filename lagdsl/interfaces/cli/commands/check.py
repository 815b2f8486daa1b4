"""`lag check FILE`: everything that can be found before the first time step."""

from __future__ import annotations

import click

from lagdsl.foundation.diagnostics import Severity
from lagdsl.interfaces.cli.command import Command
from lagdsl.interfaces.cli.model_file import ModelFile, read_or_leave, takes_model, tell
from lagdsl.interfaces.cli.options import takes_settings
from lagdsl.interfaces.cli.progress import progress
from lagdsl.interfaces.cli.status import ERRORS, SUCCESS
from lagdsl.language.flat.events import Events
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.settings import split
from lagdsl.motion.pipeline import Compilation, check

_MOST_NAMED = 8


@click.command("check", cls=Command)
@takes_model
@takes_settings
def command(model_file: ModelFile, assignments: tuple[str, ...]) -> None:
    """Find all errors of the model in FILE, and show its degrees of freedom."""
    style = model_file.style
    source = read_or_leave(model_file.file, style, to_output=True)
    with progress("check"):
        diagnostics, compilation = check(source, model=model_file.model, pairs=split(assignments))
    tell(diagnostics, style, to_output=True)
    wrong = any(d.severity is Severity.ERROR for d in diagnostics)
    if compilation is not None and style == "text":
        click.echo(_line(compilation))
        if compilation.flat.joints:
            click.echo(_joints(compilation))
        happening = _events(compilation.flat.events)
        if happening:
            click.echo(f"events: {happening}")
    click.get_current_context().exit(ERRORS if wrong else SUCCESS)


def _line(compilation: Compilation) -> str:
    """`FourBar: 3 coordinates - 2 independent constraints = 1 degree of freedom; 2 constraint rows, 0 states, ...`."""
    from lagdsl.derivation.structure.structure import structure_text

    layout = compilation.program.layout
    balances = len(compilation.structure.balances)
    lasting = len(layout.constraints) - len(compilation.structure.contacts) - balances
    counts = (
        (lasting, "constraint"),
        (len(layout.states), "state"),
        (len(layout.inputs), "input"),
        (len(layout.outputs), "output"),
    )
    parts = [_counted(number, noun) for number, noun in counts]
    if lasting:
        parts[0] += f" (rank {compilation.structure.rank - balances})"
    shown = _display_units(compilation.flat)
    return f"{compilation.flat.name}: {structure_text(compilation.structure)}; {', '.join(parts)}{shown}"


def _joints(compilation: Compilation) -> str:
    """`joints: revolute A, B, C, D (cut)`, by kind; under it the count for mechanisms in the plane."""
    from lagdsl.derivation.structure.count import gruebler_text

    kinds: dict[str, list[str]] = {}
    for joint in compilation.flat.joints:
        name = f"{joint.name} (cut)" if joint.cut else joint.name
        kinds.setdefault(joint.kind.rpartition(".")[2], []).append(name)
    line = "joints: " + "; ".join(f"{len(names)} {kind} {_listed(names)}" for kind, names in kinds.items())
    counted = gruebler_text(compilation.flat, compilation.structure.redundant, compilation.structure.freedom)
    return f"{line}\n{counted}" if counted else line


def _display_units(flat: FlatModel) -> str:
    """`; shown in deg: a, b`: where people see other units than those of files."""
    from lagdsl.motion.simulate.table import heads_of

    units: dict[str, list[str]] = {}
    for name, unit, kind, shown in heads_of(flat):
        if kind != "rate" and shown.unit not in (unit, "") and (shown.scale, shown.shift) != (1.0, 0.0):
            units.setdefault(shown.unit, []).append(name)
    return "".join(f"; shown in {unit}: {', '.join(_first(names))}" for unit, names in units.items())


def _first(names: list[str]) -> list[str]:
    return [*names[:_MOST_NAMED], *(["..."] if len(names) > _MOST_NAMED else [])]


def _events(events: Events) -> str:
    """`2 contacts (ground, wall); 1 clock (sample(0, 5 ms)); 2 when clauses`; empty without any."""
    named = (
        *(("contact", events.contacts), ("dry friction", events.frictions)),
        *(("discrete variable", events.discretes), ("clock", events.clocks)),
    )
    parts = [f"{_counted(len(items), noun)} {_listed([item.name for item in items])}" for noun, items in named if items]
    numbers = ((len(events.whens), "when clause"), (len(events.relations), "located relation"))
    return "; ".join([*parts, *(_counted(number, noun) for number, noun in numbers if number)])


def _listed(names: list[str]) -> str:
    return f"({', '.join(_first(names))})"


def _counted(number: int, noun: str) -> str:
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"
