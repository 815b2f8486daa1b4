"""Family 01: reading the text."""

from lagdsl.diagnostics.catalog.row import Row

ROWS: dict[str, Row] = {}
