"""Family 08, values by name: what users assign to parameters, starts and inputs."""

from lagdsl.foundation.diagnostics.catalog.row import Row, error, note

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
    "E0890": error(
        "the session is at t = {time} s, and time does not go back to {asked} s",
        None,
        "save the state before: `state = run.save()`, then `run.restore(state)` goes back to it",
    ),
    "E0891": error(
        "these bytes cannot be restored: {why}",
        None,
        "{way}",
    ),
    "E0892": error(
        "the session has ended at t = {time} s: {why}",
        None,
        "`run.reset()` begins again, `run.restore(state)` goes back to a saved state",
    ),
    "E0893": error(
        "the inputs of a step do not fit: {why}",
        None,
        "{way}",
    ),
    "E0894": error(
        "the engine `{engine}` has no sessions",
        None,
        'compile the model for another engine: engine="auto", "tape" or "c"',
    ),
    "E0895": error(
        "this session keeps no motion",
        None,
        "make it with record=True, which is the default of `model.session`",
    ),
    "E0896": error(
        "{what} must be {expected}, not {given}",
        None,
        'give seconds, or a text with a unit such as "2 ms"',
    ),
    "E0897": error(
        "no page can repeat this motion, as its inputs were set on the way",
        None,
        "`motion.plot()` draws it; `model.show()` opens the page of the model",
    ),
}
