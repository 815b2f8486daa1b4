"""The functions of a program: the one table of their names, arguments and results.

Both derivations provide all of them. The members of lag_model, the enumeration and the dispatcher of the C runtime are
written from this table (`python -m lagdsl.engines.runtime.generate`); the ctypes view of lag_model is built from it.

Lengths: nq coordinates, nz states, nu inputs, nw discretes, np parameters, nc declared rows of constraints, nk of them
left to run time, ny outputs, ni invariants, na assertions, nd named values; those of COUNTED are told by results only.
The sign is that of the language reference: M qdd - J' lam = f, J qdd = gamma.

M written out has nq^2 entries, and in a long tree of bodies each of them is a sum over what both coordinates move;
`momentum_tangent` is of the size of the kinetic energy. Programs of many coordinates have it in place of `mass_matrix`
and `dynamics`, which engines then form column by column.

`elimination` is there only where solving the equations while they are expressions costs less than forming M and solving
at run time. The multipliers of the nk rows `Program.kept_rows` are left to run time, lam_k; all others are solved for:

    qdd = a + Y' lam_k ,   lam = l + K' lam_k (and lam_k itself at its rows) ,   J Y' lam_k = gamma - J a

with J and gamma of the kept rows, and J Y' symmetric and positive semidefinite. `pivot` is what subtraction left of the
smallest pivot, relatively: where it is small or no number, the others are not to be used.
`acceleration_tangent`, there with `elimination`, solves M dqdd - J' dlam = -dr, J dqdd = -ds in the same way: dqdd and
dlam with the multipliers of the kept rows held, and ds of these rows. So does `correction`, in long programs with
constraints, for M change - J' lam = 0, J change = -residual: the residuals of the rows stand in place of lam.
Directions `dp` hold one entry per independent parameter.

Models with discretes: an indicator is positive (or, for relations that allow it, zero) where its relation holds. Gaps
are those of the contacts, then those that clauses let collide; contacts that are one way have the gap zero and a rate
that is no derivative of it, with its derivatives by qd in place of the Jacobian. A pass over the clauses gives w after
it and, action by action, whether it acts: resets with their values, collisions with their restitutions, ends and
failures (`docs/explanation/hybrid_model.md`). Programs that tell every variable of their model have named values
(`mechanics/named.py`).

Programs that tell their terms and how frames move (`mechanics/by_name.py`): ninertial parameters of the regressor, ten
of a body, one of a mass and one of each coefficient of friction; three entries of nplace, nine of naxes and six of
ntwist for a frame, three of nplace and ntwist for a point. All vectors have world components.
"""

from enum import Enum

from lagdsl.algebra.graph.operation import Group
from lagdsl.foundation.record import record

STATE = (Group.TIME, Group.Q, Group.QD, Group.Z, Group.U, Group.W, Group.P)
SOLVED = (*STATE, Group.QDD, Group.LAMBDA)
DIRECTIONS = (Group.DIRECTION_Q, Group.DIRECTION_QD, Group.DIRECTION_Z, Group.DIRECTION_U, Group.DIRECTION_P)
SOLVED_DIRECTIONS = (*DIRECTIONS, Group.DIRECTION_QDD, Group.DIRECTION_LAMBDA)
_PARAMETERS = (Group.TIME, Group.P)


class Presence(Enum):
    """Condition under which a program has a function."""

    ALWAYS = "always"
    WRITTEN_OUT = "Formed from momentum_tangent() where M is not written out"
    BY_COLUMNS = "Only where M is not written out"
    ELIMINATED = "Only where the equations are solved while they are expressions"
    DISCRETES = "Only in models with discretes"
    FRICTION = "Only in models with dry friction"
    FEEDBACK = "Only in models with loads that depend on accelerations or multipliers"
    CORNERS = "Only in models with corners"
    DELAYS = "Only in models with delayed values"
    TURNS = "Only in models with outputs that are known up to whole turns"
    WAYS = "Only in models in which ways of masses depend on discretes"
    NAMED = "Only in programs that tell every named value"
    TERMS = "Only in programs that tell the terms of their equations"
    KINEMATICS = "Only in programs that tell how chosen frames and points move"
    CORRECTED = "Only in programs of many coordinates with constraints that are solved while they are expressions"


