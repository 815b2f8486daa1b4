"""Units of the symbols and equations of a derivation, from the declared dimensions and Lagrange's equations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sympy import Symbol

from lagdsl.derivation.textbook.reading import STANDARD_GRAVITY
from lagdsl.derivation.textbook.recipe import ConstraintRow, Derivation
from lagdsl.derivation.textbook.symbols import Symbols
from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import DIMENSIONLESS, ENERGY, TIME
from lagdsl.foundation.units.naming import rate_text, unit_text
from lagdsl.language.flat.model import Definition, FlatModel
from lagdsl.language.flat.quantity import Quantity


@dataclass(frozen=True)
class Units:
    """Units as texts of the language: `N.m`, `rad/s2`; `1` for a number."""

    flat: FlatModel
    symbols: Symbols

    def of_symbols(self, derivation: Derivation) -> dict[Symbol, str]:
        """Coordinates with their rates, parameters, inputs, states, definitions, multipliers and the time."""
        table = self.symbols
        found: dict[Symbol, str] = {}
        for q, qd, qdd, item in zip(table.q, table.qd, table.qdd, self.flat.coordinates, strict=True):
            rate = rate_text(item.dimension, item.unit)
            found |= {q: item.unit, qd: rate, qdd: rate_text(item.dimension / TIME, rate)}
        independent = [item for item in self.flat.parameters if not item.structural]
        for symbols, items in ((table.p, independent), (table.z, self.flat.states), (table.u, self.flat.inputs)):
            found |= {symbol: item.unit for symbol, item in zip(symbols, items, strict=True)}
        named = {item.name: item for item in self.flat.named if isinstance(item, Definition)}
        for symbol, _ in (*derivation.dependent_parameters, *derivation.definitions):
            own = named[symbol.name]
            rate = rate_text(own.dimension, own.unit)
            found |= {symbol: own.unit, Symbol(f"der({symbol.name})"): rate}
            found[Symbol(f"der(der({symbol.name}))")] = rate_text(own.dimension / TIME, rate)
        found |= {row.multiplier: self.multiplier(row) for row in derivation.constraints if row.restricts}
        return {table.time: "s", STANDARD_GRAVITY: "m/s2", **found}

    def plain(self, unit: str) -> str:
        """A unit that is the same in every model."""
        return unit

    def force(self, j: int) -> str:
        """Of the generalized force of coordinate j: a moment for an angle."""
        own = self.flat.coordinates[j].dimension
        return "N.m" if own == DIMENSIONLESS else unit_text(ENERGY / own)

    def momentum(self, j: int) -> str:
        own = self.flat.coordinates[j].dimension
        return "N.m.s" if own == DIMENSIONLESS else unit_text(ENERGY * TIME / own)

    def acceleration(self, j: int) -> str:
        item = self.flat.coordinates[j]
        return rate_text(item.dimension / TIME, rate_text(item.dimension, item.unit))

    def mass(self, i: int, j: int) -> str:
        """Of an entry of the matrix of the accelerations."""
        first, second = (self.flat.coordinates[k].dimension for k in (i, j))
        return unit_text(ENERGY * TIME * TIME / (first * second))

    def per_coordinate(self, dimension: Dimension, j: int) -> str:
        """Of a derivative by coordinate j."""
        return unit_text(dimension / self.flat.coordinates[j].dimension)

    def row(self, row: ConstraintRow, rates: int = 0) -> str:
        """Of a constraint, differentiated `rates` times by the time."""
        return unit_text(self._dimension(row) / TIME**rates)

    def multiplier(self, row: ConstraintRow) -> str:
        """A multiplier times a change of its row is a work, of a row of velocity level a power."""
        own = self._dimension(row)
        return unit_text(ENERGY / own if row.level == "position" else ENERGY / TIME / own)

    def quantity(self, name: str, rates: int = 0) -> str | None:
        """Of an output or state of that name."""
        items: Mapping[str, Quantity] = {item.name: item for item in (*self.flat.outputs, *self.flat.states)}
        item = items.get(name)
        if item is None:
            return None
        return rate_text(item.dimension, item.unit) if rates else item.unit

    def _dimension(self, row: ConstraintRow) -> Dimension:
        return next(each.dimension for each in self.flat.constraints if row.name in each.rows)
