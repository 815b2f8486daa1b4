"""Family 03: events and contacts."""

from lagdsl.foundation.diagnostics.catalog.row import Row, error

ROWS: dict[str, Row] = {
    "E0370": error(
        "`{name}` is discrete and gets its values in `when` clauses",
        label="a binding would hold all the time",
        help="write `{name}(start = ...)` for its first value; without `discrete` the binding is fine",
    ),
    "E0371": error(
        "this condition is not located, so the clause cannot act on it",
        label="a relation without events",
        help="delete `noEvent`: a `when` needs a located condition",
    ),
    "E0372": error(
        "this never changes, so it never becomes true",
        label="constant during the motion",
        help="for an `if` around equations, decide with `if` in an expression; for the start, write `when initial()`",
    ),
    "E0373": error(
        "a `when` gives values to discrete variables, but `{name}` is not discrete",
        label="not discrete",
        help="declare it `discrete`; set a state or a rate with `reinit(x, value)`",
    ),
    "E0374": error(
        "`reinit` sets a state or a rate, but `{name}` is neither",
        label="cannot jump",
        help="write `reinit(der(q), ...)` for the rate of a coordinate; positions are continuous",
    ),
    "E0375": error(
        "`{name}` is defined at events only",
        label="outside of `when`",
        help="use it in the condition or in the equations of a `when` clause",
    ),
    "E0376": error(
        "`{name}` has no separate value before an event",
        label="not a discrete variable, a discrete input, a state, a coordinate or a rate",
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
        "a compliant contact does not count impacts",
        label="`{name}` has no impacts",
        help="use `closed({name})`, or a contact `with restitution`",
    ),
    "E0381": error(
        "a contact is a gap that cannot be negative",
        label="not of the form `gap >= 0`",
        help="write `contact name: gap >= 0 with restitution = 0.5;`",
    ),
    "E0382": error(
        "a contact is a gap that depends on positions only, or a rate that is linear in the rates of coordinates",
        label="depends on more, or on nothing that moves",
        help="name a distance made of coordinates, points and frames; for one way, a difference of rates",
    ),
    "E0383": error(
        "a contact has either a restitution or a compliance",
        label="needs one law",
        help="write `with restitution = 0.5`, optionally `v_stick`, `t_eps`; or `with compliance = k`, optionally "
        "`damping`, `exponent`",
    ),
    "E0384": error(
        "no `when` gives `{name}` a value",
        label="discrete, but never changes",
        help="assign it in a `when` clause, or declare it as a parameter",
    ),
    "E0385": error(
        "circular definition within one event: {path}",
        label="depends on itself",
        help="read the value before the event: `pre({name})`",
    ),
    "E0386": error(
        "`{name}` has no value {where}",
        label="given here only",
        help="give values to the same quantities in every branch of the `if`, including the `else`",
    ),
    "E0387": error(
        "a slip is a scalar that is linear in the rates of coordinates, or two of these in braces",
        label="{found}",
        help="name the rate along which friction acts: `der(s)`, `der(a) - der(b)`, `{{der(x), der(y)}}`",
    ),
    "E0388": error("{what} lacks {lacks}", label="{why}"),
    "E0389": error(
        "a contact of rates has no options",
        label="`{name}` is an option of gaps",
        help="write `contact name: rate >= 0;`: rates do not bounce",
    ),
    "E0390": error(
        "`delay` takes what is known with the state, and this reads accelerations, multipliers or reactions",
        label="found by solving the equations",
        help="delay a position, a rate, a state or an input, and compute from that: `m*delay(der(x), T)`",
    ),
    "E0391": error(
        "`{name}` stands in {what}, where the equations need its derivative",
        label="a delayed value has a value only",
        help="let a force or a state read it: `force -k*delay(x, T) at P;`; for its rate, delay the rate: "
        "`delay(der(x), T)`",
    ),
}
