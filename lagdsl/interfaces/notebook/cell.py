"""Cells `%%lag name`: a model text that becomes a Model."""

from __future__ import annotations

import shlex
from keyword import iskeyword
from typing import Any

from lagdsl.foundation.diagnostics import CompilationFailed, Severity, Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.interfaces.api.compile import compile_file
from lagdsl.interfaces.api.model import Model
from lagdsl.interfaces.notebook.told import Told

_USAGE = "a model cell begins with %%lag NAME, or %%lag NAME MODEL where the cell has several models"


def lag(shell: Any, line: str, cell: str) -> None:
    """%%lag NAME [MODEL]: compile the cell, and name the model NAME. Warnings and errors are drawn at their places.

    A cell with errors fails and names nothing.
    """
    from IPython.core.error import UsageError
    from IPython.display import display

    try:
        words = shlex.split(line)
    except ValueError:  # a quote that is not closed
        words = []
    if not 1 <= len(words) <= 2 or not words[0].isidentifier():
        raise UsageError(_USAGE)
    if iskeyword(words[0]):
        raise UsageError(
            f"`{words[0]}` is a word of Python, by which no cell could reach the model: choose another name"
        )
    sink = Sink()
    try:
        model = compile_file(SourceFile(words[0], cell), sink, model=words[1] if len(words) == 2 else None)
    except CompilationFailed as failure:
        shell.user_ns.pop(words[0], None)  # an older model of that name is not this text
        raise failure from None
    shell.user_ns[words[0]] = model
    told = tuple(each for each in model.diagnostics if each.severity is not Severity.NOTE)
    display(Told(told, _summary(words[0], model)))


def _summary(name: str, model: Model) -> str:
    """`pendulum: Pendulum, 1 coordinate, 3 parameters`."""
    parts = [
        (len(model.coordinates), "coordinate"),
        (len(model.states), "state"),
        (len(model.inputs), "input"),
        (len(model.parameters), "parameter"),
    ]
    counted = ", ".join(f"{count} {noun}{'' if count == 1 else 's'}" for count, noun in parts if count)
    return f"{name}: {model.name}, {counted}"
