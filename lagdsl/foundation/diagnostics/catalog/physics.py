"""Family 05: physics."""

from lagdsl.foundation.diagnostics.catalog.row import Row, error, note, warning

ROWS: dict[str, Row] = {
    "E0501": error(
        "coordinate `{name}` is never used",
        label="no mass, energy, load or constraint depends on it",
        help="let a point, an energy or a constraint depend on it, or delete it",
    ),
    "E0502": error(
        "`{keyword}` depends on `{rate}`; velocity-dependent potentials go into `lagrangian`",
        label="a potential energy is a function of position and time",
        help="write `lagrangian -(...)`: a potential enters the Lagrangian with a minus sign",
    ),
    "E0503": error(
        "`{name}` has no inertia",
        label="no kinetic energy depends on der({name})",
        help="give a mass or an inertia to the body that it moves, or prescribe the motion by a definition",
    ),
    "E0504": error(
        "`kinetic` is not quadratic in the rates",
        label="a kinetic energy is quadratic plus linear plus constant in the rates",
        help="write `lagrangian` instead of `kinetic` for a Lagrangian of another form",
    ),
    "E0505": error(
        "the {what} depends on `{name}`, but masses and inertias cannot change during the motion",
        label="must be built from parameters",
        help="a changing mass carries momentum away: state energies and forces in `lagrangian` and `force`",
    ),
    "E0506": error(
        "the {what} is negative: {value} {unit} with the given parameters",
        label="must be zero or positive",
        help="give a value of zero or more",
    ),
    "E0507": error(
        "gravity depends on `{name}`",
        label="may depend on time and parameters only",
        help="write a field that changes with position as `potential`",
    ),
    "E0508": error(
        "the {what} depends on the rate `{rate}`",
        label="a position is a function of the coordinates and time",
        help="let it depend on `{base}` itself; a position with dynamics of its own is a `state`",
    ),
    "E0509": error(
        "impossible inertia: {left} < {right} for body `{name}`",
        label="no distribution of mass has these moments",
        help="two moments of inertia together are never smaller than the third; a thin disc has Ixx + Iyy = Izz",
    ),
    "W0510": warning(
        "the model has masses but no gravity: write `gravity = ...`, or `gravity = 0` for weightless motion",
        label="has no weight",
        help="`gravity = -g_n*world.y;` is the usual one",
    ),
    "W0511": warning(
        "gravity may be counted twice",
        label="equals the automatic term",
        secondary="already adds -m*g.r for `{item}`",
        help="remove one of the two",
    ),
    "E0512": error(
        "`{keyword}` depends on the acceleration `{acceleration}`",
        label="an energy is a function of coordinates, rates and time",
        help="write it with coordinates, rates and time only",
    ),
    "N0513": note(
        "nothing is free to move: the model has neither a coordinate nor a state; it has {has}",
        label="the time, inputs and events determine the whole model",
        help="this is correct for drives that prescribe a motion, a structure or a controller; "
        "else declare what moves: `coordinate Angle theta;`",
    ),
    "W0514": warning(
        "this `{keyword}` has no effect: {reason}",
        label="changes nothing in the equations of motion",
        help="delete it, or let it depend on what moves",
    ),
    "N0515": note(
        "invariant `{name}` is proved: it holds for every motion and all parameters",
        label="follows from the Lagrangian itself",
    ),
    "E0516": error(
        "the frame has no axes: {reason}",
        label="not a rotation",
        help="`.axes` takes three perpendicular unit vectors with ex x ey = ez; `.rotate` any axis that is not zero",
    ),
    "E0517": error(
        "the attributes of `{name}` are impossible: {reason}",
        label="declared here",
        help="correct `min`, `max` or `nominal`, or leave them out",
    ),
    "W0518": warning(
        "the kinetic energy is negative for some rates",
        label="enters with a minus",
        help="check the sign: a kinetic energy is 1/2*m*v*v; move terms of another sign to `potential`",
    ),
    "N0519": note(
        "this load does no work on any admissible motion",
        label="enters no equation of motion",
        help="this is correct for a force that a guide or a rod balances; `lag derive` shows F.dr/dq for each load",
    ),
    "W0520": warning(
        "{what} jump where `{name}` has a corner; the simulation takes the limit of a rounded corner, which conserves "
        "energy",
        label="not smooth along the motion",
        help="write branches that meet smoothly, or define the jump with a `contact`, or with `reinit` in a `when`; "
        "`smooth(1, ...)` declares that both sides have one slope",
    ),
    "N0521": note(
        "where `{name}` changes, the simulation conserves momentum, not velocity",
        label="the kinetic energy depends on it",
        help="write `reinit(der(q), ...)` in the same clause to set the velocity",
    ),
    "W0522": warning(
        "{subject} is negative: {value}",
        label="drives the motion instead of damping it",
        help="check the sign; write a force or torque in the direction of the motion as a load",
    ),
    "N0523": note(
        "this `{keyword}` has neither mass nor inertia with the given parameters",
        label="adds nothing to the equations of motion",
        help="this is correct for a link whose mass is neglected",
    ),
    "E0524": error(
        "the mass center of the {what} moves in its frame with `{name}`",
        label="`com` must be built from parameters",
        help="give the body a frame that moves with it: `frame c = f.move({{x, 0, 0}});`, then `body ... on c`",
    ),
    "W0525": warning(
        "the reaction at `{name}` is zero: no mass, body, load, energy or constraint depends on this point",
        label="nothing is held there",
        help="write `mass m at {name};`: an equal position that is written again is another one",
    ),
    "W0526": warning(
        "the kinetic energy of `{item}` may be counted twice",
        label="equals the automatic term",
        secondary="has this kinetic energy by itself",
        help="remove one of the two",
    ),
    "W0527": warning(
        "gravity has no effect: it acts along z, and all masses move in the plane z = 0",
        label="perpendicular to every motion",
        help="write `gravity = -g_n*world.y;`, or `gravity = 0;` for motion in a horizontal plane",
    ),
    "E0528": error(
        "`{function}` has no value here: {reason}",
        label="asks for forces that a motion requires",
        help="name independent coordinates of the equations of motion",
    ),
    "N0529": note(
        "no inertia acts along {names}: balances of forces determine the motion there",
        label="no kinetic energy depends on der({name})",
        help="this is correct for a knot of springs, the middle of two dampers or a circuit without a coil; else give "
        "a mass or an inertia to what moves",
    ),
}
