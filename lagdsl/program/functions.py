"""The functions of a program: their names, arguments and results. Both derivations provide all of them.

nq coordinates, nz states, nu inputs, np parameters, nc declared constraint rows, ny outputs, ni invariants,
na assertions.
The sign is that of the language reference: M qdd - J' lam = f, J qdd = gamma.

| function | arguments | results |
|---|---|---|
| start | t p | start values q (nq), qd (nq), z (nz), and default inputs u (nu) |
| position_constraint | t q qd z u w p | phi (nc), and J (nc, nq); `phi` is zero for rows of velocity level |
| velocity_constraint | t q qd z u w p | residual J qd + b (nc) of every row, and J (nc, nq) |
| mass_matrix | t q qd z u w p | M (nq, nq), symmetric, both halves |
| dynamics | t q qd z u w p | M (nq, nq), f (nq), J (nc, nq), gamma (nc) |
| inverse_dynamics | t q qd z u w p qdd | tau = M qdd - f (nq), of about the size of T and V |
| residual | t q qd z u w p qdd lam | r = M qdd - f - J' lam (nq), s = J qdd - gamma (nc) |
| residual_tangent | t q qd z u w p qdd lam dq dqd dz du dp | dr (nq), ds (nc): along a direction, qdd and lam held |
| state_derivative | t q qd z u w p qdd lam | zd (nz) |
| state_derivative_tangent | t q qd z u w p qdd lam dq dqd dz du dp dqdd dlam | dzd (nz) |
| output | t q qd z u w p qdd lam | y (ny) |
| output_tangent | t q qd z u w p qdd lam dq dqd dz du dp dqdd dlam | dy (ny) |
| energies | t q qd z u w p | total, kinetic, potential, jacobi (each shape ()) |
| momenta | t q qd z u w p | dL/dqd (nq) |
| power | t q qd z u w p | load: Q . qd, dissipated: dD/dqd . qd (each shape (nq), per coordinate) |
| monitor | t q qd z u w p qdd lam | invariant (ni), scale (ni): largest absolute term of each, assertion (na) |
| initial_equation | t q qd z u w p qdd lam | residual (ne) of the initial equations |
| constraint_tangent | t q qd z u w p dq dqd dz du dp | dphi (nc), and d(J qd + b) (nc), along a direction |
| momentum_tangent | t q qd z u w p dqd | M dqd (nq) |
| elimination | t q qd z u w p | a (nq), l (nc), Y (nk, nq), K (nk, nc), J (nk, nq), gamma (nk), pivot: see below |
| acceleration_tangent | t q qd z u w p qdd lam dq dqd dz du dp | dqdd (nq), dlam (nc), ds (nk), pivot: see below |
| discrete_start | t p | start values w (nw) |
| indicator | t q qd z u w p qdd lam | g (nr): a relation holds where its entry is positive or, if not strict, zero |
| standing | t q qd z u w p qdd lam | w (nw) with relations as they stand |
| contact | t q qd z u w p | gap, speed (ni), dgap/dq (ni, nq) of contacts, then of `impact`; restitution, stick, rest |
| clock | t p | first instant, period (both one entry per clock) |
| time_event | t w p | what time alone changes: value, told (nt); distance, rate, affine, entry, change (ng) |
| event | t q qd z u w p qdd lam | a pass over the `when` clauses: w; reset, value; impact, restitution; stop; fail |
| definition | t q qd z u w p qdd lam | d (nd): every named value, first those that depend on p only |
| definition_tangent | t q qd z u w p qdd lam dq dqd dz du dp dqdd dlam | dd (nd) |
| start_tangent | t p dp | how the start values change with the parameters: dq (nq), dqd (nq), dz (nz), du (nu) |
| energies_tangent | t q qd z u w p dq dqd dz du dp | dtotal, dkinetic, dpotential, djacobi (each shape ()) |
| initial_equation_tangent | t q qd z u w p qdd lam dq dqd dz du dp dqdd dlam | dresidual (ne) |
| time_tangent | t q qd z u w p qdd lam | with the time alone: dr, ds, dphi, d(J qd + b), dzd, dy, denergies, dd |

M written out has nq^2 entries, and in a long tree of bodies each of them is a sum over what both coordinates move;
`momentum_tangent` is of the size of the kinetic energy. Programs of many coordinates have it in place of `mass_matrix`
and `dynamics`, which engines then form column by column.

`elimination` is there only where solving the equations while they are expressions costs less than forming M and solving
at run time. The multipliers of the nk rows `Program.kept_rows` are left to run time, lam_k; all others are solved for:

    qdd = a + Y' lam_k ,   lam = l + K' lam_k (and lam_k itself at its rows) ,   J Y' lam_k = gamma - J a

with J and gamma of the kept rows, and J Y' symmetric and positive semidefinite. `pivot` is what subtraction left of the
smallest pivot, relatively: where it is small or no number, the others are not to be used.
`acceleration_tangent`, there with `elimination`, solves M dqdd - J' dlam = -dr, J dqdd = -ds in the same way: dqdd and
dlam with the multipliers of the kept rows held, and ds of these rows.
Directions `dp` hold one entry per independent parameter.
The functions from `discrete_start` to `event` belong to models with discretes, see `docs/adr/0030-events.md`; those
from `definition` on to programs that tell every variable of their model (`mechanics/named.py`).
"""

