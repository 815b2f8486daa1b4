"""`lag derive FILE`: the derivation on paper."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import click

from lagdsl.cli.model_file import Format, flat_or_leave, takes_model
from lagdsl.cli.output import require_writable, write_text

Form = Literal["text", "markdown", "latex", "html"]


@click.command("derive")
@takes_model
@click.option(
    "--to", "form", type=click.Choice(["text", "markdown", "latex", "html"]), default="text", show_default=True
)
@click.option("-o", "--output", type=click.Path(path_type=Path), help="Write to this file instead.")
def command(file: Path, model: str | None, style: Format, form: Form, output: Path | None) -> None:
    """Show the derivation of the equations of motion of FILE, step by step."""
    require_writable(output)
    flat = flat_or_leave(file, model, style)

    from lagdsl.report.derivation import render
    from lagdsl.textbook.recipe import recipe

    write_text(render(recipe(flat), form), output)
