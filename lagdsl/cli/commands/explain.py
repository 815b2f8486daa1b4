"""`lag explain NAME`: the manual page of a diagnostic or of a component."""

from __future__ import annotations

import re

import click

from lagdsl.diagnostics.explain import UnknownCode, explain


@click.command("explain")
@click.argument("name")
def command(name: str) -> None:
    """Show the manual page of NAME, a diagnostic (E0401) or a component of the library (DCMotor).

    The page of a diagnostic has its meaning, a model that causes it and the repaired model. The page of a component
    holds its parameters, ports, defaults and equations.
    """
    page = _diagnostic(name) if re.fullmatch(r"(\w+\[)?[A-Za-z]\d+\]?", name.strip()) else _component(name.strip())
    click.echo(page.rstrip("\n"))


def _diagnostic(code: str) -> str:
    try:
        return explain(code)
    except UnknownCode as error:
        raise click.UsageError(str(error)) from error


def _component(name: str) -> str:
    from lagdsl.manual.component_page import component_page
    from lagdsl.manual.library import UnknownClass, matching

    try:
        found = matching(name)
    except UnknownClass as error:
        raise click.UsageError(str(error)) from error
    if len(found) > 1:
        raise click.UsageError(f"several classes are called `{name}`: {', '.join(found)}; give the full name")
    return component_page(found[0])
