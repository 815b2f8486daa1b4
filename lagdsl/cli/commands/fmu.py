"""`lag fmu FILE`: the model as other tools run it."""

from __future__ import annotations

from pathlib import Path

import click

from lagdsl.cli.command import Command
from lagdsl.cli.compile_model import compile_or_leave
from lagdsl.cli.model_file import Format, leave_with_errors, read_or_leave, takes_model, tell
from lagdsl.cli.options import PATH, takes_engine, takes_settings
from lagdsl.cli.output import Unwritable, require_ending, require_writable
from lagdsl.cli.progress import progress
from lagdsl.diagnostics import CompilationFailed, Sink
from lagdsl.pipeline import findings
from lagdsl.runtime.building.platforms import PLATFORMS
from lagdsl.runtime.engines.engine import EngineName
from lagdsl.settings.settings import split


@click.command("fmu", cls=Command)
@takes_model
@click.option(
    "--fmi", "version", type=click.Choice(["2", "3"]), default="2", show_default=True, help="Version of the standard."
)
@click.option(
    "--kind",
    type=click.Choice(["me", "cs", "both"]),
    default="both",
    show_default=True,
    help="Model exchange, co-simulation, or both in one file.",
)
@click.option(
    "--platform",
    "platforms",
    type=click.Choice([*PLATFORMS, "all"]),
    multiple=True,
    metavar="NAME",
    help=f"Platform of a binary; default: this machine. One of {', '.join(PLATFORMS)}, all.",
)
@takes_settings
@takes_engine
@click.option("--with-source", is_flag=True, help="Put the text of the model into the FMU.")
@click.option("-o", "--output", type=PATH, metavar="F.fmu", help="Name of the file; default: MODEL.fmu in this folder.")
def command(
    file: Path,
    model: str | None,
    style: Format,
    version: str,
    kind: str,
    platforms: tuple[str, ...],
    assignments: tuple[str, ...],
    engine: EngineName,
    with_source: bool,
    output: Path | None,
) -> None:
    """Write the model in FILE as an FMU. The FMU is validated and run once before it appears.

    Values of --set are the defaults of the FMU; structural parameters become numbers of it.
    """
    require_ending(output, "FMUs are", ".fmu")
    require_writable(output)
    source = read_or_leave(file, style)
    sink = Sink()
    compilation, chosen = compile_or_leave(source, sink, style, model, "graph", split(assignments))
    path = Path(f"{compilation.flat.name}.fmu") if output is None else output
    require_writable(path)

    from lagdsl.api.fmu import export_fmu

    machines = PLATFORMS if "all" in platforms else tuple(dict.fromkeys(platforms))
    text = source if with_source else None
    try:
        with progress(path.name) as report:
            export_fmu(
                compilation,
                path,
                version=int(version),
                kind=kind,
                platforms=machines,
                parameters=chosen.parameters,
                start=chosen.start,
                source=text,
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
