"""`column("file.csv", "name")`: an array of the numbers in a column of a file, in the unit of its header.

The file lies beside the text, as files of meshes do: a text that comes from elsewhere reads nothing outside its folder.
"""

from __future__ import annotations

from pathlib import Path

from lagdsl.foundation.diagnostics.suggest import did_you_mean, listing
from lagdsl.foundation.source import SourceFile
from lagdsl.foundation.units.parse import UnknownUnit, parse_unit
from lagdsl.language.flat import expression as flat
from lagdsl.language.semantics.operators.application import Application
from lagdsl.language.semantics.scope.limits import array_fits
from lagdsl.language.semantics.scope.naming import kind_of
from lagdsl.language.semantics.scope.values import POISON, Array, Text, Value


def column(call: Application) -> Value:
    """Values in SI units with the dimension of the unit; without one they are bare numbers, as in a text. E0820 for a
    file that cannot be read, E0821 and E0829 for a column that is not there once, E0878 for what is no unit, E0823 and
    E0824 for cells."""
    file_name, name = (item.value for item in call.arguments)
    for item, expected in zip(
        call.arguments, ('the name of a file, as "motor.csv"', "the name of a column"), strict=True
    ):
        if not isinstance(item.value, Text):
            call.ctx.sink.report("E0312", item.node.span, expected=expected, found=kind_of(item.value))
    if not isinstance(file_name, Text) or not isinstance(name, Text):
        return POISON
    file = _file(call, file_name.value)
    return POISON if file is None else _column(call, file, name.value)


def _file(call: Application, name: str) -> SourceFile | None:
    from lagdsl.foundation.columns.csv_file import read_file  # few models have a file
    from lagdsl.foundation.meshes.files import named_in
    from lagdsl.foundation.meshes.triangles import MeshError

    span = call.arguments[0].node.span
    try:
        return read_file(named_in(name, span.file.folder), call.ctx.sink, span=span)
    except MeshError as fault:
        way = "put the file into the folder of this text, or correct its name"
        call.ctx.sink.report("E0820", span, file=name, reason=str(fault), help=way)
        return None


def _column(call: Application, file: SourceFile, name: str) -> Value:
    from lagdsl.foundation.columns.csv_file import head_of, in_si_units, line_span, numbered_rows, numbers_of_column

    sink, span = call.ctx.sink, call.arguments[1].node.span
    header, *rows = numbered_rows(file) or [(0, [])]
    heads = [head_of(cell) for cell in header[1]]
    names = [each for each, _ in heads]
    if names.count(name) != 1:
        way = did_you_mean(name, names, f"there are {listing(name, names)}") if names else "the file is empty"
        if name in names:
            sink.report("E0829", span, file=Path(file.name).name, column=name)
        else:
            sink.report("E0821", span, file=Path(file.name).name, column=f"`{name}`", help=way)
        return POISON
    index = names.index(name)
    unit = heads[index][1]
    try:
        definition = parse_unit(unit) if unit else None
    except UnknownUnit as fault:
        sink.report("E0878", line_span(file, header[0]), name=name, unit=unit, why=str(fault))
        return POISON
    if not array_fits(call.ctx, call.node.span, (len(rows),)):
        return POISON
    before = len(sink.diagnostics)
    numbers = numbers_of_column(file, rows, names, index, sink)
    if len(sink.diagnostics) > before:
        return POISON
    if not numbers:
        sink.report("E0827", span, file=Path(file.name).name, found=0)
        return POISON
    dimension = None if definition is None else call.ctx.conventions.dimension(definition.dimension)
    elements = tuple(flat.Number(value) for value in in_si_units(numbers, unit))
    return Array(elements, (len(elements),), dimension)
