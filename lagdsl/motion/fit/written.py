"""Values in the text of a model: the numbers of parameters and starts, and nothing else."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile
from lagdsl.foundation.units.parse import parse_unit
from lagdsl.foundation.units.written import literal_text
from lagdsl.language.flat.fixed_parameters import with_values
from lagdsl.language.flat.model import FlatModel, Parameter
from lagdsl.language.flat.text import flat_text
from lagdsl.language.settings.arrays import without_subscripts
from lagdsl.language.settings.target import Target, value_of
from lagdsl.language.syntax import nodes
from lagdsl.motion.pipeline import flatten_unit, parse_file

_DIGITS = 10


@record()
class _Edit:
    """`text` in place of the characters from `start` to `end`."""

    start: int
    end: int
    text: str


class _NoPlace(ValueError):  # noqa: N818 named after what it says
    """The text has no place for a value."""


def written(source: SourceFile, flat: FlatModel, values: Sequence[tuple[Target, float]], sink: Sink) -> str | None:
    """The text of `source` with these values, in SI units, of `flat`, which is its model; ten digits, in the units that
    stand there. E1116, and None, for one that has no place in this file, as that of an imported class."""
    unit = parse_file(source, Sink())
    owner = None if unit is None else _class(unit.items, flat.name.rpartition(".")[2])
    if unit is None or owner is None:
        sink.report("E1116", None, name=flat.name, reason="its class is not in this text")
        return None
    text = source.text
    edits: list[_Edit] = []
    read: dict[str, dict[str, float]] = {"parameter": {}, "start": {}}
    for target, value in values:
        try:
            edit, number = _edit(unit, owner, target, value, edits)
        except _NoPlace as reason:
            sink.report("E1116", None, name=target.name, reason=reason)
            return None
        edits.append(edit)
        read[target.kind][target.key] = value_of(target, number).value
    for edit in sorted(edits, key=lambda each: (each.start, each.end), reverse=True):
        text = text[: edit.start] + edit.text + text[edit.end :]
    if not _says(SourceFile(source.name, text), flat, read["parameter"], read["start"]):
        names = ", ".join(target.name for target, _ in values)
        sink.report("E1116", None, name=names, reason="the text with the numbers would be another model")
        return None
    return text


def _says(file: SourceFile, flat: FlatModel, parameters: dict[str, float], start: dict[str, float]) -> bool:
    """True if the text is `flat` with these values, and nothing else."""
    sink = Sink()
    unit = parse_file(file, sink)
    found = None if unit is None else flatten_unit(unit, sink, model=flat.name)
    return found is not None and flat_text(found) == flat_text(with_values(flat, parameters, start))


def _class(items: Sequence[nodes.Item], name: str) -> nodes.Class | None:
    for item in items:
        if isinstance(item, nodes.Class):
            found = item if item.name == name else _class(item.items, name)
            if found is not None:
                return found
    return None


def _items(owner: nodes.Class) -> Iterator[nodes.Item]:
    yield from owner.items
    for section in owner.sections:
        yield from section.items


def _edit(
    unit: nodes.Unit, owner: nodes.Class, target: Target, value: float, edits: Sequence[_Edit]
) -> tuple[_Edit, str]:
    """The change that gives `target` its value, and the number with its unit. Raises _NoPlace."""
    first, *path = _path(target)
    declarator = _declarator(unit, owner, first)
    if declarator is None:
        raise _NoPlace(f"`{first}` is not declared in this text")
    if not path:
        node, place = declarator.value, None
    else:
        node, place = _modifier(declarator, path)
    if node is None:
        number = _number(value, target, None)
        if place is None:
            raise _NoPlace(f"`{first}` has no value in this text")
        if any(edit.start == place.start for edit in edits):
            raise _NoPlace(f"write the modifier `{'.'.join(path)} = {number}` of `{first}` by hand")
        return _Edit(place.start, place.end, place.text.format(number)), number
    element = _element(node, target)
    number = _number(value, target, element)
    return _Edit(element.span.start, element.span.end, number), number


def _path(target: Target) -> list[str]:
    """Names from the component of the model to the attribute."""
    if target.kind == "start":
        name = target.key[4:-1] if target.rate else target.key
        return [*without_subscripts(name).split("."), *(["der", "start"] if target.rate else ["start"])]
    guess = isinstance(target.quantity, Parameter) and (target.quantity.free or target.quantity.estimated)
    return [*without_subscripts(target.key).split("."), *(["start"] if guess else [])]


def _declarator(unit: nodes.Unit, owner: nodes.Class, name: str) -> nodes.Declarator | None:
    """In the class, or in a class of the same text that it extends."""
    for item in _items(owner):
        if isinstance(item, nodes.Component | nodes.Coordinate):
            for each in item.declarators:
                if each.name == name:
                    return each
        if isinstance(item, nodes.Extends):
            base = _class(unit.items, item.base.parts[-1])
            found = None if base is None or base is owner else _declarator(unit, base, name)
            if found is not None:
                return found
    return None


def _modifier(declarator: nodes.Declarator, path: Sequence[str]) -> tuple[nodes.Expression | None, _Edit | None]:
    """The value at `path` among the modifiers; where there is none, the place for it, with `{}` for the number."""
    modifiers, rest = declarator.modifiers, list(path)
    last = declarator.subscripts[-1].span.end if declarator.subscripts else declarator.name_span.end
    while True:
        found = next((m for m in modifiers if isinstance(m, nodes.Modifier) and m.name.parts == (rest[0],)), None)
        if found is None:
            break
        if len(rest) == 1:
            if found.value is None:
                raise _NoPlace(f"`{'.'.join(path)}` of `{declarator.name}` is no number in this text")
            return found.value, None
        modifiers, rest, last = found.modifiers, rest[1:], found.name.span.end
    text = f"{rest[-1]} = {{}}"
    for name in reversed(rest[:-1]):
        text = f"{name}({text})"
    if modifiers:
        end = modifiers[-1].span.end
        return None, _Edit(end, end, f", {text}")
    if declarator.subscripts:
        raise _NoPlace(f"write the modifier of `{declarator.name}` by hand")
    return None, _Edit(last, last, f"({text})")


def _element(node: nodes.Expression, target: Target) -> nodes.Expression:
    """The number within an array: of `I[2]` the second. Raises _NoPlace for what is not written out."""
    name = target.key[4:-1] if target.rate else target.key
    for piece in name.split("[")[1:]:
        for place in piece.partition("]")[0].split(","):
            if not isinstance(node, nodes.Array) or len(node.elements) < int(place):
                raise _NoPlace("its elements are not written out in this text")
            node = node.elements[int(place) - 1]
    return node


def _number(value: float, target: Target, node: nodes.Expression | None) -> str:
    """In the unit that stands in the text, else in that of summaries."""
    if isinstance(node, nodes.Unary):
        node = node.operand
    if isinstance(node, nodes.Quantity):
        definition = parse_unit(node.unit)
        factor, offset = float(definition.factor), float(definition.offset)
        return f"{_digits((value - offset) / factor)} {node.unit}"
    if isinstance(node, nodes.Number) or not target.unit:
        return _digits(value)
    shown = target.display
    return literal_text(_digits(shown(value)), shown.unit)


def _digits(value: float) -> str:
    return f"{value:.{_DIGITS}g}"
