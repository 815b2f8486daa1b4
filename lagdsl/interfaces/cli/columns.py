"""`--column`: names of the columns to keep."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import click

from lagdsl.language.flat.model import Definition, FlatModel
from lagdsl.language.settings.arrays import UnknownColumn, columns_among
from lagdsl.motion.simulate.table import called_heads


def columns_of(names: tuple[str, ...], models: Sequence[FlatModel]) -> tuple[str, ...] | None:
    """The columns to keep, all of which some model has; None for all columns. An array stands for its elements."""
    known = dict.fromkeys(name for flat in models for name in called_heads(flat) if name != "time")
    try:
        return tuple(columns_among(names, known)) or None
    except UnknownColumn as error:
        raise click.UsageError(f"{error}{way_to_column(error.args[1], models)}") from error


def way_to_column(name: str, models: Iterable[FlatModel]) -> str:
    """The end of a message: the way of a quantity of a model to a column; empty for other names."""
    for flat in models:
        if any(item.name == name for item in flat.named if isinstance(item, Definition)):
            return f"; `{name}` is a definition: write `output` before it"
        if any(item.name == name for item in (*flat.inputs, *flat.parameters)):
            kind = "an input" if any(item.name == name for item in flat.inputs) else "a parameter"
            return f"; `{name}` is {kind}: an output with its value is a column"
    return ""
