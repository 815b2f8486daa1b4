"""`lag build FILE --target T -o DIR`: a module that stands alone."""

from __future__ import annotations

from pathlib import Path
from shutil import copyfile
from typing import TYPE_CHECKING

import click

from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.diagnostics.suggest import did_you_mean, listing
from lagdsl.foundation.record import record
from lagdsl.interfaces.cli.command import Command
from lagdsl.interfaces.cli.groups import PATH, group
from lagdsl.interfaces.cli.model_file import ModelFile, leave_with_errors, read_or_leave, takes_model, tell
from lagdsl.interfaces.cli.options import takes_derivation
from lagdsl.interfaces.cli.output import Unwritable, draft_of, write_text
from lagdsl.interfaces.cli.progress import progress
from lagdsl.language.flat.fixed_parameters import fix_parameters, matching_values
from lagdsl.language.flat.listing import frame_names, point_names
from lagdsl.language.settings.settings import settings, split
from lagdsl.motion.pipeline import Compilation, Route, compile_flat, flatten_file

if TYPE_CHECKING:
    from lagdsl.derivation.program.program import Program
    from lagdsl.engines.backends.backend import Backend
    from lagdsl.engines.backends.start import Start
    from lagdsl.language.flat.model import FlatModel

_TARGETS = ("numpy", "c", "casadi", "jax", "modelica")


@record(kw_only=True)
class Functions:
    """Functions that a module has in addition: terms of the equations, kinematics of frames and points."""

    terms: bool
    frames: tuple[str, ...]
    points: tuple[str, ...]

    @property
    def wanted(self) -> bool:
        return bool(self.terms or self.frames or self.points)


_takes_functions = group(
    "functions",
    Functions,
    click.option("--terms", is_flag=True, help="Add the Coriolis matrix, gravity and bias forces, and the regressor."),
    click.option(
        "--frame",
        "frames",
        multiple=True,
        metavar="NAME",
        help="Add the kinematics of this frame: pose, Jacobian, velocity.",
    ),
    click.option("--point", "points", multiple=True, metavar="NAME", help="Add the kinematics of this point."),
)


@click.command("build", cls=Command)
@takes_model
@click.option("--target", type=click.Choice(_TARGETS), required=True, help="Language of the module.")
@click.option("-o", "--output", "folder", type=PATH, required=True, help="Folder to write to.")
@takes_derivation
@click.option(
    "--fix",
    "fixed",
    multiple=True,
    metavar="NAME[=VALUE]",
    help="Make a parameter a number of the module: 'm', 'm=2 kg', 'arm.*' or '*'. The equations become shorter.",
)
@_takes_functions
@click.option("--batch", is_flag=True, help="With C: add functions of many states and many directions at once.")
def command(
    model_file: ModelFile,
    target: str,
    folder: Path,
    derivation: Route,
    fixed: tuple[str, ...],
    functions: Functions,
    batch: bool,
) -> None:
    """Write the equations of motion of FILE as one file for NumPy, CasADi, JAX or a Modelica tool, or as C sources with
    header, Makefile and examples."""
    if batch and target != "c":
        raise click.UsageError("--batch is for --target c: the NumPy module takes many states at once in every case")
    if derivation == "textbook" and functions.wanted:
        raise click.UsageError("--terms, --frame and --point need the derivation `graph`")
    if target == "modelica" and (derivation == "textbook" or functions.wanted):
        raise click.UsageError("--target modelica takes neither --derivation textbook nor --terms, --frame and --point")
    style = model_file.style
    source = read_or_leave(model_file.file, style)
    sink = Sink()
    flat = flatten_file(source, sink, model=model_file.model)
    if flat is not None and fixed:
        flat = _with_fixed(flat, fixed, sink)
    with progress("compile"):
        compilation = compile_flat(flat, sink, derivation) if flat is not None else None
    if compilation is None:
        leave_with_errors(sink.diagnostics, style)
    try:
        program = _with_functions(compilation, functions)
    except CompilationFailed as failure:
        leave_with_errors(failure.diagnostics, style)
    from lagdsl.engines.backends.reserved import Language, report_renamed

    language: Language = "c" if target == "c" else "modelica" if target == "modelica" else "python"
    report_renamed(compilation.program.name, language, sink)
    backend = _backend(target, compilation, batch, sink)
    if backend is None:
        leave_with_errors(sink.diagnostics, style)
    tell(sink.diagnostics, style)
    with progress("write"):
        artifact = backend.emit(program)
    for name, text in artifact.files.items():
        path = _made_room(folder / name)
        write_text(text, path)
        click.echo(path)
    if target == "c":
        _write_runtime(folder)


