"""`lag explain NAME`: the manual page of a diagnostic, of a word of the language or of a component."""

from __future__ import annotations

import re
from collections.abc import Sequence

import click

from lagdsl.foundation.diagnostics.explain import UnknownCode, explain
from lagdsl.foundation.diagnostics.suggest import nearest

_LEAST = 4  # letters of a word that many texts do not hold by chance


@click.command("explain")
@click.argument("name")
def command(name: str) -> None:
    """Show the manual page of NAME: a diagnostic (E0401), a word of the language (force, reaction) or a component of
    the library (DCMotor).

    The page of a diagnostic has its meaning, a model that causes it and the repaired model. The page of a word has its
    syntax, its meaning, an example and its place in the reference. The page of a component holds its parameters, ports,
    defaults and equations; of several components with one name there is a list.
    """
    asked = name.strip()
    page = _diagnostic(asked) if re.fullmatch(r"(\w+\[)?[A-Za-z]\d+\]?", asked) else _named(asked)
    click.echo(page.rstrip("\n"))


def _diagnostic(code: str) -> str:
    try:
        return explain(code)
    except UnknownCode as error:
        raise click.UsageError(str(error)) from error


def _named(name: str) -> str:
    """Pages of everything that is called so; else the classes that deal with it."""
    from lagdsl.language.manual.component_page import component_page
    from lagdsl.language.manual.library import UnknownClass, class_names, classes_on, matching
    from lagdsl.language.manual.word_page import word_page, words

    of_language = word_page(name)
    pages = [] if of_language is None else [of_language]
    try:
        found = matching(name)
    except UnknownClass:
        found = ()
    if len(found) == 1:
        pages.append(component_page(found[0]))
    elif found:
        pages.append(_listed(f"# {name}\n\nSeveral classes have this name; give the full name of one:\n", found))
    if pages:
        return "\n".join(pages)
    about = classes_on(name) if len(name) >= _LEAST else ()
    if about:
        return _listed(f"# {name}\n\nNo word of the language and no class has this name. Classes about it:\n", about)
    similar = nearest(name, sorted({*words(), *(full.rpartition(".")[2] for full in class_names())}))
    hint = "" if similar is None else f"; did you mean `{similar}`?"
    raise click.UsageError(f"there is no statement, function, type or class `{name}`{hint}")


def _listed(head: str, names: Sequence[str]) -> str:
    from lagdsl.language.manual.library import library_class

    return "\n".join([head, *(f"- `{name}`: {library_class(name).node.doc or ''}".rstrip(": ") for name in names), ""])
