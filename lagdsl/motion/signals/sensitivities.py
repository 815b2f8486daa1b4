"""Derivatives of a motion by parameters, start values and inputs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from lagdsl.foundation.diagnostics.unknown import unknown_among
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record


@record(kw_only=True)
class Sensitivities:
    """`table` (rows, names, places) holds derivatives, at a fixed time, by the quantities `names`, in SI units; `times`
    (events, names) those of the times of events. `places` are those of the columns by all their names; None: it does
    not change."""

    names: tuple[str, ...]
    table: Floats
    times: Floats
    places: Mapping[str, int | None]

    def derivative(self, of: str, by: str) -> Floats:
        """(rows,): of the column `of` by the quantity `by`. Raises UnknownName."""
        return self._of(of)[:, self._number(by)]

    def jacobian(self, of: Sequence[str]) -> Floats:
        """(columns, rows, names): of several columns by all quantities. Raises UnknownName."""
        return np.array([self._of(name) for name in of]).reshape(len(of), *self.table.shape[:2])

    def _of(self, column: str) -> Floats:
        """(rows, names)"""
        if column not in self.places:
            raise unknown_among("column", column, list(self.places))
        place = self.places[column]
        return np.zeros(self.table.shape[:2]) if place is None else self.table[:, :, place]

    def _number(self, by: str) -> int:
        if by not in self.names:
            raise unknown_among("quantity of `tangents`", by, list(self.names))
        return self.names.index(by)
