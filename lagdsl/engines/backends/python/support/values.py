"""The values that users ask for, over leading axes, from the functions of a model."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from lagdsl.engines.backends.python.support.feedback import with_loads
from lagdsl.engines.backends.python.support.motion import Sizes
from lagdsl.engines.backends.python.support.names import own_entries, real_numbers, with_entries

Floats = NDArray[np.float64]
Evaluate = Callable[..., tuple[Floats, ...]]
# A vector in the order of its names, or some of its entries by name.
Entries = ArrayLike | Mapping[str, Any]
# Start values by name.
Starts = Mapping[str, Any]
# t, q, qd, z, u, w, p.
State = tuple[Any, Any, Any, Any, Any, Any, Any]
FLOAT = np.dtype(np.float64)
NOTHING = np.zeros(0)
# A value at t, q, qd, z, u, w, p, qdd (None where they are left out, or not looked at), into `out` if there is one; the
# first argument are the `Values` that it is one of.
Call = Callable[..., Floats]

# Values by the names of what users call: a result of a function of the model;
EVALUATED = {
    "inverse_dynamics": ("inverse_dynamics", 0),
    "mass_matrix": ("mass_matrix", 0),
    "coriolis_matrix": ("equation_terms", 0),
    "gravity_forces": ("equation_terms", 1),
    "bias_forces": ("equation_terms", 2),
    "regressor": ("regressor", 0),
    "constraint_jacobian": ("velocity_constraint", 1),
    "energy": ("energies", 0),
}
# These take accelerations qdd, too.
WITH_ACCELERATIONS = ("inverse_dynamics", "regressor")
SOLVED = {"forward_dynamics": 0, "multipliers": 1}
# derivatives, by these variables, of the motion or of the outputs.
OUTPUT_JACOBIANS = {by: f"output_jacobian by {by}" for by in ("state", "input", "parameter")}
DIFFERENTIATED = {
    "state_jacobian": ("state", 0),
    "input_jacobian": ("input", 0),
    "parameter_jacobian": ("parameter", 0),
    **{name: (by, 1) for by, name in OUTPUT_JACOBIANS.items()},
}
NAMED = (*EVALUATED, *SOLVED, *DIFFERENTIATED, "output")


class Values:
    """Values of a model, and how arguments become arrays. See Interface, which says what they are.

    `calls` has a function for each of NAMED; they get these values as the first argument.
    """

    def __init__(
        self,
        evaluate: Evaluate,
        solve: Evaluate,
        differentiate: Evaluate,
        sizes: Sizes,
        defaults: Sequence[float],
        names: Mapping[str, Sequence[str]],
        frames: tuple[str, ...] = (),
        points: tuple[str, ...] = (),
        aliases: Mapping[str, str] | None = None,
    ) -> None:
        self._names, self._aliases = names, aliases or {}
        self._places = frames, points
        self._evaluate = evaluate
        self._solve = solve
        self._differentiate = differentiate
        self._sizes = sizes
        self._defaults = np.array(defaults, dtype=np.float64)
        self._calls: Mapping[str, Call] = BROADCAST
        self._row_factors: Floats = np.ones(1)  # by which the equations multiply rows, where that is known

    def _by_names(self, state: State, start: Starts | None, inputs: Any, parameters: Entries | None) -> State:
        """t, q, qd, z, u, w, p, of which some have other names or are those of the start. Raises ValueError."""
        return by_names(state, start, inputs, parameters, self._started)

    def _started(self, t: ArrayLike | None, start: Starts, u: Any, p: Entries | None) -> State:
        """The state with which a motion from the values `start` begins, with inputs and parameters."""
        return no_start(t, start, u, p)

    def _value(self, name: str, *given: Any) -> Floats:
        """The value of this name at t, q, qd, z, u, w, p, qdd."""
        *state, qdd = given
        if name in EVALUATED:
            function, place = EVALUATED[name]
            arguments = self._state(*state)
            if name in WITH_ACCELERATIONS:
                arguments = (*arguments, self._vector("qdd", qdd, None))
            value = self._evaluate(function, *arguments)[place]
            return value / np.reshape(self._row_factors, (-1, 1)) if name == "constraint_jacobian" else value
        arguments = self._with_loads(*state)
        if name in DIFFERENTIATED:
            by, place = DIFFERENTIATED[name]
            return self._differentiate(by, *arguments)[place]
        solved = self._solve(*arguments)
        if name == "output":
            return self._evaluate("output", *arguments, *solved)[0]
        return solved[0] if name == "forward_dynamics" else solved[1] * self._row_factors

    def _kinematics(
        self,
        t: ArrayLike,
        q: Entries,
        qd: Entries | None,
        z: Entries | None = None,
        u: Entries | None = None,
        w: Entries | None = None,
        p: Entries | None = None,
    ) -> tuple[Floats, ...]:
        return self._evaluate("kinematics", *self._state(t, q, qd, z, u, w, p))

    def _with_loads(self, *given: Any) -> tuple[Floats, ...]:
        """t, q, qd, z, u, w, p, with the loads that depend on the motion that they cause."""
        state = self._state(*given)
        count = self._sizes.loads
        return with_loads(self._evaluate, self._solve, count, *state) if count else state

    def _state(
        self,
        t: ArrayLike,
        q: Entries,
        qd: Entries | None,
        z: Entries | None,
        u: Entries | None,
        w: Entries | None,
        p: Entries | None,
    ) -> tuple[Floats, ...]:
        """t, q, qd, z, u, w, p as arrays, with what is left out."""
        sizes = self._sizes
        coordinates = self._vector("q", q, None)
        time = _time(t, coordinates.shape, sizes.q)
        parameters = self._defaults if p is None else self._vector("p", p, self._defaults)
        if (sizes.z and _is_partial(z)) or (sizes.u and _is_partial(u)):
            _, _, initial_states, default_inputs = self._evaluate("start", time, parameters)
        else:
            initial_states = default_inputs = NOTHING  # nothing, or nobody looks at them
        state = (
            time,
            coordinates,
            np.zeros(sizes.q) if qd is None else self._vector("qd", qd, None),
            initial_states if z is None else self._vector("z", z, initial_states),
            default_inputs if u is None else self._vector("u", u, default_inputs),
        )
        if not sizes.w or not _is_partial(w):
            return (*state, NOTHING if w is None else self._vector("w", w, None), parameters)
        standing = self._standing(*state, parameters)
        return (*state, standing if w is None else self._vector("w", w, standing), parameters)

    def _standing(self, *state: Floats) -> Floats:
        """w as relations stand at t, q, qd, z, u, p."""
        *before, parameters = state
        started = self._evaluate("discrete_start", before[0], parameters)[0]
        solved = self._solve(*before, started, parameters)
        return self._evaluate("standing", *before, started, parameters, *solved)[0]

    def _vector(self, name: str, given: Entries, others: Floats | None) -> Floats:
        """Entries by name, or all of them; those that are left out by name are those of `others`."""
        names = self._names[name]
        if not isinstance(given, np.ndarray) and isinstance(given, Mapping):  # arrays are told soonest
            own = own_entries(self._aliases, given) if name in ("q", "qd") else given
            return with_entries(name, names, self._numbers(name, own), others)
        return whole_vector(name, given, len(names))

    def _numbers(self, name: str, given: Mapping[str, Any]) -> Mapping[str, ArrayLike]:
        """Values by name in SI units."""
        return given


def _time(t: ArrayLike, shape: tuple[int, ...], count: int) -> Floats:
    """Raises ValueError for what must be the coordinates: one state whose time is a vector as long as it."""
    time = real_numbers("t", t)
    if time.ndim and time.shape[-1] == count and len(shape) == 1 and count > 1:
        raise ValueError(
            f"t has the shape {time.shape}, that of coordinates: the time is the first argument. For one state at "
            f"{count} times give q the shape (1, {count})"
        )
    return time


def _is_partial(given: Entries | None) -> bool:
    """True if entries may be left out."""
    return given is None or isinstance(given, Mapping)


def whole_vector(name: str, value: ArrayLike, length: int) -> Floats:
    """(..., length). Raises ValueError for what is no number or of another length."""
    array = real_numbers(name, value)
    if array.ndim == 0 and length == 1:
        array = array.reshape(1)
    if array.ndim == 0 or array.shape[-1] != length:
        hint = "; the arguments are t, q, qd, ..." if name in ("q", "qd") else ""
        raise ValueError(f"{name} must have {length} entries along its last axis, its shape is {array.shape}{hint}")
    return array


def broadcasting(name: str) -> Call:
    """The value of this name over leading axes of its arguments."""

    def call(own: Values, *arguments: Any) -> Floats:
        *given, out = arguments
        value = own._value(name, *given)
        return value if out is None else into(out, value)

    return call


def state_of(own: Values, *given: Any) -> tuple[Floats, ...]:
    """t, q, qd, z, u, w, p as arrays, with what is left out."""
    return own._state(*given)


BROADCAST = {name: broadcasting(name) for name in NAMED}


def into(out: Floats, value: Floats) -> Floats:
    """`out` with the value. Raises ValueError for one that cannot take it."""
    if out.__class__ is not np.ndarray or out.dtype is not FLOAT or out.shape != value.shape or not out.flags.carray:
        require_room(out, value.shape)
    out[...] = value
    return out


def require_room(out: Any, shape: tuple[int, ...]) -> None:
    """Raises ValueError for an `out` that is no array of the shape, of float64, in one piece that can be written."""
    if not isinstance(out, np.ndarray) or out.dtype != FLOAT:
        found = f"of {out.dtype}" if isinstance(out, np.ndarray) else f"a {type(out).__name__}"
        raise ValueError(f"out must be an array of float64, it is {found}")
    if out.shape != shape:
        raise ValueError(f"out must have the shape {shape} of the result, its shape is {out.shape}")
    if not out.flags.c_contiguous:
        raise ValueError("out must lie in one piece, row by row (C-contiguous), as arrays from np.empty do")
    if not out.flags.writeable:
        raise ValueError("out is read-only")


def by_names(
    state: State,
    start: Starts | None,
    inputs: Any,
    parameters: Entries | None,
    started: Callable[[ArrayLike | None, Starts, Any, Entries | None], State],
) -> State:
    """t, q, qd, z, u, w, p with `inputs` and `parameters`, which are other names of u and p; without q the state that
    is `started` from the values `start`, those of the model where they are left out. Raises ValueError where one
    argument is given twice, or a part of the state alone."""
    t, q, qd, z, u, w, p = state
    u = u if inputs is None else given_once("u", u, "inputs", inputs)
    p = p if parameters is None else given_once("p", p, "parameters", parameters)
    if q is None:
        for name, given in (("qd", qd), ("z", z)):
            if given is not None:
                raise ValueError(f"{name} is given without q: give q, too, or start values by name, start={{...}}")
        t, q, qd, z, u, started_w, p = started(t, {} if start is None else start, u, p)
        return t, q, qd, z, u, started_w if w is None else w, p
    if start is not None:
        raise ValueError("q and start are two ways to give the state: give one of them")
    return t, q, qd, z, u, w, p


def no_start(t: ArrayLike | None, start: Starts, u: Any, p: Entries | None) -> State:
    """For functions of arrays alone. Raises ValueError."""
    raise ValueError("q is left out, and here is no search for a start: the arguments are t, q, qd, ...")


def given_once(name: str, value: Entries | None, word: str, same: Entries) -> Entries:
    """The argument that has a long name, too. Raises ValueError where both are given."""
    if value is not None:
        raise ValueError(f"{name} and {word} are two names of one argument: give one of them")
    return same
