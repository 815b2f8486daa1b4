"""Family 07: how components are joined."""

from lagdsl.diagnostics.catalog.row import Row, note

ROWS: dict[str, Row] = {
    "N0701": note(
        "{count} of the {total} closure equations of {joint} are redundant and are left out of the solve",
        "this closes the loop {loop}",
    ),
}