from lagdsl.graph.operation import Group

STATE = (Group.TIME, Group.Q, Group.QD, Group.Z, Group.U, Group.W, Group.P)
SOLVED = (*STATE, Group.QDD, Group.LAMBDA)
DIRECTIONS = (Group.DIRECTION_Q, Group.DIRECTION_QD, Group.DIRECTION_Z, Group.DIRECTION_U, Group.DIRECTION_P)
SOLVED_DIRECTIONS = (*DIRECTIONS, Group.DIRECTION_QDD, Group.DIRECTION_LAMBDA)

SIGNATURES: dict[str, tuple[Group, ...]] = {
    "start": (Group.TIME, Group.P),
    "position_constraint": STATE,
    "velocity_constraint": STATE,
    "mass_matrix": STATE,
    "dynamics": STATE,
    "inverse_dynamics": (*STATE, Group.QDD),
    "residual": SOLVED,
    "residual_tangent": (*SOLVED, *DIRECTIONS),
    "state_derivative": SOLVED,
    "state_derivative_tangent": (*SOLVED, *SOLVED_DIRECTIONS),
    "output": SOLVED,
    "output_tangent": (*SOLVED, *SOLVED_DIRECTIONS),
    "energies": STATE,
    "momenta": STATE,
    "power": STATE,
    "monitor": SOLVED,
    "initial_equation": SOLVED,
    "constraint_tangent": (*STATE, *DIRECTIONS),
}

# Functions that not every program has.
OPTIONAL: dict[str, tuple[Group, ...]] = {
    "elimination": STATE,
    "discrete_start": (Group.TIME, Group.P),
    "indicator": SOLVED,
    "standing": SOLVED,
    "contact": STATE,
    "clock": (Group.TIME, Group.P),
    "event": SOLVED,
    "momentum_tangent": (*STATE, Group.DIRECTION_QD),
    "definition": SOLVED,
    "definition_tangent": (*SOLVED, *SOLVED_DIRECTIONS),
    "start_tangent": (Group.TIME, Group.P, Group.DIRECTION_P),
    "energies_tangent": (*STATE, *DIRECTIONS),
    "initial_equation_tangent": (*SOLVED, *SOLVED_DIRECTIONS),
    "time_tangent": SOLVED,
    "time_event": (Group.TIME, Group.W, Group.P),
    "acceleration_tangent": (*SOLVED, *DIRECTIONS),
}

# Those that are for many directions at once only: modules of single calls do without.
ALONG_MANY = ("acceleration_tangent",)

# Those that a program may lack where it has `momentum_tangent`.
WRITTEN_OUT = ("mass_matrix", "dynamics")
