"""A call of a built-in function with its elaborated arguments."""

from __future__ import annotations

from dataclasses import dataclass

from lagdsl.semantics.arithmetic import Operand
from lagdsl.semantics.context import Context
from lagdsl.semantics.scope import Scope
from lagdsl.semantics.values import Array, Numeric, Scalar, Vector
from lagdsl.syntax import nodes


@dataclass(frozen=True, slots=True)
class Application:
    """A call with its elaborated arguments."""

    ctx: Context
    scope: Scope
    name: str
    node: nodes.Call
    arguments: tuple[Operand, ...]

    @property
    def numeric(self) -> tuple[Numeric, ...]:
        return tuple(item.value for item in self.arguments if isinstance(item.value, Scalar | Vector | Array))
