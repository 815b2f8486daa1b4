"""Values of a model at one state, called from Python as often as a controller does."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from lagdsl.algebra.graph.operation import ARGUMENT_NAMES, Group
from lagdsl.engines.backends.python.support.kinematics import FrameKinematics, PointKinematics, kinematic_calls
from lagdsl.engines.backends.python.support.names import real_numbers
from lagdsl.engines.backends.python.support.values import (
    BROADCAST,
    NAMED,
    WITH_ACCELERATIONS,
    Call,
    Floats,
    Starts,
    State,
    Values,
    state_of,
    whole_vector,
)
from lagdsl.engines.runtime.engines.named_values import KINEMATICS

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from lagdsl.engines.runtime.engines.broadcast import BatchEngine
    from lagdsl.interfaces.api.names import Given
    from lagdsl.motion.analysis.inverse_kinematics import Placement

Place = Callable[..., "Placement"]

_VECTORS = (Group.Q, Group.QD, Group.Z, Group.U, Group.W, Group.P, Group.QDD)


class ModelFrame(FrameKinematics):
    """A frame of a model."""

    def __init__(self, name: str, own: Any, calls: Mapping[str, Call], place: Place) -> None:
        """`place` looks for coordinates: position and rotation, then the other arguments of `solve`."""
        super().__init__(name, own, calls)
        self._place = place

    def solve(
        self,
        *,
        position: ArrayLike | None = None,
        rotation: ArrayLike | None = None,
        start: Given = None,
        hold: Sequence[str] = (),
        t: float | None = None,
        parameters: Given = None,
    ) -> Placement:
        """Inverse kinematics: coordinates `.q` that place the frame at `position` (3,) [m] with the matrix `rotation`
        (3, 3).

        Constraints are met, and coordinates keep within their `min` and `max`. The search goes out from `start`, a
        vector (nq,) or values by name, left out the start of the model, then from points about it, the same ones in
        every run. Coordinates in `hold` keep their start. `.converged` tells whether the place is reached, `.reason`
        what keeps the frame away. Raises ValueError, UnknownName, and CompilationFailed (E0867).
        """
        return self._place(self, (position, rotation), start, hold, t, parameters)

    def _by_names(self, state: State, start: Starts | None, inputs: Any, parameters: Any) -> State:
        found: State = self._own._by_names(state, start, inputs, parameters)
        return found

    def __repr__(self) -> str:
        return f"<FrameKinematics {self.name}>"

    def __reduce__(self) -> Any:
        return self._own.frame, (self.name,)


class ModelPoint(PointKinematics):
    """A point of a model."""

    def __init__(self, name: str, own: Any, calls: Mapping[str, Call], place: Place) -> None:
        super().__init__(name, own, calls)
        self._place = place

    def solve(
        self,
        *,
        position: ArrayLike,
        start: Given = None,
        hold: Sequence[str] = (),
        t: float | None = None,
        parameters: Given = None,
    ) -> Placement:
        """Inverse kinematics: coordinates `.q` that place the point at `position` (3,) [m]; the rest as for a frame."""
        return self._place(self, (position, None), start, hold, t, parameters)

    def _by_names(self, state: State, start: Starts | None, inputs: Any, parameters: Any) -> State:
        found: State = self._own._by_names(state, start, inputs, parameters)
        return found

    def __repr__(self) -> str:
        return f"<PointKinematics {self.name}>"

    def __reduce__(self) -> Any:
        return self._own.point, (self.name,)


def calls_at_one_state(engine: BatchEngine, row_factors: Floats) -> dict[str, Call]:
    """The calls of Interface: one state goes to C at once, everything else is broadcast."""
    weighted = bool(np.any(row_factors != 1.0))
    scales = {
        "multipliers": (np.multiply, row_factors),
        "constraint_jacobian": (np.divide, np.reshape(row_factors, (-1, 1))),
    }
    return {name: at_one_state(engine, name, scales.get(name) if weighted else None) for name in NAMED}


def at_one_state(engine: BatchEngine, name: str, scale: Any = None) -> Call:
    """The call of this name."""
    return _fast(engine, name, BROADCAST[name], scale)


def kinematic_calls_at_one_state(engine: BatchEngine, what: str) -> dict[str, Call]:
    """The same for the one frame or the one point that `engine` has the function `kinematics` of."""
    several = kinematic_calls(0, slice(0, 6 if what == "frame" else 3))
    names = [name for name in KINEMATICS if what == "frame" or name != "rotation"]
    return {name: _fast(engine, name, _over_states(engine, several[name])) for name in names}


def _over_states(engine: BatchEngine, call: Call) -> Call:
    def called(own: Values, *arguments: Any) -> Floats:
        return call(lambda *state: engine.evaluate_many("kinematics", *state_of(own, *state)), *arguments)

    return called


def _fast(engine: BatchEngine, name: str, broadcast: Call, scale: Any = None) -> Call:
    """Numbers and sequences of one state become arrays first; `broadcast` takes the rest."""
    needed = (Group.Q, Group.QDD) if name in WITH_ACCELERATIONS else (Group.Q,)
    kinds = [(ARGUMENT_NAMES[group], engine.layout.size(group), group in needed) for group in _VECTORS]

    def otherwise(own: Any, *arguments: Any) -> Floats:
        *given, out = arguments
        plain = _plain(kinds, *given)
        return broadcast(own, *arguments) if plain is None else call(own, *plain, out)

    call = engine.at_one_state(name, otherwise, scale)
    return broadcast if call is otherwise else call


def _plain(kinds: Sequence[tuple[str, int, bool]], t: Any, *vectors: Any) -> tuple[Any, ...] | None:
    """The arguments as a float and arrays of one state, None where they are not those of one, or entries by name;
    `kinds` are names, lengths, and what cannot be left out. Raises ValueError for what is no number or of a wrong
    length."""
    if any(isinstance(each, Mapping) for each in vectors):
        return None
    given = zip(kinds, vectors, strict=True)
    arrays = [
        whole_vector(name, each, length) if needed or each is not None else None
        for (name, length, needed), each in given
    ]
    time = real_numbers("t", t)
    if time.ndim or any(each is not None and each.ndim != 1 for each in arrays):
        return None
    return (float(time), *arrays)
