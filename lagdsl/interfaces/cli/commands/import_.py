"""`lag import FILE`: the model of a robot, from its URDF or MJCF file."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import click

from lagdsl.foundation.diagnostics import Sink
from lagdsl.interfaces.cli.command import Command
from lagdsl.interfaces.cli.groups import PATH
from lagdsl.interfaces.cli.model_file import Format, leave_with_errors, takes_format, tell
from lagdsl.interfaces.cli.output import require_ending, require_writable, write_text


@click.command("import", cls=Command)
@click.argument("file", type=PATH)
@click.option("-o", "--output", type=PATH, help="Write to this file; default: standard output.")
@click.option(
    "--limits",
    type=click.Choice(["range", "contact", "none"]),
    default="range",
    show_default=True,
    help="Limits of joints: min and max of the coordinate, contacts, nothing.",
)
@click.option(
    "--actuators",
    type=click.Choice(["file", "all", "none"]),
    default="file",
    show_default=True,
    help="Inputs: those of the file (of every joint if it declares none), of all joints, none.",
)
@click.option("--floating", is_flag=True, help="Let the base move freely; default: it is fixed to the world.")
@click.option("--lenient", is_flag=True, help="Replace or leave out what the language cannot express, with warnings.")
@click.option(
    "--root",
    type=PATH,
    metavar="DIR",
    help="One more folder that names in FILE may lead to; default: its package, or the parent of its folder.",
)
@takes_format
def command(
    file: Path,
    output: Path | None,
    limits: Literal["range", "contact", "none"],
    actuators: Literal["file", "all", "none"],
    floating: bool,
    lenient: bool,
    root: Path | None,
    style: Format,
) -> None:
    """Write the model of the robot in FILE, a URDF or an MJCF file.

    If the language cannot express a line of FILE, a message names the line and nothing is written.
    """
    from lagdsl.exchange.robots.plan import Style
    from lagdsl.exchange.robots.read import robot_text

    require_ending(output, "models are", ".lag")
    require_writable(output)
    sink = Sink()
    choices = Style(limits=limits, actuators=actuators, floating=floating)
    text = robot_text(file, choices, sink, Path() if output is None else output.parent, lenient, root)
    if text is None:
        leave_with_errors(sink.diagnostics, style)
    tell(sink.diagnostics, style)
    write_text(text, output)
