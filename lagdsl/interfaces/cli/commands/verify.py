"""`lag verify FILE`: everything that can be computed in two ways, compared."""

from __future__ import annotations

from pathlib import Path

import click

from lagdsl.foundation.diagnostics import Sink
from lagdsl.interfaces.cli.compile_model import compile_or_leave
from lagdsl.interfaces.cli.model_file import ModelFile, read_or_leave, takes_model
from lagdsl.interfaces.cli.output import Forms, require_writable, write_text
from lagdsl.interfaces.cli.progress import progress
from lagdsl.interfaces.cli.status import FAILED_RUN


@click.command("verify")
@takes_model
@click.option(
    "--to",
    "form",
    type=Forms(["text", "json", "html"], {".txt": "text", ".htm": "html"}),
    help="Default: by the suffix of -o, else text.",
)
@click.option("-o", "--output", type=click.Path(path_type=Path), help="Write to this file instead.")
@click.option("--fmu", is_flag=True, help="Also export FMUs of both versions and kinds, and run them in FMPy.")
def command(model_file: ModelFile, form: str | None, output: Path | None, fmu: bool) -> None:
    """Compare both derivations, all engines, derivatives, power and the motion of the model in FILE.

    The exit status is 3 if a comparison fails.
    """
    require_writable(output)
    source = read_or_leave(model_file.file, model_file.style)
    compilation, _ = compile_or_leave(model_file, source, Sink(), {})

    from lagdsl.exchange.verify.certify import certify
    from lagdsl.exchange.verify.forms import FORMS

    suffix = "" if output is None else output.suffix.removeprefix(".")
    with progress("verify"):
        certificate = certify(compilation, source, fmu=fmu)
    write_text(FORMS[form or (suffix if suffix in FORMS else "text")](certificate), output)
    if not certificate.holds:
        click.get_current_context().exit(FAILED_RUN)
