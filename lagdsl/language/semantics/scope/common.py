"""Common subexpressions of a text: `th[i-1]`, which stands in five energies of an element, has one value in a turn.

Two texts of a scope that are spelled alike mean the same. So the second one is the value of the first, with the same
node in the flat model: later passes remember what they know of a node by its identity.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field
from typing import Any, TypeAlias

from lagdsl.foundation.record import mutable_record
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import Value
from lagdsl.language.syntax import nodes

_Form: TypeAlias = tuple[tuple[str, ...], tuple[nodes.Node, ...]]

# Words and parts of a node by its class. Loops are not among them, which have a scope of their own, nor what is rare.
_FORMS: dict[type[nodes.Node], Callable[[Any], _Form]] = {
    nodes.Reference: lambda node: ((node.name,), ()),
    nodes.Number: lambda node: ((node.text,), ()),
    nodes.Quantity: lambda node: ((node.number, node.unit), ()),
    nodes.Binary: lambda node: ((node.operator,), (node.left, node.right)),
    nodes.Unary: lambda node: ((node.operator,), (node.operand,)),
    nodes.Parenthesized: lambda node: ((), (node.inner,)),
    nodes.Call: lambda node: ((), (node.function, *node.arguments)),
    nodes.Index: lambda node: ((), (node.target, *node.subscripts)),
    nodes.Member: lambda node: ((node.name,), (node.target,)),
    nodes.Branch: lambda node: ((), (node.condition, node.value)),
    nodes.Conditional: lambda node: ((), (*node.branches, node.otherwise)),
}


@mutable_record()
class Common:
    """Values by number of the spelling, for the scope that was elaborated last and those around it: turns of loops and
    instances of classes are elaborated one after the other, each in a scope of its own."""

    _scope: Scope | None = None
    _mode: tuple[bool, ...] = ()
    _values: dict[int, dict[tuple[int, bool], Value]] = field(default_factory=dict)
    _spellings: dict[tuple[object, ...], int] = field(default_factory=dict)
    _names: list[frozenset[str]] = field(default_factory=list)
    # A node is kept with its number, so that its identity is not given to another one.
    _numbers: dict[int, tuple[int | None, nodes.Node]] = field(default_factory=dict)

    def of(self, scope: Scope, mode: tuple[bool, ...], number: int) -> dict[tuple[int, bool], Value]:
        """The values, by number of the spelling and by the literals that adopt a unit, of the outermost scope in which
        the text of this number means the same as in `scope`: what does not name the index is one in all turns. In
        another `mode` texts have other values."""
        if scope is not self._scope or mode != self._mode:
            before = self._values if mode == self._mode else {}
            self._scope, self._mode = scope, mode
            self._values = {id(each): before.get(id(each), {}) for each in scope.chain()}
        names = self._names[number]
        while scope.kind == "local" and scope.parent is not None and names.isdisjoint(scope.entries):
            scope = scope.parent
        return self._values[id(scope)]

    def names(self, number: int) -> frozenset[str]:
        """The names in the texts of this number."""
        return self._names[number]

    def number(self, node: nodes.Node) -> int | None:
        """The same for all nodes of one spelling; None for what has none."""
        found = self._numbers.get(id(node))
        if found is None:
            found = self._numbers[id(node)] = self._numbered(node), node
        return found[0]

    def _numbered(self, node: nodes.Node) -> int | None:
        form = _FORMS.get(type(node))
        if form is None:
            return None
        words, parts = form(node)
        numbers = [number for part in parts if (number := self.number(part)) is not None]
        if len(numbers) < len(parts):
            return None
        number = self._spellings.setdefault((type(node), *words, *numbers), len(self._spellings))
        if number == len(self._names):
            own = words if isinstance(node, nodes.Reference) else ()
            self._names.append(frozenset(own).union(*(self._names[part] for part in numbers)))
        return number
