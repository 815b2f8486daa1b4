"""Family 02: names."""

from lagdsl.diagnostics.catalog.row import Row

ROWS: dict[str, Row] = {}
