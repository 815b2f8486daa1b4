"""Every diagnostic by its code: one module per family, first letter = severity, next two digits = family."""

from lagdsl.foundation.diagnostics.catalog import (
    analysis,
    assembly,
    constraints,
    dimensions,
    events,
    export,
    starts_and_runs,
    names,
    physics,
    robots,
    engines,
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
    **starts_and_runs.ROWS,
    **analysis.ROWS,
    **export.ROWS,
    **engines.ROWS,
    **settings.ROWS,
    **robots.ROWS,
}

__all__ = ["ROWS", "Row"]
