"""Templates: what the text of a loop comes to in one turn, for all turns that differ in the elements it names.

`potential 1/2*k*(x[i] - x[i-1])^2;` is the same operations in every turn, on other elements of `x`. A template lists
them once. A turn then needs the indices of its elements, and that these are of the types of the first ones.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field
from typing import TypeAlias

from lagdsl.foundation.record import mutable_record, record
from lagdsl.language.flat import expression as flat
from lagdsl.language.semantics.scope.alike import Type
from lagdsl.language.semantics.scope.scope import Scope, Symbol
from lagdsl.language.semantics.scope.values import Scalar
from lagdsl.language.syntax import nodes

Number: TypeAlias = Callable[[Mapping[str, float]], float]
"""A number that follows from the indices of the loops, by name."""

# Texts that lead elsewhere in more turns than this are elaborated in each.
_MOST = 4


@mutable_record()
class Step:
    """A part of the text. `made` is its expression in the `turn` that was elaborated last; None: in every one."""

    made: flat.FlatExpression
    turn: Scope | None


@mutable_record()
class Operation(Step):
    """`make` on what one or two parts come to."""

    make: Callable[..., flat.FlatExpression]
    left: Step
    right: Step | None


@mutable_record()
class Element(Step):
    """An element of a declared array, by the number and the extent of each subscript."""

    symbol: Symbol
    subscripts: tuple[tuple[Number, int], ...]
    node: nodes.Index
    type: Type


@mutable_record()
class Named(Step):
    """A name that is looked up in each turn: a member of an element of an array of components."""

    node: nodes.Expression
    type: Type


@record()
class Part:
    """A text in one turn: its step, its value, and the conditions under which it came to that, by the number of their
    spelling: a function of the indices, and if it was true."""

    step: Step
    value: Scalar
    conditions: Mapping[int, tuple[Number, bool]]


@record()
class Template:
    """`steps` in the order in which they are made, and the `whole` text. It holds in turns in which each condition is
    as true as it was."""

    steps: tuple[Step, ...]
    whole: Part


@record()
class _Place:
    """The place of a text: in a class, in loops over these names, in a `mode` of elaboration."""

    owner: Scope
    names: tuple[str, ...]
    mode: tuple[bool, ...]


@mutable_record()
class _Found:
    """Templates of a text, which is kept so that no other one gets its identity."""

    node: nodes.Expression
    place: _Place
    templates: list[Template] = field(default_factory=list)
    tries: int = -1  # a text that is met once needs no template


@mutable_record()
class Templates:
    """Templates met last, by identity of the text. `scope` is the turn that is elaborated; `parts` are those known
    in the turn `of`, by the number of the spelling."""

    scope: Scope | None = None
    parts: dict[int, Part] = field(default_factory=dict)
    of: Scope | None = None
    _found: dict[int, _Found] = field(default_factory=dict)
    _indices: tuple[Scope | None, dict[str, float] | None] = (None, None)

    def indices(self, scope: Scope) -> dict[str, float] | None:
        """The indices of the loops around by name, innermost first; None where another value has a local name."""
        if self._indices[0] is not scope:
            self._indices = scope, _indices(scope)
        return self._indices[1]

    def known(self, node: nodes.Expression, scope: Scope, mode: tuple[bool, ...]) -> list[Template]:
        found = self._found.get(id(node))
        return found.templates if found is not None and _stands(found.place, scope, mode) else []

    def are_wanted(self, node: nodes.Expression, scope: Scope, mode: tuple[bool, ...]) -> bool:
        """True where a text that no template fits is met again."""
        found = self._found.get(id(node))
        if found is None or not _stands(found.place, scope, mode):
            place = _Place(scope.owner, tuple(self.indices(scope) or ()), mode)
            found = self._found[id(node)] = _Found(node, place)
        found.tries += 1
        return 0 < found.tries <= _MOST

    def keep(self, node: nodes.Expression, template: Template) -> None:
        self._found[id(node)].templates.append(template)


def _indices(scope: Scope) -> dict[str, float] | None:
    found: dict[str, float] = {}
    for each in scope.chain():
        if each.kind != "local":
            return found
        for name, entry in each.entries.items():
            if not isinstance(entry, Scalar) or not isinstance(entry.expression, flat.Number):
                return None
            found.setdefault(name, entry.expression.value)
    return None


def _stands(place: _Place, scope: Scope, mode: tuple[bool, ...]) -> bool:
    owner = scope
    names: list[str] = []
    while owner.kind == "local" and owner.parent is not None:
        names += owner.entries
        owner = owner.parent
    return owner is place.owner and mode == place.mode and tuple(dict.fromkeys(names)) == place.names
