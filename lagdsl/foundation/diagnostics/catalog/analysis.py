"""Family 08, linearization: modes, thresholds and equilibria."""

from lagdsl.foundation.diagnostics.catalog.row import Row, error, warning

ROWS: dict[str, Row] = {
    "E0850": error(
        "the constraints lose rank at this point, so no linearization exists",
        None,
        "choose a state near it, for example with --set; here {names} depend on each other",
    ),
    "E0851": error(
        "no linearization at this point: `{name}` has no inertia there",
        "the equations do not determine the accelerations",
        "choose coordinates that are regular in this position",
    ),
    "E0852": error(
        "no equilibrium found: {left}",
        None,
        "free more coordinates or inputs, give starts closer to the equilibrium you mean, or keep the rates of the "
        "start with `--steady`: a steady motion",
    ),
    "E0853": error(
        "`{name}` cannot be {what}",
        None,
        "there are {known}",
    ),
    "W0854": warning(
        "this point is neither an equilibrium nor part of a steady motion: {reason}",
        None,
        "the eigenvalues describe the neighborhood for an instant only; `--trim` takes the nearest equilibrium",
    ),
    "E0855": error(
        "no linearization at this point: {name} has no finite derivative there",
        None,
        "a root of zero, a division by zero or the norm of a zero vector has no finite derivative: use a smooth form, "
        "e.g. sqrt(v*v + eps^2)",
    ),
    "E0856": error(
        "the mass matrix depends on the rates, so there is no Coriolis matrix",
        "this energy is not quadratic in the rates",
        "use `inverse_dynamics` at zero accelerations, which gives all these forces in one",
    ),
    "E0860": error(
        "no linearization at this point: {what} is {values} on the two sides of {names}",
        "turns at this point",
        "choose a state on the side that you mean: start values that differ by 1e-9 of their size are enough",
    ),
    "E0861": error(
        "name the {what} of the transfer function: the model has {count}",
        None,
        "there are {known}",
    ),
    "E0862": error(
        "the clocks {names} have no common period of at most {most} ticks",
        "one of them",
        "use periods of which one is a short multiple of another",
    ),
    "E0863": error(
        "{every} is no multiple of the common period of the clocks, {common}",
        "ticks",
        "take {common} or a multiple of it",
    ),
    "E0864": error(
        "no fixed point of the sampled loop found: {left}",
        None,
        "give starts closer to it; an integrator whose input is never zero has none",
    ),
    "E0865": error(
        "no linearization of the sampled loop at this point: {what} is set with two sides of {names}",
        "turns at this point",
        "choose a state on the side that you mean: start values that differ by 1e-9 of their size are enough",
    ),
    "E0866": error(
        "no linearization of the sampled loop: at a tick {reason}",
        None,
        "linearize the plant, without `--every`",
    ),
    "E0867": error(
        "no inverse kinematics: {names} restricts positions by the motion before",
        None,
        "write it as a constraint of positions, `constraint x == 2*y` in place of `constraint der(x) == 2*der(y)`",
    ),
    "E0868": error(
        "no {what} of a model with delays: `{name}` needs a past, which no finite state tells",
        "delayed",
        "simulate it; or write an approximation by states in place of the delay, for a short one `der(y) = (x - y)/T`",
    ),
    "W0869": warning(
        "this equilibrium is unstable: {count}, the fastest as exp({rate}*time)",
        None,
        "a motion leaves it unless a controller holds it; another one needs nearer starts, such as an equilibrium "
        "with other parameters",
    ),
}
