"""`lag flat FILE`: the model after expansion, before mechanics."""

from __future__ import annotations

from pathlib import Path

import click

from lagdsl.interfaces.cli.command import Command
from lagdsl.interfaces.cli.groups import PATH
from lagdsl.interfaces.cli.model_file import ModelFile, flat_or_leave, takes_model
from lagdsl.interfaces.cli.options import takes_settings
from lagdsl.interfaces.cli.output import require_ending, require_writable, write_text
from lagdsl.language.flat.text import flat_text


@click.command("flat", cls=Command)
@takes_model
@takes_settings
@click.option("-o", "--output", type=PATH, help="Write to this file instead.")
def command(model_file: ModelFile, assignments: tuple[str, ...], output: Path | None) -> None:
    """Show the flat model of FILE: the lists q, L, D, Q, constraints, then states, definitions, outputs."""
    require_ending(output, "the flat model is text; it is", ".txt", ".flat", ".log")
    require_writable(output)
    flat = flat_or_leave(model_file, assignments)
    write_text(flat_text(flat), output)
