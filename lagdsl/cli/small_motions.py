"""Code that `lag linearize`, `lag modes` and `lag trim` share: the state of interest, and the output."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

import click
import numpy as np

from lagdsl.analysis.point import System
from lagdsl.analysis.where import Where
from lagdsl.cli.assignments import constants, fitting, seconds, split
from lagdsl.cli.compile_model import compile_or_leave
from lagdsl.cli.engine import takes_engine
from lagdsl.cli.model_file import Format, leave_with_errors, read_or_leave, takes_model, tell
from lagdsl.cli.output import draft_of, write_text
from lagdsl.diagnostics import CompilationFailed, Sink
from lagdsl.flat.model import FlatModel
from lagdsl.pipeline import findings
from lagdsl.runtime.engines.engine import EngineName
from lagdsl.runtime.engines.selection import engine_of

_Command = TypeVar("_Command", bound=Callable[..., Any])
_Result = TypeVar("_Result")
FORMS = (".json", ".npz", ".csv")
_STEPS = 101
_MOST_TOLD = 12


def takes_state(command: _Command) -> _Command:
    """Add FILE and the options that choose a state."""
    for decorate in (
        click.option("--time", metavar="T", help="Time of the state [s]; default: start of the experiment."),
        click.option(
            "--input",
            "inputs",
            multiple=True,
            metavar="NAME=VALUE",
            help="Value of an input: 'f=2 N'; else its default.",
        ),
        click.option(
            "--set",
            "assignments",
            multiple=True,
            metavar="NAME=VALUE",
            help="Parameter or start value: 'm=2 kg', 'x.start=1 m'.",
        ),
        takes_engine,
        click.option(
            "-o", "--output", type=click.Path(path_type=Path), help="Write the numbers to this .json, .npz or .csv."
        ),
        takes_model,
    ):
        command = decorate(command)
    return command


@dataclass(frozen=True, slots=True, kw_only=True)
class Request:
    """A compiled model, the state that was asked for, and how to tell what was found."""

    system: System
    where: Where
    sink: Sink
    style: Format

    def ask(self, question: Callable[[System, Where, Sink], _Result], where: Where | None = None) -> _Result:
        """The answer; leaves with status 1 where there is none."""
        try:
            answer = question(self.system, self.where if where is None else where, self.sink)
        except CompilationFailed as failure:
            leave_with_errors(findings(self.sink, failure), self.style)
        return answer


def request(
    file: Path,
    model: str | None,
    style: Format,
    time: str | None,
    inputs: tuple[str, ...],
    assignments: tuple[str, ...],
    engine: EngineName,
) -> Request:
    """Compile FILE; leaves where it is wrong."""
    sink = Sink()
    source = read_or_leave(file, style)
    compilation, chosen = compile_or_leave(source, sink, style, model, "graph", split(assignments))
    try:
        computing = engine_of(compilation.program, engine)
    except CompilationFailed as failure:
        leave_with_errors(findings(sink, failure), style)
    layout = compilation.program.layout
    values = dict(zip([slot.name for slot in layout.parameters], layout.defaults, strict=True)) | chosen.parameters
    where = Where(
        p=np.array(list(values.values()), dtype=np.float64),
        t=seconds("--time", time),
        start=chosen.start,
        inputs=constants(compilation.flat, split(inputs)),
    )
    return Request(
        system=System(compilation.flat, compilation.program, computing), where=where, sink=Sink(), style=style
    )


def grid(flat: FlatModel, text: str) -> tuple[str, list[float]]:
    """`P=0:3:31` as a name and values in SI units; limits may have units. Raises UsageError."""
    name, equals, limits = text.partition("=")
    parts = limits.split(":")
    if not equals or len(parts) not in (2, 3):
        raise click.UsageError(f"--vary {text}: expected NAME=FROM:TO or NAME=FROM:TO:COUNT, as in 'P=0 N:3 N:31'")
    name = name.strip()
    base = name.removesuffix(".start")
    rate = base.startswith("der(") and base.endswith(")")
    quantities = [*flat.parameters, *flat.inputs, *flat.coordinates, *flat.states]
    found = next((item for item in quantities if item.name == (base[4:-1] if rate else base)), None)
    if found is None or (found in flat.parameters and base != name):
        known = [*(p.name for p in flat.parameters), *(i.name for i in flat.inputs)]
        listing = ", ".join(known[:_MOST_TOLD])
        raise click.UsageError(f"--vary {name}: {flat.name} has no such parameter, input or start value; {listing} ...")
    count = _count(text, parts[2]) if len(parts) == 3 else _STEPS
    first, last = (fitting(found, name, part.strip(), rate=rate) for part in parts[:2])
    if first == last:
        raise click.UsageError(f"--vary {text}: the range from {first:g} to {last:g} is empty")
    return name, np.linspace(first, last, count).tolist()


def _count(text: str, digits: str) -> int:
    if not digits.strip().isdigit() or not 2 <= int(digits) <= 100_000:
        raise click.UsageError(f"--vary {text}: the number of values must be an integer from 2 to 100000")
    return int(digits)


def require_form(path: Path | None) -> None:
    """Leave with status 2, before the work is done, where a file of that ending is not written."""
    if path is not None and path.suffix.lower() not in FORMS:
        raise click.UsageError(f"{path.name}: numbers are written as {', '.join(FORMS)}")


def finish(asked: Request, text: str, data: dict[str, Any], table: list[list[Any]], output: Path | None) -> None:
    """Tell warnings; then the text, or JSON, or a file with the numbers."""
    tell(asked.sink.diagnostics, asked.style)
    if output is None:
        click.echo(_json(data) if asked.style == "json" else text)
        return
    match output.suffix.lower():
        case ".json":
            write_text(_json(data) + "\n", output)
        case ".csv":
            write_text("".join(",".join(_cell(cell) for cell in row) + "\n" for row in table), output)
        case _:
            with draft_of(output) as draft, draft.open("wb") as file:
                arrays: dict[str, Any] = {name: np.asarray(value) for name, value in data.items()}
                np.savez(file, **arrays)


def _cell(cell: object) -> str:
    text = repr(float(cell)) if isinstance(cell, (float, np.floating)) else str(cell)
    return f'"{text}"' if "," in text else text


def _json(data: dict[str, Any]) -> str:
    return json.dumps({name: _plain(value) for name, value in data.items()}, indent=2, allow_nan=False)


def _plain(value: Any) -> Any:
    """Complex numbers as pairs; what is no number as null, infinite ones too."""
    if isinstance(value, np.ndarray):
        return _plain(value.tolist())
    if isinstance(value, complex):
        return [_plain(value.real), _plain(value.imag)]
    if isinstance(value, float):
        return value if np.isfinite(value) else None
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    return value
