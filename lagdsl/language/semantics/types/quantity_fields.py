"""Fields that every flat quantity takes from its declaration."""

from __future__ import annotations

from lagdsl.foundation.units.dimension import DIMENSIONLESS
from lagdsl.foundation.units.naming import unit_text
from lagdsl.language.flat.quantity import Base, QuantityFields
from lagdsl.language.semantics.scope.naming import element_name
from lagdsl.language.semantics.scope.scope import Indices, Symbol, TypeInfo
from lagdsl.language.semantics.scope.values import AnyDimension


def quantity_fields(
    symbol: Symbol, indices: Indices, sign: str | None, inferred: AnyDimension = None
) -> QuantityFields:
    """Fields of one element. `sign` is the `symbol` attribute, `inferred` the dimension of a plain `Real`'s binding."""
    info = symbol.info
    assert info is not None
    dimension = info.dimension if info.dimension is not None else inferred if inferred is not None else DIMENSIONLESS
    return QuantityFields(
        spans=(symbol.span, *symbol.scope.spans),
        name=element_name(symbol.name, indices),
        dimension=dimension,
        unit=info.unit if info.dimension is not None else unit_text(dimension),
        display_unit=info.display_unit,
        doc=symbol.declarator.doc if symbol.declarator is not None else None,
        type_name=info.name,
        symbol=sign,
        base=_base(info),
        literals=info.literals,
        literal_docs=info.literal_docs,
        type_doc=info.doc,
        protected=_is_protected(symbol),
    )


def _is_protected(symbol: Symbol) -> bool:
    """True if it, or a component that it is part of, stands under `protected`."""
    name, instance = symbol.short, symbol.scope.owner.instance
    while instance is not None:
        if name in instance.protected:
            return True
        name = instance.name.rpartition(".")[2].partition("[")[0]
        instance = instance.around.owner.instance if instance.around is not None else None
    return False


def _base(info: TypeInfo) -> Base:
    """Types with literals are kinds of their own to the checks; to all others they are enumerations."""
    match info.base:
        case "Real" | "Integer" | "Boolean" | "String":
            return info.base
        case _:
            return "Enumeration"
