"""Family 08, values by name: what users assign to parameters, starts and inputs."""

from lagdsl.diagnostics.catalog.row import Row, error, note

ROWS: dict[str, Row] = {
    "N0871": note(
        "`{what}` has no unit: it is {reading}",
        None,
        "write {ways}",
    ),
    "N0872": note(
        "the steps of `{what}` do not meet {given}: the last of {count} values is {last}",
        None,
        "end the range at {last}, or write linspace(first, last, count) unit",
    ),
    "N0873": note(
        "`{what}` means first:step:last, {count} values",
        None,
        "for {number} values from the first number to the second write `{other}`",
    ),
    "E0874": error(
        "no {what} `{name}`; {hint}",
        None,
        "the names stand in model.parameters, model.coordinates, model.states, model.inputs, model.frames and "
        "model.points",
    ),
    "N0875": note(
        "no value is given for {names}: {zero}",
        "an input without a default",
        "give one: --input '{first}={example}', a table of values over time, or a default in the model",
    ),
    "N0876": note(
        "the linearization keeps constant what changes only at events: {held}",
        "changes at instants, constant between them",
        "{advice}",
    ),
    "E0878": error(
        "the column `{name}` of the table has the unit `{unit}`: {why}",
        "names of the columns",
        "write the unit in brackets, as in `tau [N.m]`, or leave it out for SI units",
    ),
    "N0877": note(
        "`{old}` is the old form of `{new}`",
        None,
        "write `{new}`; {why}",
    ),
}