@record()
class Result:
    """One array of results: `name` as in C, `shape` in lengths."""

    name: str
    shape: tuple[str, ...]


@record()
class Signature:
    """A function: `says` what its results are. One that is not `single` is for many directions at once only."""

    name: str
    arguments: tuple[Group, ...]
    results: tuple[Result, ...]
    says: str
    presence: Presence = Presence.ALWAYS
    single: bool = True


def _function(
    name: str,
    arguments: tuple[Group, ...],
    results: str,
    says: str,
    presence: Presence = Presence.ALWAYS,
    *,
    single: bool = True,
) -> Signature:
    """`results` are written as `name[length,length]`."""
    return Signature(name, arguments, tuple(map(_result, results.split())), says, presence, single)


def _result(text: str) -> Result:
    name, _, shape = text.partition("[")
    return Result(name, tuple(filter(None, shape.rstrip("]").split(","))))


FUNCTIONS: tuple[Signature, ...] = (
    _function(
        "start",
        _PARAMETERS,
        "q0[nq] qd0[nq] z0[nz] u0[nu]",
        "start values of coordinates, rates and states; default inputs",
    ),
    _function(
        "position_constraint", STATE, "phi[nc] jacobian[nc,nq]", "phi, zero for rows of velocity level; its Jacobian J"
    ),
    _function("velocity_constraint", STATE, "residual[nc] jacobian[nc,nq]", "J qd + b of every row; J"),
    _function("mass_matrix", STATE, "mass[nq,nq]", "M, symmetric, both halves", Presence.WRITTEN_OUT),
    _function(
        "dynamics", STATE, "mass[nq,nq] force[nq] jacobian[nc,nq] gamma[nc]", "M, f, J, gamma", Presence.WRITTEN_OUT
    ),
    _function("inverse_dynamics", (*STATE, Group.QDD), "force[nq]", "M qdd - f, of about the size of T and V"),
    _function("residual", SOLVED, "motion[nq] rows[nc]", "r = M qdd - f - J' lam; s = J qdd - gamma"),
    _function(
        "residual_tangent",
        (*SOLVED, *DIRECTIONS),
        "motion[nq] rows[nc]",
        "dr, ds along a direction, at fixed qdd and lam",
    ),
    _function("state_derivative", SOLVED, "rates[nz]", "zd"),
    _function("state_derivative_tangent", (*SOLVED, *SOLVED_DIRECTIONS), "rates[nz]", "dzd"),
    _function("output", SOLVED, "y[ny]", "outputs"),
    _function("output_tangent", (*SOLVED, *SOLVED_DIRECTIONS), "y[ny]", "dy"),
    _function("energies", STATE, "total kinetic potential jacobi", "energy(), T, V, Jacobi integral [J]"),
    _function("momenta", STATE, "momentum[nq]", "dL/dqd"),
    _function(
        "power",
        STATE,
        "load[nq] dissipated[nq]",
        "power of loads, Q . qd, and of dissipation, dD/dqd . qd, by coordinate [W]",
    ),
    _function(
        "monitor",
        SOLVED,
        "invariant[ni] scale[ni] assertion[na]",
        "invariants; largest absolute term of each; of assertions 1 where they hold, else 0, of warnings -1",
    ),
    _function("initial_equation", SOLVED, "residual[ne]", "residuals of the initial equations"),
    _function("constraint_tangent", (*STATE, *DIRECTIONS), "phi[nc] residual[nc]", "dphi, d(J qd + b)"),
    _function(
        "elimination",
        STATE,
        "qdd[nq] lam[nc] response[nk,nq] lam_response[nk,nc] jacobian[nk,nq] gamma[nk] pivot",
        "with the multipliers of `kept_rows` zero qdd and lam; row by row, what these multipliers add to qdd and to "
        "lam; J and gamma of these rows; what is left of the smallest pivot, relatively",
        Presence.ELIMINATED,
    ),
    _function("discrete_start", _PARAMETERS, "w0[nw]", "start values of w", Presence.DISCRETES),
    _function("indicator", SOLVED, "g[nindicator]", "indicators of relations", Presence.DISCRETES),
    _function(
        "indicator_rate",
        (*SOLVED, Group.DIRECTION_Z, Group.DIRECTION_U, Group.DIRECTION_QDD, Group.DIRECTION_LAMBDA),
        "rate[nindicator] acceleration[nindicator]",
        "first and second derivatives of indicators along the motion, with dz, du, dqdd and dlam as the rates of "
        "states, inputs, accelerations and multipliers; second derivatives of states are those of the equations, "
        "those of the others zero",
        Presence.DISCRETES,
    ),
    _function("standing", SOLVED, "next[nw]", "w with relations as they stand", Presence.DISCRETES),
    _function(
        "contact",
        STATE,
        "gap[ngap] speed[ngap] jacobian[ngap,nq] restitution[ncontact] capture_speed[ncontact] zeno_time[ncontact]",
        "gaps, their rates, their Jacobian; restitution, and the rebound speed and the time below which a contact "
        "closes, negative where the defaults of the language hold",
        Presence.DISCRETES,
    ),
    _function("clock", _PARAMETERS, "first[nclock] period[nclock]", "first instants, periods", Presence.DISCRETES),
    _function(
        "event",
        SOLVED,
        "next[nw] reset[nreset] value[nreset] collision[ncollision] restitution[ncollision] stop[nstop] fail[nfail]",
        "a pass over the `when` clauses: w after it, and action by action whether it acts",
        Presence.DISCRETES,
    ),
    _function(
        "time_event",
        (Group.TIME, Group.W, Group.P),
        "value[ntimed] told[ntimed] distance[ndistance] rate[ndistance] affine[ndistance] entry[ndistance]",
        "what time alone changes: the entries of w as they are at that time; 0 where nothing is told of their changes, "
        "1 for a truth, 2 for a jump; distances, positive up to the next change, and their rates; 1 where they are "
        "affine in time between events; the entries that change where they reach zero",
        Presence.DISCRETES,
    ),
    _function(
        "corner",
        SOLVED,
        "far[ncorner] solved",
        "distances that pass zero where forces, energies or rates have a corner along the motion; 1 where one of them "
        "reads accelerations or multipliers",
        Presence.CORNERS,
    ),
    _function(
        "way",
        STATE,
        "way[nway]",
        "positions of masses and bodies, rotation matrices of bodies, and cosines and sines of what else the kinetic "
        "energy differentiates, as far as they depend on discretes: all of that is continuous in a motion",
        Presence.WAYS,
    ),
    _function(
        "turn",
        STATE,
        "value[nturn] rate[nturn] turn[nturn] entry[nturn]",
        "outputs that are known up to multiples of `turn`, or, four in a row with zero there, as a quaternion up to "
        "its sign: their values near the start, their rates, and which of the outputs they are",
        Presence.TURNS,
    ),
    _function(
        "delayed",
        STATE,
        "value[ndelay] time[ndelay] direct",
        "what is delayed, as it is now, and by how much [s]; 1 where one of them reads delayed values itself",
        Presence.DELAYS,
    ),
    _function(
        "friction",
        SOLVED,
        "slip[nslip] jacobian[nslip,nq] limit[nfriction] sticking[nfriction] gain[nfriction,nc] "
        "sticking_gain[nfriction,nc]",
        "slips of dry friction and their derivatives by qd, as the rows that hold them are; the forces while it "
        "slides, the largest ones while it sticks, and how both change with lam",
        Presence.FRICTION,
    ),
    _function(
        "load",
        SOLVED,
        "load[nload] by_acceleration[nload,nq] by_multiplier[nload,nc]",
        "what the entries of w that stand for loads have to be, and how that changes with qdd and lam",
        Presence.FEEDBACK,
    ),
    _function("load_tangent", (*SOLVED, *SOLVED_DIRECTIONS), "load[nload]", "dload", Presence.FEEDBACK),
    _function(
        "load_gain",
        SOLVED,
        "motion[nq,nload] rates[nz,nload] y[ny,nload] load[nload,nload]",
        "how r, zd, y and load change with the entries of w that stand for loads",
        Presence.FEEDBACK,
    ),
    _function("momentum_tangent", (*STATE, Group.DIRECTION_QD), "momentum[nq]", "M dqd", Presence.BY_COLUMNS),
    _function("definition", SOLVED, "d[nd]", "every named value, first those that depend on p only", Presence.NAMED),
    _function("definition_tangent", (*SOLVED, *SOLVED_DIRECTIONS), "d[nd]", "dd", Presence.NAMED),
    _function(
        "start_tangent",
        (*_PARAMETERS, Group.DIRECTION_P),
        "q[nq] qd[nq] z[nz] u[nu]",
        "how the start values change",
        Presence.NAMED,
    ),
    _function(
        "energies_tangent",
        (*STATE, *DIRECTIONS),
        "total kinetic potential jacobi",
        "how the energies change",
        Presence.NAMED,
    ),
    _function(
        "initial_equation_tangent",
        (*SOLVED, *SOLVED_DIRECTIONS),
        "residual[ne]",
        "how the residuals of the initial equations change",
        Presence.NAMED,
    ),
    _function(
        "time_tangent",
        SOLVED,
        "motion[nq] rows[nc] phi[nc] residual[nc] rates[nz] y[ny] total kinetic potential jacobi d[nd]",
        "how everything changes with t alone: dr, ds, dphi, d(J qd + b), dzd, dy, the energies, dd",
        Presence.NAMED,
    ),
    _function(
        "correction",
        (*STATE, Group.LAMBDA),
        "change[nq] lam_change[nc] pivot",
        "for lam in place of the residuals of the rows: the change of least inertia that takes them away to first "
        "order, and its multipliers, with those of `kept_rows` zero; what is left of the smallest pivot, relatively",
        Presence.CORRECTED,
    ),
    _function(
        "equation_terms",
        STATE,
        "coriolis[nq,nq] gravity[nq] bias[nq]",
        "C by Christoffel's symbols, dV/dq, and d/dt(dL/dqd) - dL/dq at qdd = 0",
        Presence.TERMS,
    ),
    _function(
        "regressor",
        (*STATE, Group.QDD),
        "regressor[nq,ninertial] inertial[ninertial]",
        "Y and pi: Y pi is what masses and bodies add to d/dt(dL/dqd) - dL/dq, and the forces of friction",
        Presence.TERMS,
    ),
    _function(
        "kinematics",
        STATE,
        "position[nplace] rotation[naxes] velocity[ntwist] jacobian[ntwist,nq] bias[ntwist]",
        "of the chosen frames, then of the chosen points: positions; rotation matrices, row by row; velocities, and of "
        "frames angular velocities after them; their derivatives by qd; their rates of change at qdd = 0",
        Presence.KINEMATICS,
    ),
    _function(
        "acceleration_tangent",
        (*SOLVED, *DIRECTIONS),
        "change[nq] lam_change[nc] rows[nk] pivot",
        "dqdd and dlam with the multipliers of `kept_rows` held; ds of these rows; what is left of the smallest pivot",
        Presence.ELIMINATED,
        single=False,
    ),
)

# Lengths that a program tells by its results only.
COUNTED = (
    *("ne", "nindicator", "ngap", "ncontact", "nclock", "nreset", "ncollision", "nstop", "nfail"),
    *("ntimed", "ndistance", "ncorner", "nway", "nturn", "ndelay", "nslip", "nfriction", "nload"),
    *("ninertial", "nplace", "naxes", "ntwist"),
)

BY_NAME = {function.name: function for function in FUNCTIONS}

# Arguments of the functions that every program has, or can form from `momentum_tangent`.
SIGNATURES: dict[str, tuple[Group, ...]] = {
    function.name: function.arguments
    for function in FUNCTIONS
    if function.presence in (Presence.ALWAYS, Presence.WRITTEN_OUT)
}

# Results of functions that not every program has.
OPTIONAL: dict[str, tuple[Group, ...]] = {
    function.name: function.arguments for function in FUNCTIONS if function.name not in SIGNATURES
}

# Functions for many directions at once only: modules of single calls do without.
ALONG_MANY = tuple(function.name for function in FUNCTIONS if not function.single)

# Functions that a program with `momentum_tangent` may lack.
WRITTEN_OUT = tuple(function.name for function in FUNCTIONS if function.presence is Presence.WRITTEN_OUT)
