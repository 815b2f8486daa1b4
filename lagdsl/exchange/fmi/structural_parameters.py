"""Structural parameters that are parameters of an FMU: those that stand in the equations as numbers and shape nothing.

The model is flattened once more with such a name as a parameter. If this is the same model but for the name in place of
the number, no size, no branch and no other number depends on it.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TypeVar

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.fixed_parameters import with_values
from lagdsl.language.flat.model import Coordinate, Definition, FlatModel, State
from lagdsl.language.flat.spans import place
from lagdsl.language.flat.traversal import postorder, records, substituted
from lagdsl.language.semantics.flatten import flatten
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.recursion import deep_recursion
from lagdsl.language.syntax.walk import descendants
from lagdsl.motion.pipeline import Compilation, compile_flat, parse_file

_Started = TypeVar("_Started", Coordinate, State)


def with_structural_parameters(compilation: Compilation, sink: Sink) -> Compilation:
    """`compilation` with those structural parameters as parameters that its model declares and that shape nothing. The
    other ones that it declares are told (N0928)."""
    flat = compilation.flat
    unit, names = _declared(flat)
    if unit is None:
        return compilation
    with deep_recursion():
        found = _Trials(unit, flat).found(names)
    changed = (compile_flat(found, Sink()) or compilation) if found is not flat else compilation
    left = [each for each in changed.flat.parameters if each.structural and _base(each.name) in names]
    if left:
        told = ", ".join(f"`{name}`" for name in dict.fromkeys(_base(each.name) for each in left))
        sink.report("N0928", place(left[0]), names=told, first=_base(left[0].name))
    return changed


def _declared(flat: FlatModel) -> tuple[nodes.Unit | None, list[str]]:
    """The file that declares structural parameters of the model itself, and their names, but for texts."""
    folded = [each for each in flat.parameters if each.structural and each.spans and "." not in each.name]
    for file in dict.fromkeys(each.spans[0].file for each in folded):
        unit = parse_file(file, Sink())
        names = _structural(unit, flat.name) if unit is not None else ()
        if names:
            return unit, [name for name in dict.fromkeys(_base(each.name) for each in folded) if name in names]
    return None, []


def _structural(unit: nodes.Unit, model: str) -> frozenset[str]:
    return frozenset(
        declarator.name
        for item in unit.items
        if isinstance(item, nodes.Class) and item.name == model
        for node in descendants(item)
        if isinstance(node, nodes.Component) and "structural" in node.prefixes and node.type_name.span.text != "String"
        for declarator in node.declarators
    )


def _base(name: str) -> str:
    """`A` of `A[1,2]`."""
    return name.partition("[")[0]


class _Trials:
    """A file and the flat model that was made from it, with other values of parameters and starts at most."""

    def __init__(self, unit: nodes.Unit, flat: FlatModel) -> None:
        self._unit, self._flat = unit, flat
        self._overrides: dict[str, float] = {}
        self._read: FlatModel | None = self._flatten(())
        if self._read is not None:
            numbers = {each.name: each.value for each in flat.parameters if each.structural}
            read = [each for each in self._read.parameters if each.structural]
            self._overrides = {e.name: numbers[e.name] for e in read if numbers.get(e.name, e.value) != e.value}
            self._read = self._flatten(()) if self._overrides else self._read

    def found(self, names: list[str]) -> FlatModel:
        """The model with as many of `names` as parameters as there can be."""
        if self._read is None or _as_given(self._read, self._flat) != self._flat:
            return self._flat
        tried = self._tried(names) if names else None
        if tried is None:
            single = [name for name in names if self._tried([name]) is not None]
            tried = self._tried(single) if single else None
        return self._flat if tried is None else self._like_the_given(tried)

    def _tried(self, names: list[str]) -> FlatModel | None:
        """The model as it is read with `names` as parameters; None if anything else changes."""
        assert self._read is not None
        other = self._flatten(names)
        if other is None:
            return None
        loose = {each.name for each in other.parameters if _base(each.name) in names}
        numbers = {each.name: fx.Number(each.value) for each in other.parameters if each.name in loose}
        same = replace(
            substituted(other, numbers),
            parameters=tuple(replace(e, structural=True) if e.name in loose else e for e in other.parameters),
        )
        kinds = {each.name: each.variability for each in self._read.named if isinstance(each, Definition)}
        named = (
            replace(each, variability=kinds.get(each.name, each.variability)) if isinstance(each, Definition) else each
            for each in same.named
        )
        same = replace(same, named=tuple(named))
        return other if same == self._read and not _in_exponents(other, loose) else None

    def _flatten(self, names: Iterable[str]) -> FlatModel | None:
        sink = Sink()
        given = self._overrides
        found = flatten(self._unit, sink, self._flat.name, lambda each, _: given.get(each.name), plain=names)
        return None if sink.has_errors else found

    def _like_the_given(self, tried: FlatModel) -> FlatModel:
        assert self._read is not None
        given = _as_given(tried, self._flat)
        return replace(
            given,
            coordinates=_started(self._read.coordinates, self._flat.coordinates, tried.coordinates),
            states=_started(self._read.states, self._flat.states, tried.states),
        )


def _as_given(read: FlatModel, given: FlatModel) -> FlatModel:
    """`read` with the values of parameters and the starts of `given`."""
    values = {each.name: each.value for each in given.parameters}
    return replace(with_values(read, values, {}), coordinates=given.coordinates, states=given.states)


def _started(
    read: tuple[_Started, ...], given: tuple[_Started, ...], tried: tuple[_Started, ...]
) -> tuple[_Started, ...]:
    """The values that were tried, or the given ones in place of another start than that of the text."""
    return tuple(new if old == own else own for old, own, new in zip(read, given, tried, strict=True))


def _in_exponents(flat: FlatModel, names: set[str]) -> bool:
    """True if the derivative of a power would have a logarithm of its base because of one of `names`."""
    exponents = [each.right for each in records(flat) if isinstance(each, fx.Binary) and each.operator == "^"]
    inside = (part for each in exponents for part in postorder(each))
    return any(isinstance(part, fx.Variable) and part.name in names for part in inside)
