"""Family 09: export, engines and files."""

from lagdsl.diagnostics.catalog.row import Row

ROWS: dict[str, Row] = {}
