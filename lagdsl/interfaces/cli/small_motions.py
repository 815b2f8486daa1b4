"""Code that `lag linearize`, `lag modes` and `lag trim` share: the state of interest, and the output."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, TypeAlias, TypeVar

import click
import numpy as np

from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.source import SourceFile
from lagdsl.interfaces.cli.compile_model import compile_or_leave
from lagdsl.interfaces.cli.groups import PATH, Decorator, group
from lagdsl.interfaces.cli.inputs import inputs_or_leave
from lagdsl.interfaces.cli.model_file import ModelFile, leave_with_errors, read_or_leave, takes_model, tell
from lagdsl.interfaces.cli.options import InputOptions, takes_engine, takes_inputs, takes_settings
from lagdsl.interfaces.cli.output import Forms, draft_of, form_of, require_writable, write_text
from lagdsl.interfaces.cli.progress import progress
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.settings.failure import SettingError
from lagdsl.language.settings.literal import seconds
from lagdsl.language.settings.settings import split
from lagdsl.motion.analysis.point import System
from lagdsl.motion.analysis.where import Where
from lagdsl.motion.pipeline import findings
from lagdsl.motion.signals.inputs import Signal, given_inputs, signals

_Result = TypeVar("_Result")
Form: TypeAlias = Literal["text", "json", "csv"]
_ENDINGS: dict[str, Form | Literal["npz"]] = {".json": "json", ".npz": "npz", ".csv": "csv"}


@dataclass(frozen=True, slots=True, kw_only=True)
class EquilibriumOptions:
    """True for an equilibrium, names of its unknowns and of none, and True for a steady motion."""

    trim: bool
    free: tuple[str, ...]
    hold: tuple[str, ...]
    steady: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class Options:
    """Options that all three commands have: they choose a state and the form of the result."""

    model_file: ModelFile
    assignments: tuple[str, ...]
    inputs: InputOptions
    time: str | None
    equilibrium: EquilibriumOptions
    engine: EngineName
    form: Form | None
    output: Path | None


_takes_equilibrium = group(
    "equilibrium",
    EquilibriumOptions,
    click.option("--trim", is_flag=True, help="Take the equilibrium nearest to this state."),
    click.option(
        "--free",
        multiple=True,
        metavar="NAME",
        help="With --trim: add an unknown: an input, a rate der(x), a fixed coordinate.",
    ),
    click.option(
        "--hold", multiple=True, metavar="NAME", help="With --trim: remove an unknown; it keeps its start value."
    ),
    click.option("--steady", is_flag=True, help="With --trim: keep the rates of the start and find a steady motion."),
)


def takes_state_and_form(option: str) -> Decorator:
    """Add FILE and the options that choose a state and, with `option`, the form of the result; the command gets them
    as `options`."""
    return group(
        "options",
        Options,
        takes_model,
        takes_settings,
        takes_inputs,
        click.option("--time", metavar="T", help="Time of the state [s]; default: start of the experiment."),
        _takes_equilibrium,
        takes_engine,
        click.option(
            option,
            "form",
            type=Forms(["text", "json", "csv"], {".txt": "text"}),
            help="Form of the result on standard output; default: text.",
        ),
        click.option("-o", "--output", type=PATH, help="Write the numbers to this .json, .npz or .csv."),
    )


takes_state = takes_state_and_form("--to")


takes_every: Decorator = click.option(
    "--every",
    metavar="T",
    help="Sample with this period, '2 ms': a model with clocks as the loop, over a multiple of their period.",
)


def period_or_leave(text: str | None) -> float | None:
    """The period of `--every` [s]. Raises SettingError."""
    period = seconds("--every", text)
    if period is not None and not period > 0.0:
        raise SettingError(f"--every={text}: a period is longer than zero")
    return period


@dataclass(frozen=True, slots=True, kw_only=True)
class Request:
    """A compiled model, the state that was asked for, and how to tell what was found."""

    system: System
    where: Where
    sink: Sink
    options: Options
    source: SourceFile

    def ask(self, question: Callable[[System, Where, Sink], _Result]) -> _Result:
        """The answer; leaves with status 1 where there is none."""
        try:
            with progress("compute"):
                answer = question(self.system, self.where, self.sink)
        except CompilationFailed as failure:
            leave_with_errors(findings(self.sink, failure), self.options.model_file.style)
        return answer


def request(options: Options, *, trim: bool = False) -> Request:
    """Compile FILE; leaves where it is wrong. With `trim` the state is an equilibrium without `--trim`, too. Raises
    SettingError."""
    model_file, sink = options.model_file, Sink()
    style, equilibrium = model_file.style, options.equilibrium
    trim = trim or equilibrium.trim
    _require_sound(options, trim)
    source = read_or_leave(model_file.file, style)
    given = inputs_or_leave(options.inputs, style)
    compilation, chosen = compile_or_leave(model_file, source, sink, split(options.assignments))
    flat = compilation.flat
    inputs = given.of(flat, sink, style)
    try:
        computing = engine_of(compilation.program, options.engine)
    except CompilationFailed as failure:
        leave_with_errors(findings(sink, failure), style)
    layout = compilation.program.layout
    values = dict(zip([slot.name for slot in layout.parameters], layout.defaults, strict=True)) | chosen.parameters
    time = seconds("--time", options.time)
    where = Where(
        p=np.array(list(values.values()), dtype=np.float64),
        t=time,
        start=chosen.start,
        inputs=_values_at(flat, inputs, flat.experiment.start_time if time is None else time, sink),
        trim=trim,
        free=equilibrium.free,
        hold=equilibrium.hold,
        steady=equilibrium.steady,
    )
    if sink.has_errors:
        leave_with_errors(sink.diagnostics, style)
    return Request(
        system=System(flat, compilation.program, computing), where=where, sink=sink, options=options, source=source
    )


def _require_sound(options: Options, trim: bool) -> None:
    """Leave with status 2, before the work is done, where options contradict each other."""
    equilibrium = options.equilibrium
    if not trim and (equilibrium.free or equilibrium.hold or equilibrium.steady):
        raise click.UsageError("--free, --hold and --steady choose an equilibrium: give --trim, too")
    form_of(options.output, options.form, _ENDINGS, "text")
    require_writable(options.output)


def _values_at(flat: FlatModel, inputs: dict[str, Signal], time: float, sink: Sink) -> dict[str, float]:
    """The inputs that are given, with their derivatives, at one time; tables are read there."""
    found: Floats = signals(flat, np.zeros(len(flat.inputs)), inputs, (time, time), sink).at(time)
    told = given_inputs(flat, inputs)
    return {item.name: value for item, value, given in zip(flat.inputs, found.tolist(), told, strict=True) if given}


def finish(asked: Request, text: str, data: dict[str, Any], table: list[list[Any]]) -> None:
    """Tell warnings; then the text, or JSON, or a file with the numbers."""
    options, sink = asked.options, asked.sink
    output = options.output
    form = form_of(output, options.form, _ENDINGS, "text")
    if options.form is None and output is None and options.model_file.style == "json":
        form = "json"
        sink.report("N0877", None, old="--format json", new="--to json", why="--format is for diagnostics")
    tell(sink.diagnostics, options.model_file.style)
    match form:
        case "json":
            write_text(_json(data) + "\n", output)
        case "csv":
            write_text("".join(",".join(_cell(cell) for cell in row) + "\n" for row in table), output)
        case "npz" if output is not None:
            with draft_of(output) as draft, draft.open("wb") as file:
                arrays: dict[str, Any] = {name: np.asarray(value) for name, value in data.items()}
                np.savez(file, **arrays)
        case _:
            write_text(text + "\n", output)


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
