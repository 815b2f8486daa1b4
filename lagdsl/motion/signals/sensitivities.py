"""Derivatives of a motion by parameters, start values and inputs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from lagdsl.foundation.diagnostics.unknown import unknown_among
from lagdsl.foundation.numerics.rank import Floats
from lagdsl.foundation.record import record


@record(kw_only=True)
class Sensitivities:
    """`table` (rows, names, columns) holds derivatives of the columns, at a fixed time, by the quantities `names`, in
    SI units; `times` (events, names) those of the times of events. `places` are the columns by all their names."""

    names: tuple[str, ...]
    table: Floats
    times: Floats
    places: Mapping[str, int]

    def derivative(self, of: str, by: str) -> Floats:
        """(rows,): of the column `of` by the quantity `by`. Raises UnknownName."""
        if of not in self.places:
            raise unknown_among("column", of, list(self.places))
        return self.table[:, self._number(by), self.places[of]]

    def jacobian(self, of: Sequence[str]) -> Floats:
        """(columns, rows, names): of several columns by all quantities. Raises UnknownName."""
        return np.stack([np.stack([self.derivative(name, by) for by in self.names], axis=-1) for name in of])

    def _number(self, by: str) -> int:
        if by not in self.names:
            raise unknown_among("quantity of `tangents`", by, list(self.names))
        return self.names.index(by)
