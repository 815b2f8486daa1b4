"""Family 03: events and contacts."""

from lagdsl.diagnostics.catalog.row import Row, error

ROWS: dict[str, Row] = {
    "E0370": error(
        "`{name}` is discrete and gets its values in `when` clauses",
        label="a binding would hold all the time",
        help="write `{name}(start = ...)` for its first value; without `discrete` the binding is fine",
    ),
    "E0371": error(
        "this condition is not located, so the clause cannot act on it",
        label="a relation taken as it stands",
        help="leave out `noEvent`: the condition of a `when` is located",
    ),
    "E0372": error(
        "this never changes, so it never becomes true",
        label="constant during the motion",
        help="for an `if` around equations, decide with `if` in an expression; for the start, write `when initial()`",
    ),
    "E0373": error(
        "a `when` gives values to discrete variables, and `{name}` is none",
        label="not discrete",
        help="declare it `discrete`; a state or a rate is set by `reinit(x, value)`",
    ),
    "E0374": error(
        "`reinit` sets a state or a rate, and `{name}` is neither",
        label="cannot jump",
        help="write `reinit(der(q), ...)` for the rate of a coordinate; positions are continuous",
    ),
    "E0375": error(
        "`{name}` has a meaning at events only",
        label="outside of `when`",
        help="use it in the condition or in the equations of a `when` clause",
    ),
    "E0376": error(
        "`{name}` has no value before an event that could differ",
        label="not a discrete variable, a state, a coordinate or a rate",
        help="name the variable itself",
    ),
    "E0377": error(
        "`{name}` is an action, not a value",
        label="no value",
        help="write it as an equation in a `when` clause: `{name}(...);`",
    ),
    "E0378": error(
        "this cannot stand in a `when` clause",
        label="not an equation of an event",
        help="there are `v = ...` of a discrete variable, `reinit`, `impact`, `terminate`, `assert`, `for` and `if`",
    ),
    "E0379": error(
        "`{operator}` between quantities that move holds at single instants only",
        label="no event can be located here",
        help="write `<=` or `>=`, or an interval: `abs(a - b) < tolerance`",
    ),
    "E0380": error(
        "impacts of a compliant contact are not counted",
        label="`{name}` has no impacts",
        help="use `closed({name})`, or a contact `with restitution`",
    ),
    "E0381": error(
        "a contact is a gap that cannot be negative",
        label="not of the form `gap >= 0`",
        help="write `contact name: gap >= 0 with restitution = 0.5;`",
    ),
    "E0382": error(
        "a gap depends on positions only",
        label="depends on more, or on nothing that moves",
        help="name a distance made of coordinates, points and frames",
    ),
    "E0383": error(
        "a contact has either a restitution or a compliance",
        label="needs one law",
        help="write `with restitution = 0.5`, optionally `v_stick`, `t_eps`; or `with compliance = k`, optionally "
        "`damping`, `exponent`",
    ),
    "E0384": error(
        "no `when` gives `{name}` a value",
        label="discrete, and never changed",
        help="assign it in a `when` clause, or declare it as a parameter",
    ),
    "E0385": error(
        "circular at one event: {path}",
        label="needed for itself",
        help="read the value before the event: `pre({name})`",
    ),
    "E0386": error(
        "`{name}` has no value {where}",
        label="given here only",
        help="every branch of an `if` around equations, the `else` too, gives values to the same quantities",
    ),
}
