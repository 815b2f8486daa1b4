"""Family 06: constraints."""

from lagdsl.foundation.diagnostics.catalog.row import Row, error, note, warning

ROWS: dict[str, Row] = {
    "E0602": error(
        "{subject} can never {verb}",
        "no values of the coordinates satisfy this",
        "check the lengths and positions that enter it",
    ),
    "E0603": error(
        "{subject} contradicts {others}",
        "each can hold alone, but not with the others",
        "delete one of them, or change its condition",
    ),
    "E0604": error(
        "velocity constraint `{name}` is not linear in the rates",
        "rates may enter with constant or position-dependent factors only",
        "state the condition for the components, or the holonomic condition it follows from",
    ),
    "N0605": note(
        "{subject} is identically satisfied; its multiplier is 0",
        "does not restrict the motion",
    ),
    "N0606": note(
        "velocity constraint `{name}` is integrable; stating it for the coordinates themselves saves one state",
        "restricts the configuration as well",
        "for rolling along a line: `x = R*phi` instead of `der(x) = R*der(phi)`",
    ),
    "N0607": note(
        "constraint `{name}` follows from {others} and is redundant",
        "adds nothing; its multiplier is not unique and is given in minimum norm",
    ),
    "W0608": warning(
        "at t = {time} s the constraints lose rank ({rank} instead of {general}) at `{name}`",
        "a singular position of the mechanism",
        "the motion is not unique there; the simulation takes the branch of the smallest accelerations",
    ),
    "E0609": error(
        "the gradient of `{name}` {fault}, so no force can enforce it",
        "restricts the motion, but does not determine the direction of its force",
        "write the condition itself, not its square, its absolute value or a length: `x = l`, not `(x - l)^2 = 0`",
    ),
    "E0610": error(
        "{subject} are tangent: where they hold together, they do not determine their forces",
        "where they touch, their gradients depend on each other",
        "change a length or a position so that they cross, or fix each coordinate by its own condition",
    ),
    "N0611": note(
        "nothing can move: {independent} leave no degree of freedom",
        "the last of them",
        "this is correct for a structure whose reactions are sought; else delete the superfluous constraints",
    ),
    "N0612": note(
        "the equations multiply `{name}` by 2^{power}",
        "is about {part} times as large as the constraints that share coordinates with it",
        "the motion stays the same, and so does its multiplier; only modules of `lag build` have that of the product",
    ),
}
