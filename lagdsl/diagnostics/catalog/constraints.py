"""Family 06: constraints."""

from lagdsl.diagnostics.catalog.row import Row

ROWS: dict[str, Row] = {}
