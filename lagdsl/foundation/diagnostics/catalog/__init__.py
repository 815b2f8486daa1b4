"""Every diagnostic by its code: first letter = severity, next two digits = family.

A family has one module, but 03 has `values` and `events`, 08 `starts_and_runs`, `analysis` and `settings`, 09 `export`
and `engines`, which has E0911 to E0914."""

from lagdsl.foundation.diagnostics.catalog import (
    analysis,
    assembly,
    bodies,
    constraints,
    dimensions,
    engines,
    events,
    export,
    fits,
    names,
    physics,
    robots,
    settings,
    starts_and_runs,
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
    **fits.ROWS,
    **bodies.ROWS,
}

__all__ = ["ROWS", "Row"]
