"""Family 08: initial values and run time."""

from lagdsl.foundation.diagnostics.catalog.row import Row, error, note, warning

ROWS: dict[str, Row] = {
    "E0801": error(
        "the initial state is over-determined by {excess}",
        "one condition too many",
        "delete `fixed = true` here; `start` then acts as a guess",
    ),
    "E0802": error(
        "initial position not found: the residual {residual} stalls at `{name}`",
        "does not hold from this start",
        "give starts closer to the configuration you mean",
    ),
    "E0803": error(
        "initial rates not found: the residual {residual} stalls at `{name}`",
        "no rates satisfy this together with the fixed ones",
        "delete a `fixed = true` of a rate",
    ),
    "E0804": error(
        "event iteration did not converge at t = {time} s; still changing: {text}",
        label="still changing",
        help="two clauses may trigger each other, a force may reverse at every crossing (smooth it, `tanh(v/v0)`), "
        "a drive may lead through a contact, or a gap may have two sides (write one contact for each side)",
    ),
    "E0805": error(
        "there is no start value `{name}`",
        None,
        "start values are coordinates, states and rates: {known}",
    ),
    "E0806": error(
        "the mass matrix is singular at t = {time} s: `{name}` has no inertia there",
        "the equations do not determine the accelerations",
        "choose coordinates that are regular in this position, e.g. `Quaternion` instead of three angles",
    ),
    "E0807": error(
        "invariant `{name}` is violated at t = {time} s: drift {drift} exceeds {limit}",
        "declared constant",
        "if it is constant, simulate with a smaller tolerance",
    ),
    "E0808": error(
        "the simulation cannot continue at t = {time} s: `{name}` is not a number",
        None,
        "look for a division by zero, or a root or logarithm outside its domain; the solver evaluates a branch of an "
        "`if` slightly beyond its border: write `sqrt(max(x, 0))`",
    ),
    "E0809": error(
        "the simulation cannot continue at t = {time} s: the step size falls below {step} s because of `{name}`",
        None,
        "the motion is unbounded or not smooth there; a relation in a force, a tolerance below round-off, or inertias "
        "that nearly cancel (lessen what couples them) can be the cause",
    ),
    "E0810": error(
        "assertion failed at t = {time} s: {text}",
        "is false",
        "check the state and the parameters, or the condition of the assertion",
    ),
    "E0811": error(
        "the simulation cannot satisfy constraint `{name}` at t = {time} s: residual {residual}",
        "no configuration nearby satisfies it",
        "the mechanism reaches a position where it cannot move further; limit the motion or check the lengths",
    ),
    "E0812": error(
        "the simulation reaches its limit of {steps} steps at t = {time} s",
        None,
        "use a larger tolerance, another solver, or allow more steps",
    ),
    "E0813": error(
        "at t = {time} s the norm of `{element}` is zero, where its derivative does not exist",
        "a vector of length zero has no direction",
        "use a smooth form, e.g. sqrt(v*v + eps^2)",
    ),
    "W0814": warning(
        "the start value of `{name}` violates the constraints: initialization changes {start} to {value}",
        "explicit start",
        "write `fixed = true` at the start values that must not change",
    ),
    "E0815": error(
        "the initial equations are not satisfied: residual {residual}",
        "largest residual",
        "give starts closer to the state you mean, or free a coordinate that is fixed",
    ),
    "E0816": error(
        "at the start `{name}` is not a number",
        None,
        "a division by zero, or a root or logarithm of a negative number: check the start values and parameters",
    ),
    "E0817": error(
        "the table of input `{name}` covers {first} s to {last} s, the simulation {start} s to {stop} s",
        None,
        "add rows to the table or change the stop time",
    ),
    "E0818": error(
        "input `{name}` is given as a function, but the model needs its derivative `{derivative}`",
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
        None,
        "check the name of the file",
    ),
    "E0821": error(
        "the table `{file}` has no column {column}",
        "names of the columns",
        "the first line names the columns: `time` and inputs of the model",
    ),
    "E0822": error(
        "time decreases in line {line} of the table",
        "earlier than the line before",
        "sort the rows by time; two equal times define a jump",
    ),
    "E0823": error(
        "`{text}` is not a number",
        "line {line}, column `{column}`",
        "write numbers with a decimal point, without units",
    ),
    "E0824": error(
        "line {line} of the table has {found} cells instead of {expected}",
        None,
        "separate cells by commas, and write numbers with a decimal point",
    ),
    "E0825": error(
        "{what} needs the package `{package}`",
        None,
        "install it: `pip install {package}`",
    ),
    "E0826": error(
        "cannot write `{file}`: {reason}",
        None,
        "check the folder and its permissions",
    ),
    "E0827": error(
        "the table `{file}` has {found} row(s) of numbers",
        None,
        "give at least two rows",
    ),
    "E0828": error(
        "lagdsl cannot write results in the format of `{file}`",
        None,
        "end the name in `.csv` or `.parquet`",
    ),
    "E0829": error(
        "the table `{file}` has two columns `{column}`",
        "names of the columns",
        "each input has one column",
    ),
    "E0830": error(
        "the simulation cannot continue at t = {time} s: near a singular position, where `{name}` loses its effect, "
        "the equations do not determine the branch of the motion",
        "without effect there",
        "try a smaller tolerance, or change lengths or start values so that the motion avoids the position",
    ),
    "E0831": error(
        "with these parameters and starts the constraints have {now} independent rows instead of {before}: "
        "`{name}` no longer follows from the others",
        "redundant with the values of the model",
        "write the values into the model and compile it again; it then has {freedom} degrees of freedom",
    ),
    "E0832": error(
        "`reinit` gives `{text}` two values at t = {time} s",
        label="one of them",
        help="use the branches of one `when ... elsewhen`, or conditions that exclude each other",
    ),
    "E0833": error(
        "events of {text} accumulate at t = {time} s, and the simulation cannot continue",
        label="the time between events goes to zero",
        help="use a `contact`, which comes to rest, one contact for each side of a gap with a corner, a smooth force, "
        "or a margin",
    ),
    "E0834": error(
        "the gap of {text} is negative at t = {time} s",
        label="inside",
        help="give starts at which every gap is positive or zero; write the side of a step as a contact of its own",
    ),
    "E0835": error(
        "{text} becomes active or jumps at t = {time} s, but the current position violates it",
        label="positions cannot jump",
        help="activate it where it is satisfied, let its branches meet, or write it for rates: `der(...) = ...`",
    ),
    "E0836": error(
        "the position of a mass jumps with {text} at t = {time} s",
        label="positions cannot jump",
        help="write branches that meet, `if x < a then 0 m else x - a`, a steep ramp, `limit(k*(x - a), 0 m, h)`, "
        "or a rate, `der(p) = (goal - p)/tau`, in place of a value that is set",
    ),
    "E0837": error(
        "no initial equation determines the free parameter `{name}`",
        "other values satisfy the initial equations, too",
        "add an `initial equation` that depends on it, fix start values that can change instead, or give it a value",
    ),
    "E0838": error(
        "the initial equations require `{name}` = {value}, beyond its {which} of {limit}",
        "solved for at initialization",
        "check the initial equations, or give a guess closer to the solution you mean",
    ),
    "E0839": error(
        "the initial state is over-determined: {last} contradicts {others}",
        "no state was found that satisfies them together",
        "delete one of them; without `fixed = true` a start is a guess",
    ),
    "E0840": error(
        "the simulation cannot continue at t = {time} s: no rate of `{name}` has the momentum or "
        "the energy that the event leaves",
        "its momentum does not grow with its rate without a limit",
        "write a Lagrangian whose derivative by `der({name})` grows without a limit, or change start values",
    ),
    "E0842": error(
        "with these parameters the equations of `{name}` are {part} times as large as those of constraints beside it",
        "the simulation cannot tell it from round-off",
        "write the values into the model and compile it again, or divide the constraint by the parameter that is small",
    ),
    "E0843": error(
        "no forces satisfy the law of friction of {text} at t = {time} s, and the simulation cannot continue",
        label="friction wedges here",
        help="check the sign and the size of the limit: above a critical friction a sliding body presses itself "
        "against the surface that it slides on, and no finite force holds it",
    ),
    "E0845": error(
        "input `{name}` takes {what}, not {value}",
        "{what} only",
        "in a table each value holds until the next row",
    ),
    "E0846": error(
        "the table of input `{name}` has two time derivatives, and the model needs `{derivative}`",
        None,
        "give `{derivative}` as a table of its own",
    ),
    "E0847": error(
        "the table of input `{name}` jumps at t = {time} s, and the model needs its time derivative",
        None,
        "add a row, so that the value changes over some time",
    ),
    "N0848": note(
        "the table of input `{name}` is read as monotone cubics; `{derivative}` jumps at its rows",
        None,
        "give `{derivative}` and the derivative before it as tables too, if they are known",
    ),
    "E0849": error(
        "input `{derivative}` is given, but not `{name}`, of which it is the time derivative",
        None,
        "give `{name}` too, from the same signal",
    ),
    "E0857": error(
        "output `{name}` is {found} at t = {time} s",
        None,
        "look for a division by zero, or a root or logarithm outside its domain; an `if` or `max(x, 1e-9)` avoids them",
    ),
    "E0858": error(
        "the clock `{name}` ticks {ticks} times in this simulation, which has at most {most} steps",
        "its period is too short",
        "use a longer period, or simulate for a shorter time",
    ),
    "W0859": warning(
        "`{name}` becomes {value} at t = {time} s: Integers are exact up to 2^53 - 1 = 9007199254740991",
        "loses digits there",
        "keep it smaller, with `mod` or by counting in larger parts",
    ),
    "E0880": error(
        "`{name}` is fixed when the model is compiled: a motion has no derivative by it",
        None,
        "differentiate by parameters that may change between runs; `lag check` lists them",
    ),
    "E0881": error(
        "the motion has no derivatives behind t = {time} s: `{name}` touches its border and does not pass it",
        "its instant has no derivative",
        "stop before it, or change a start value or a parameter so that it passes clearly",
    ),
    "E0882": error(
        "the motion has no derivative by `{name}` behind t = {time} s: neighbours on one side go on otherwise than on "
        "the other",
        None,
        "stop before it, or change a start value or a parameter so that the order of events is clear",
    ),
    "W0883": warning(
        "at t = {time} s several modes end at one instant ({count} such instants): derivatives behind it hold on one "
        "side only",
    ),
    "E0884": error(
        "derivatives of a motion need {text}",
        None,
        "change that, or simulate without `tangents`",
    ),
    "E0885": error(
        "input `{name}` cannot be {value}{when}: it takes {allowed}",
        "declared here",
        "correct the value; a table changes it at the time of its row",
    ),
    "W0886": warning(
        "`{name}` turns at t = {time} s by less than the error of the motion",
        "since it turned before, its value has been zero within the tolerance",
        "use a smaller tolerance, or a condition with a margin",
    ),
    "E0887": error(
        "the start rates of `{name}` and `{other}` contradict each other: the constraints do not allow both",
        "explicit start rate",
        "leave one of them out, or write `fixed = true` at the one that holds",
    ),
    "W0888": warning(
        "at t = {time} s{often}: {text}",
        "is false from there on",
        "the motion goes on; check the state and the parameters, or whether the model is good for them",
    ),
    "E0898": error(
        "{time}: `{name}` would need a past of more than 4096 pieces",
        "delayed",
        "so many events within one delay: take a shorter delay, or longer steps of what drives the model",
    ),
}
