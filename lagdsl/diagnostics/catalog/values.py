"""Family 03: values, types and variability."""

from lagdsl.diagnostics.catalog.row import Row

ROWS: dict[str, Row] = {}
