"""Family 04: dimensions and units."""

from lagdsl.diagnostics.catalog.row import Row

ROWS: dict[str, Row] = {}
