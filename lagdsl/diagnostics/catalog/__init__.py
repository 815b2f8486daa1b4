"""Every diagnostic by its code: one module per family, first letter = severity, next two digits = family."""

from lagdsl.diagnostics.catalog import constraints, dimensions, initial, names, physics, runtime, syntax, values
from lagdsl.diagnostics.catalog.row import Row

ROWS: dict[str, Row] = {
    **syntax.ROWS,
    **names.ROWS,
    **values.ROWS,
    **dimensions.ROWS,
    **physics.ROWS,
    **constraints.ROWS,
    **initial.ROWS,
    **runtime.ROWS,
}

__all__ = ["ROWS", "Row"]
