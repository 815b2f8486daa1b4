"""`lag import FILE`: the model of a robot or of a flexible body, from files of other tools."""

from __future__ import annotations

from pathlib import Path

import click
from click.core import ParameterSource

from lagdsl.exchange.flexible.endings import is_body_file
from lagdsl.foundation.diagnostics import Sink
from lagdsl.interfaces.cli.command import Command
from lagdsl.interfaces.cli.groups import PATH, group
from lagdsl.interfaces.cli.imports import BodyOptions, RobotOptions
from lagdsl.interfaces.cli.model_file import Format, leave_with_errors, takes_format, tell
from lagdsl.interfaces.cli.output import require_ending, require_writable, write_text


@click.command("import", cls=Command)
@click.argument("file", type=PATH)
@click.option("-o", "--output", type=PATH, help="Write to this file; default: standard output.")
@group(
    "robot",
    RobotOptions,
    click.option(
        "--limits",
        type=click.Choice(["range", "contact", "none"]),
        default="range",
        show_default=True,
        help="Robots. Limits of joints: min and max of the coordinate, contacts, nothing.",
    ),
    click.option(
        "--actuators",
        type=click.Choice(["file", "all", "none"]),
        default="file",
        show_default=True,
        help="Robots. Inputs: those of the file (of every joint if it declares none), of all joints, none.",
    ),
    click.option(
        "--floating", is_flag=True, help="Robots. Let the base move freely; default: it is fixed to the world."
    ),
    click.option(
        "--lenient", is_flag=True, help="Robots. Replace or leave out what the language cannot express, with warnings."
    ),
    click.option(
        "--root",
        type=PATH,
        metavar="DIR",
        help="Robots. One more folder that names in FILE may lead to; default: its package, or the folder around.",
    ),
)
@group(
    "body",
    BodyOptions,
    click.option(
        "--interface",
        "interfaces",
        multiple=True,
        metavar="NAME",
        help="Bodies. A set of nodes, or the number of a node: the first is frame_a, the second frame_b.",
    ),
    click.option(
        "--length-unit",
        type=click.Choice(["m", "cm", "mm"]),
        help="Bodies. The unit of length of FILE; forces are in N, times in s.",
    ),
    click.option(
        "--modes",
        type=click.IntRange(0, 200),
        default=6,
        show_default=True,
        help="Bodies. Modes with all interfaces held, beside their static shapes.",
    ),
    click.option(
        "--matrices",
        type=PATH,
        metavar="NAME",
        help="Bodies. The common name of the files of matrices; default: that of FILE.",
    ),
)
@takes_format
@click.pass_context
def command(
    context: click.Context, file: Path, output: Path | None, robot: RobotOptions, body: BodyOptions, style: Format
) -> None:
    """Write the model of the robot or of the flexible body in FILE.

    Robots: a URDF or an MJCF file. Bodies: an input deck of CalculiX or Abaqus, FILE.inp, with its matrices beside it,
    or Standard Input Data, FILE.SID_FEM. If the language cannot express a line of FILE, a message names the line and
    nothing is written.
    """
    require_ending(output, "models are", ".lag")
    require_writable(output)
    is_body = is_body_file(file)
    _refuse(context, RobotOptions if is_body else BodyOptions, file)
    sink = Sink()
    if is_body:
        text = body.text(file, sink, None if output is None else output.stem)
    else:
        text = robot.text(file, sink, Path() if output is None else output.parent)
    if text is None:
        leave_with_errors(sink.diagnostics, style)
    tell(sink.diagnostics, style)
    write_text(text, output)


def _refuse(context: click.Context, other: type, file: Path) -> None:
    """An option of the other kind of file is wrong usage."""
    for name in other.__annotations__:
        if context.get_parameter_source(name) is ParameterSource.COMMANDLINE:
            kind = "a robot" if other is RobotOptions else "a flexible body"
            option = "--interface" if name == "interfaces" else f"--{name.replace('_', '-')}"
            raise click.UsageError(f"{option} is for {kind}, and {file.name} is none")
