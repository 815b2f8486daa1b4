"""Family 05: physics."""

from lagdsl.diagnostics.catalog.row import Row

ROWS: dict[str, Row] = {}