def _write_runtime(folder: Path) -> None:
    """The runtime as objects for this machine, if the installation brings them: after its sources, so that they are
    newer."""
    from lagdsl.engines.runtime.building.platforms import PLATFORMS, platform_of, this_machine
    from lagdsl.exchange.fmi.package.installed_objects import installed_runtime

    own = this_machine()
    objects = installed_runtime(platform_of(own)) if own in PLATFORMS else {}
    for name, file in objects.items():
        path = _made_room(folder / "lib" / own / name)
        with draft_of(path) as draft:
            copyfile(file, draft)
        click.echo(path)


def _made_room(path: Path) -> Path:
    """The same path; its folder is there. Leaves with status 2 where it cannot be made."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise Unwritable(path.parent, error) from error
    return path


def _backend(target: str, compilation: Compilation, batch: bool, sink: Sink) -> Backend | None:
    """The backend of a target; None where it cannot express the model, which `sink` is told."""
    from lagdsl.engines.backends.c.emit import CBackend
    from lagdsl.engines.backends.capability_checks import report_loads_to_find
    from lagdsl.engines.backends.modelica.capability_checks import report_inexpressible
    from lagdsl.engines.backends.modelica.emit import ModelicaBackend
    from lagdsl.engines.backends.registry import BACKENDS

    if target == "c":
        return CBackend(batch=batch, start=_start(compilation))
    report_loads_to_find(compilation.flat, target, sink)
    if target != "modelica":
        return None if sink.has_errors else BACKENDS[target]
    report_inexpressible(compilation.flat, sink)
    if sink.has_errors:
        return None
    return ModelicaBackend(compilation.equations, compilation.structure, _start(compilation))


def _with_functions(compilation: Compilation, functions: Functions) -> Program:
    """The program with what `--terms`, `--frame` and `--point` add. Raises UsageError for a name that the model does
    not have."""
    from lagdsl.derivation.mechanics.by_name import with_equation_terms, with_kinematics, with_regressor

    program = compilation.program
    for option, given, known in (
        ("--frame", functions.frames, frame_names(compilation.flat)),
        ("--point", functions.points, point_names(compilation.flat)),
    ):
        for name in given:
            if name not in known:
                hint = did_you_mean(name, known, f"there are {listing(name, known)}")
                raise click.UsageError(f"{option}: the model has no `{name}`: {hint}")
    if functions.terms:
        program = with_regressor(compilation.equations, with_equation_terms(compilation.equations, program))
    if not functions.frames and not functions.points:
        return program
    return with_kinematics(compilation.equations, program, functions.frames, functions.points)


def _with_fixed(flat: FlatModel, fixed: tuple[str, ...], sink: Sink) -> FlatModel:
    """The parameters of `--fix` as numbers. Raises UsageError for what cannot be fixed so."""
    given = settings(flat, split([each for each in fixed if "=" in each]), sink)
    if given.start:
        raise click.UsageError(f"--fix takes parameters; `{next(iter(given.start))}` is a start value")
    try:
        values = matching_values(flat, [each.strip() for each in fixed if "=" not in each])
        return fix_parameters(flat, {**values, **given.parameters, **given.structural})
    except KeyError as error:
        raise click.UsageError(f"--fix: {error.args[0]}") from error


def _start(compilation: Compilation) -> Start | None:
    """The start of the motion; None if there is no consistent one, because the equations are useful without it.
    With free parameters there is none for the values that the module brings: it is found when a run begins."""
    from lagdsl.engines.backends.start import free_parameters, start_of
    from lagdsl.motion.simulate.initialize import initial_state

    sink = Sink()
    initial = initial_state(compilation.flat, engine_of(compilation.program), sink=sink)
    if sink.has_errors:
        return None
    if free_parameters(compilation.flat):
        return start_of(compilation.flat, initial.t, ())
    return start_of(compilation.flat, initial.t, (*initial.q.tolist(), *initial.qd.tolist(), *initial.z.tolist()))
