"""`lag explain CODE`: the manual page of a diagnostic."""

from __future__ import annotations

import click

from lagdsl.diagnostics.explain import UnknownCode, explain


@click.command("explain")
@click.argument("code")
def command(code: str) -> None:
    """Show the manual page of diagnostic CODE: what it means, a model that draws it and the repaired one."""
    try:
        page = explain(code)
    except UnknownCode as error:
        raise click.UsageError(str(error)) from error
    click.echo(page.rstrip("\n"))
