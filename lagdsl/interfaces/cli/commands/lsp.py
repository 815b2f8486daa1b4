"""`lag lsp`: the language server for editors."""

from __future__ import annotations

import click

from lagdsl.interfaces.cli.command import Command
from lagdsl.interfaces.cli.status import USAGE


@click.command("lsp", cls=Command)
@click.option(
    "--stdio", is_flag=True, help="Use standard input and output, the only mode; some editors pass this option."
)
def command(stdio: bool) -> None:
    """Run the language server on standard input and output. Editors start this command."""
    try:
        import pygls  # noqa: F401 the extra may be absent
    except ImportError:
        click.echo("lag lsp needs pygls: pip install pygls", err=True)
        click.get_current_context().exit(USAGE)
    from lagdsl.interfaces.lsp.main import serve

    serve()
