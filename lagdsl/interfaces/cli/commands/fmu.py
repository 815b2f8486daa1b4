"""`lag fmu FILE`: the model as other tools run it."""

from __future__ import annotations

from pathlib import Path

import click

from lagdsl.engines.runtime.building.platforms import PLATFORMS
from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.record import record
from lagdsl.interfaces.cli.command import Command
from lagdsl.interfaces.cli.compile_model import compile_or_leave
from lagdsl.interfaces.cli.groups import PATH, group
from lagdsl.interfaces.cli.model_file import ModelFile, leave_with_errors, read_or_leave, takes_model, tell
from lagdsl.interfaces.cli.options import takes_engine, takes_settings
from lagdsl.interfaces.cli.output import Unwritable, require_ending, require_writable
from lagdsl.interfaces.cli.progress import progress
from lagdsl.language.settings.settings import split
from lagdsl.motion.pipeline import findings


@record(kw_only=True)
class Target:
    """Version of the standard, kind of FMU and platforms of its binaries."""

    version: str
    kind: str
    platforms: tuple[str, ...]


@record(kw_only=True)
class Variables:
    """Names of variables that become outputs and of those to leave out; forms of arrays and clocks."""

    outputs: tuple[str, ...]
    hide: tuple[str, ...]
    scalar: bool
    clocks: bool


@record(kw_only=True)
class Credits:
    """Author, license and version of the model."""

    author: str | None
    license: str | None
    model_version: str | None


_takes_target = group(
    "target",
    Target,
    click.option(
        "--fmi",
        "version",
        type=click.Choice(["2", "3"]),
        default="2",
        show_default=True,
        help="Version of the standard.",
    ),
    click.option(
        "--kind",
        type=click.Choice(["me", "cs", "both"]),
        default="both",
        show_default=True,
        help="Model exchange, co-simulation, or both in one file.",
    ),
    click.option(
        "--platform",
        "platforms",
        type=click.Choice([*PLATFORMS, "all"]),
        multiple=True,
        metavar="NAME",
        help=f"Platform of a binary; default: this machine. One of {', '.join(PLATFORMS)}, all.",
    ),
)
_takes_variables = group(
    "variables",
    Variables,
    click.option(
        "--output", "outputs", multiple=True, metavar="NAME", help="Variable that becomes an output: 'der(theta)'."
    ),
    click.option("--hide", multiple=True, metavar="NAME", help="Parameter or variable to leave out: 'arm.*'."),
    click.option("--scalar", is_flag=True, help="Declare each entry of an array as a variable, as FMI 2 always does."),
    click.option("--clocks", is_flag=True, help="Declare the clocks of `sample` as clocks of FMI 3."),
)
_takes_credits = group(
    "credits",
    Credits,
    click.option("--author", metavar="TEXT", help="Author of the model."),
    click.option("--license", metavar="TEXT", help="License of the model."),
    click.option("--model-version", metavar="TEXT", help="Version of the model."),
)


@click.command("fmu", cls=Command)
@takes_model
@_takes_target
@takes_settings
@_takes_variables
@_takes_credits
@takes_engine
@click.option("--with-source", is_flag=True, help="Put the text of the model into the FMU.")
@click.option("-o", "path", type=PATH, metavar="F.fmu", help="Name of the file; default: MODEL.fmu in this folder.")
def command(
    model_file: ModelFile,
    target: Target,
    assignments: tuple[str, ...],
    variables: Variables,
    credits: Credits,
    engine: EngineName,
    with_source: bool,
    path: Path | None,
) -> None:
    """Write the model in FILE as an FMU. The FMU is validated and run once before it appears.

    Values of --set become the defaults of the FMU. Structural parameters that shape the model become fixed numbers.
    """
    require_ending(path, "FMUs are", ".fmu")
    if file_name := next((name for name in variables.outputs if name.endswith(".fmu")), None):
        raise click.UsageError(f"--output names a variable; the file is `-o {file_name}`")
    if variables.clocks and target.version == "2":
        raise click.UsageError("--clocks needs --fmi 3: FMI 2 has no clocks")
    if both := next((name for name in variables.outputs if name in variables.hide), None):
        raise click.UsageError(f"`{both}` is asked for by --output and left out by --hide; leave one of them out")
    require_writable(path)
    style = model_file.style
    source = read_or_leave(model_file.file, style)
    sink = Sink()
    compilation, chosen = compile_or_leave(model_file, source, sink, split(assignments))
    path = Path(f"{compilation.flat.name}.fmu") if path is None else path
    require_writable(path)

    from lagdsl.exchange.fmi.description.description import Attribution
    from lagdsl.exchange.fmi.variables.ports import Ports
    from lagdsl.interfaces.api.fmu import export_fmu

    machines = PLATFORMS if "all" in target.platforms else tuple(dict.fromkeys(target.platforms))
    ports = Ports(outputs=variables.outputs, hidden=variables.hide, scalar=variables.scalar, clocks=variables.clocks)
    try:
        with progress(path.name) as report:
            export_fmu(
                compilation,
                path,
                version=int(target.version),
                kind=target.kind,
                platforms=machines,
                parameters=chosen.parameters,
                start=chosen.start,
                source=source if with_source else None,
                ports=ports,
                attribution=Attribution(author=credits.author, license=credits.license, version=credits.model_version),
                engine=engine,
                sink=sink,
                progress=report,
            )
    except CompilationFailed as failure:
        leave_with_errors(findings(sink, failure), style)
    except OSError as error:
        raise Unwritable(path, error) from error
    tell(sink.diagnostics, style)
    click.echo(path)
