"""Contents of a class, expanded: product of the collecting half of the floor."""

from __future__ import annotations

from dataclasses import field

from lagdsl.foundation.record import mutable_record, record
from lagdsl.language.semantics.scope.scope import FunctionSymbol, Instance, Scope, Symbol
from lagdsl.language.syntax import nodes


@record()
class Placed:
    """An item with the scope it stands in, the instance it belongs to and, if it has a label, its symbol.

    The scope of an inherited item is not that of the instance, but shares its entries.
    """

    node: nodes.Item
    scope: Scope
    instance: Instance
    symbol: Symbol | None = None


@mutable_record()
class Contents:
    """All of a model, depth first in the order of the text: what a component holds stands where it is declared.

    Loops and structural `if` are expanded, parts that are not there left out. `instances` are the components without
    the model itself. `kinematics` and `closure` hold nodes.Equation, `connects` nodes.Connect.
    """

    symbols: list[Symbol] = field(default_factory=list)
    items: list[Placed] = field(default_factory=list)
    initial: list[Placed] = field(default_factory=list)
    kinematics: list[Placed] = field(default_factory=list)
    closure: list[Placed] = field(default_factory=list)
    connects: list[Placed] = field(default_factory=list)
    instances: list[Instance] = field(default_factory=list)
    functions: list[FunctionSymbol] = field(default_factory=list)
    annotations: list[Placed] = field(default_factory=list)
