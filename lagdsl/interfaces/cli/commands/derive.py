"""`lag derive FILE`: the derivation on paper."""

from __future__ import annotations

from pathlib import Path

import click

from lagdsl.interfaces.api.derivation import ENDINGS, Derivation, Form
from lagdsl.interfaces.cli.command import Command
from lagdsl.interfaces.cli.groups import PATH
from lagdsl.interfaces.cli.model_file import ModelFile, flat_or_leave, takes_model
from lagdsl.interfaces.cli.options import takes_settings
from lagdsl.interfaces.cli.output import Forms, form_of, require_writable, write_text
from lagdsl.interfaces.cli.progress import progress


@click.command("derive", cls=Command)
@takes_model
@takes_settings
@click.option(
    "--to",
    "form",
    type=Forms(["text", "markdown", "latex", "html", "json"], ENDINGS),
    help="Form of the result; default: that of the file name, else text.",
)
@click.option("--units", is_flag=True, help="Show the units of all symbols and equations.")
@click.option("-o", "--output", type=PATH, help="Write to this .txt, .md, .tex, .html or .json instead.")
def command(
    model_file: ModelFile, assignments: tuple[str, ...], form: Form | None, units: bool, output: Path | None
) -> None:
    """Show the derivation of the equations of motion of FILE, step by step."""
    chosen = form_of(output, form, ENDINGS, "text")
    require_writable(output)
    flat = flat_or_leave(model_file, assignments)

    from lagdsl.derivation.textbook.recipe import recipe

    with progress("derive"):
        text = Derivation(recipe(flat)).to(chosen, units=units)
    write_text(text, output)
