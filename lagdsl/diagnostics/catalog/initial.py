"""Family 08: initial values and run time."""

from lagdsl.diagnostics.catalog.row import Row

ROWS: dict[str, Row] = {}
