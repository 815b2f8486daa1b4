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
    """`values` are those of the scope that was elaborated last, by number of the spelling: turns of loops and instances
    of classes are elaborated one after the other, each in a scope of its own."""

    values: dict[tuple[int, bool], Value] = field(default_factory=dict)
    _scope: Scope | None = None
    _mode: tuple[bool, bool] = (False, False)
    _spellings: dict[_Spelling, int] = field(default_factory=dict)
    # A node is kept with its number, so that its identity is not given to another one.
    _numbers: dict[int, tuple[int | None, nodes.Node]] = field(default_factory=dict)

    def of(self, scope: Scope, current: Current) -> dict[tuple[int, bool], Value]:
        """The values of `scope`, by number of the spelling and by the literals that adopt a unit; they grow."""
        mode = (current.quiet, current.in_clause)
        if scope is not self._scope or mode != self._mode:
            self._scope, self._mode, self.values = scope, mode, {}
        return self.values

    def number(self, node: nodes.Node) -> int | None:
        """The same for all nodes of one spelling; None for loops and names of arguments, which have their own scope."""
        found = self._numbers.get(id(node))
        if found is None:
            spelling = self._spelling(node)
            number = None if spelling is None else self._spellings.setdefault(spelling, len(self._spellings))
            found = self._numbers[id(node)] = number, node
        return found[0]

    def _spelling(self, node: nodes.Node) -> _Spelling | None:
        match node:
            case nodes.Reference():
                return ("name", node.name)
            case nodes.Binary():
                return self._compound(node.operator, node.left, node.right)
            case nodes.Number():
                return ("number", node.text)
            case nodes.Quantity():
                return ("quantity", node.number, node.unit)
            case nodes.Parenthesized():
                return self._compound("()", node.inner)
            case nodes.Unary():
                return self._compound(f"{node.operator}.", node.operand)
            case nodes.Call():
                return self._compound("call", node.function, *node.arguments)
            case nodes.Index():
                return self._compound("[]", node.target, *node.subscripts)
            case nodes.Member():
                return self._compound(f".{node.name}", node.target)
            case nodes.Conditional():
                parts = [part for branch in node.branches for part in (branch.condition, branch.value)]
                return self._compound("if", *parts, node.otherwise)
            case _:
                return None

    def _compound(self, word: str, *parts: nodes.Node) -> _Spelling | None:
        numbers = tuple(self.number(part) for part in parts)
        return None if None in numbers else (word, *numbers)
