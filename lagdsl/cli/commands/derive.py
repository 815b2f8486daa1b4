"""`lag derive FILE`: the derivation on paper."""

from __future__ import annotations

from pathlib import Path
from typing import Literal, TypeAlias

import click

from lagdsl.cli.command import Command
from lagdsl.cli.model_file import Format, flat_or_leave, takes_model
from lagdsl.cli.options import PATH
from lagdsl.cli.output import form_of, require_writable, write_text

Form: TypeAlias = Literal["text", "markdown", "latex", "html"]
_ENDINGS: dict[str, Form] = {".txt": "text", ".md": "markdown", ".tex": "latex", ".html": "html", ".htm": "html"}


@click.command("derive", cls=Command)
@takes_model
@click.option(
    "--to",
    "form",
    type=click.Choice(["text", "markdown", "latex", "html"]),
    help="Form of the result; default: that of the file name, else text.",
)
@click.option("-o", "--output", type=PATH, help="Write to this .txt, .md, .tex or .html instead.")
def command(file: Path, model: str | None, style: Format, form: Form | None, output: Path | None) -> None:
    """Show the derivation of the equations of motion of FILE, step by step."""
    chosen = form_of(output, form, _ENDINGS, "text")
    require_writable(output)
    flat = flat_or_leave(file, model, style)

    from lagdsl.report.derivation import render
    from lagdsl.textbook.recipe import recipe

    write_text(render(recipe(flat), chosen), output)
