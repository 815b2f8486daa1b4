"""Common subexpressions of a text: `th[i-1]`, which stands in five energies of an element, has one value in a turn.

Two texts of a scope that are spelled alike mean the same. So the second one is the value of the first, with the same
node in the flat model: later passes remember what they know of a node by its identity.
"""

from __future__ import annotations

from dataclasses import field
from typing import TypeAlias

from lagdsl.foundation.record import mutable_record
from lagdsl.language.semantics.scope.current import Current
from lagdsl.language.semantics.scope.scope import Scope
from lagdsl.language.semantics.scope.values import Value
from lagdsl.language.syntax import nodes

_Spelling: TypeAlias = tuple[object, ...]


@mutable_record()
class Common:
    """Values by number of the spelling, for the scope that was elaborated last and those around it: turns of loops and
    instances of classes are elaborated one after the other, each in a scope of its own."""

    _scope: Scope | None = None
    _mode: tuple[bool, bool] = (False, False)
    _values: dict[int, dict[tuple[int, bool], Value]] = field(default_factory=dict)
    _spellings: dict[_Spelling, int] = field(default_factory=dict)
    _names: list[frozenset[str]] = field(default_factory=list)
    # A node is kept with its number, so that its identity is not given to another one.
    _numbers: dict[int, tuple[int | None, nodes.Node]] = field(default_factory=dict)

    def of(self, scope: Scope, current: Current, number: int) -> dict[tuple[int, bool], Value]:
        """The values, by number of the spelling and by the literals that adopt a unit, of the outermost scope in which
        the text of this number means the same as in `scope`: what does not name the index is one in all turns."""
        mode = (current.quiet, current.in_clause)
        if scope is not self._scope or mode != self._mode:
            before = self._values if mode == self._mode else {}
            self._scope, self._mode = scope, mode
            self._values = {id(each): before.get(id(each), {}) for each in scope.chain()}
        names = self._names[number]
        while scope.kind == "local" and scope.parent is not None and names.isdisjoint(scope.entries):
            scope = scope.parent
        return self._values[id(scope)]

    def number(self, node: nodes.Node) -> int | None:
        """The same for all nodes of one spelling; None for loops and names of arguments, which have their own scope."""
        found = self._numbers.get(id(node))
        if found is None:
            spelling = self._spelling(node)
            number = None if spelling is None else self._spellings.setdefault(spelling, len(self._spellings))
            if number == len(self._names):
                self._names.append(self._names_in(node))
            found = self._numbers[id(node)] = number, node
        return found[0]

    def _names_in(self, node: nodes.Node) -> frozenset[str]:
        """The names that a text of known spelling begins to read with."""
        if isinstance(node, nodes.Reference):
            return frozenset((node.name,))
        numbers = (self.number(part) for part in _parts(node))
        return frozenset().union(*(self._names[number] for number in numbers if number is not None))

    def _spelling(self, node: nodes.Node) -> _Spelling | None:
        match node:
            case nodes.Reference():
                return ("name", node.name)
            case nodes.Number():
                return ("number", node.text)
            case nodes.Quantity():
                return ("quantity", node.number, node.unit)
            case nodes.Binary() | nodes.Unary():
                word = node.operator
            case nodes.Member():
                word = f".{node.name}"
            case nodes.Parenthesized() | nodes.Call() | nodes.Index() | nodes.Conditional():
                word = ""
            case _:
                return None
        numbers = tuple(self.number(part) for part in _parts(node))
        return None if None in numbers else (type(node), word, *numbers)


def _parts(node: nodes.Node) -> tuple[nodes.Node, ...]:
    match node:
        case nodes.Binary():
            return (node.left, node.right)
        case nodes.Unary():
            return (node.operand,)
        case nodes.Parenthesized():
            return (node.inner,)
        case nodes.Call():
            return (node.function, *node.arguments)
        case nodes.Index():
            return (node.target, *node.subscripts)
        case nodes.Member():
            return (node.target,)
        case nodes.Conditional():
            parts = [part for branch in node.branches for part in (branch.condition, branch.value)]
            return (*parts, node.otherwise)
        case _:
            return ()
