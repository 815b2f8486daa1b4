"""Every diagnostic by its code: one module per family, first letter = severity, next two digits = family."""

from lagdsl.foundation.diagnostics.catalog import (
    analysis,
    assembly,
    constraints,
    dimensions,
    events,
    export,
    initial,
    names,
    physics,
    robots,
    runtime,
    settings,
    syntax,
    values,
)
from lagdsl.foundation.diagnostics.catalog.row import Row

ROWS: dict[str, Row] = {
    **syntax.ROWS,
    **names.ROWS,
    **values.ROWS,
    **events.ROWS,
    **dimensions.ROWS,
    **physics.ROWS,
    **constraints.ROWS,
    **assembly.ROWS,
    **initial.ROWS,
    **analysis.ROWS,
    **export.ROWS,
    **runtime.ROWS,
    **settings.ROWS,
    **robots.ROWS,
}

__all__ = ["ROWS", "Row"]
