"""Family 08: initial values and run time."""

from lagdsl.diagnostics.catalog.row import Row, error, note, warning

ROWS: dict[str, Row] = {
    "E0801": error(
        "the initial state is over-determined by {excess}",
        "one condition too many",
        "drop `fixed = true` here; `start` then acts as a guess",
    ),
    "E0802": error(
        "initial position not found: the residual {residual} stalls at `{name}`",
        "does not hold from this start",
        "give starts closer to the configuration you mean",
    ),
    "E0803": error(
        "initial rates not found: the residual {residual} stalls at `{name}`",
        "no rates satisfy this together with the fixed ones",
        "drop a `fixed = true` of a rate",
    ),
    "E0804": error(
        "event iteration did not converge at t = {time} s; still changing: {text}",
        label="still changing",
        help="two clauses may trigger each other, or a force may reverse at every crossing: smooth it, `tanh(v/v0)`",
    ),
    "E0805": error(
        "there is no start value `{name}`",
        None,
        "start values are coordinates, states and rates: {known}",
    ),
    "E0806": error(
        "mass matrix became singular at t = {time} s: `{name}` has no inertia there",
        "the accelerations are not determined",
        "choose coordinates that are regular in this position, e.g. `Quaternion` instead of three angles",
    ),
    "E0807": error(
        "invariant `{name}` violated at t = {time} s: drift {drift} exceeds {limit}",
        "claimed to be constant",
        "if the claim is right, simulate with a smaller tolerance",
    ),
    "E0808": error(
        "the motion cannot be continued at t = {time} s: `{name}` is not a number",
        None,
        "a division by zero, a root or a logarithm leaves its domain here; a branch of an `if` is used a little beyond "
        "its border: write `sqrt(max(x, 0))`",
    ),
    "E0809": error(
        "the motion cannot be continued at t = {time} s: steps became smaller than {step} s because of `{name}`",
        None,
        "the motion is unbounded or not smooth there; a relation in a force or a tolerance below round-off does this",
    ),
    "E0810": error(
        "assertion failed at t = {time} s: {text}",
        "became false",
    ),
    "E0811": error(
        "constraint `{name}` was lost at t = {time} s: residual {residual}",
        "no configuration nearby satisfies it",
        "the mechanism reached a position in which it cannot move on; limit the motion or check the lengths",
    ),
    "E0812": error(
        "the simulation reached its limit of {steps} steps at t = {time} s",
        None,
        "use a larger tolerance, another solver, or allow more steps",
    ),
    "E0813": error(
        "at t = {time} s the norm of `{element}` is zero, where its derivative does not exist",
        "a vector of length zero has no direction",
        "use a smooth form, e.g. sqrt(v*v + eps^2)",
    ),
    "W0814": warning(
        "the start value of `{name}` does not fit the constraints: {start} was moved to {value}",
        "explicit start",
        "mark what must stay with `fixed = true`",
    ),
    "E0815": error(
        "the initial equations are not satisfied: residual {residual}",
        "stalls here",
        "give starts closer to the state you mean, or free a coordinate that is fixed",
    ),
    "E0816": error(
        "at the start `{name}` is not a number",
        None,
        "a division by zero, a root or a logarithm of a negative number: check the start values and parameters",
    ),
    "E0817": error(
        "the table of input `{name}` covers {first} s to {last} s, the simulation {start} s to {stop} s",
        None,
        "add rows to the table or change the stop time",
    ),
    "E0818": error(
        "input `{name}` is given as a function and the model needs its derivative `{derivative}`",
        "moves a frame or a constraint",
        "give functions for its derivatives too, or give the input as a table",
    ),
    "E0819": error(
        "there is no input `{name}`",
        None,
        "inputs of the model: {known}",
    ),
    "E0820": error(
        "cannot read the table `{file}`: {reason}",
    ),
    "E0821": error(
        "the table `{file}` has no column {column}",
        "names of the columns",
        "the first line names the columns: `time` and inputs of the model",
    ),
    "E0822": error(
        "time runs backward in line {line} of the table",
        "earlier than the line before",
        "sort the rows by time; two equal times are a jump",
    ),
    "E0823": error(
        "`{text}` is not a number",
        "line {line}, column `{column}`",
    ),
    "E0824": error(
        "line {line} of the table has {found} cells instead of {expected}",
        None,
        "separate cells by commas, numbers have a decimal point",
    ),
    "E0825": error(
        "{what} needs the package `{package}`",
        None,
        "install it with: pip install 'lagdsl[table]'",
    ),
    "E0826": error(
        "cannot write `{file}`: {reason}",
    ),
    "E0827": error(
        "the table `{file}` has {found} row(s) of numbers",
        None,
        "a table needs two rows at least",
    ),
    "E0828": error(
        "results are not written in the form of `{file}`",
        None,
        "end the name in `.csv` or `.parquet`",
    ),
    "E0829": error(
        "the table `{file}` has two columns `{column}`",
        "names of the columns",
        "each input has one column",
    ),
    "E0830": error(
        "the motion cannot be continued at t = {time} s: near a singular position, where `{name}` loses its effect, "
        "the equations do not decide on its branch",
        "without effect there",
        "a smaller tolerance may lead across; lengths or start values that avoid the position decide it",
    ),
    "E0831": error(
        "with these parameters and starts {now} rows of the constraints are independent instead of {before}: "
        "`{name}` does not follow from the others any more",
        "redundant with the values of the model",
        "the degrees of freedom would be {freedom}; write the values into the model, so that it is compiled with them",
    ),
    "E0832": error(
        "`reinit` gives `{text}` two values at t = {time} s",
        label="one of them",
        help="use the branches of one `when ... elsewhen`, or conditions that exclude each other",
    ),
    "E0833": error(
        "events of {text} accumulate at t = {time} s, and the simulation cannot continue",
        label="the time between events goes to zero",
        help="use a `contact`, which comes to rest, a smooth force, or a condition with a margin",
    ),
    "E0834": error(
        "the gap of {text} is negative at the start",
        label="starts inside",
        help="give starts at which every gap is positive or zero",
    ),
    "E0835": error(
        "{text} becomes active at t = {time} s, but the current position violates it",
        label="would need a jump of positions",
        help="activate it where it is satisfied, or write it for rates: `der(...) = ...`",
    ),
    "E0837": error(
        "no initial equation decides the free parameter `{name}`",
        "the start holds with other values as well",
        "add an `initial equation` that depends on it, fix what else could give way, or give it a value",
    ),
    "E0838": error(
        "the start asks for `{name}` = {value}, which is beyond its {which} of {limit}",
        "found with the start",
        "check the initial equations, or give a guess on the side you mean",
    ),
    "E0845": error(
        "input `{name}` takes whole numbers, not {value}",
        "whole numbers only",
        "give whole numbers; in a table each holds until the next row",
    ),
    "E0846": error(
        "the table of input `{name}` has two time derivatives, and the model needs `{derivative}`",
        None,
        "give `{derivative}` as a table of its own",
    ),
    "E0847": error(
        "the table of input `{name}` jumps at t = {time} s, and the model needs its time derivative",
        None,
        "give a row between, so that the value changes over some time",
    ),
    "N0848": note(
        "the table of input `{name}` is read as monotone cubics; `{derivative}` jumps at its rows",
        None,
        "give `{derivative}` and the derivative before it as tables too, if they are known",
    ),
    "E0849": error(
        "input `{derivative}` is given, but `{name}` is not, whose time derivative it is",
        None,
        "give `{name}` too, from the same signal",
    ),
}
