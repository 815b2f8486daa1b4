"""Functions by name that controllers call: terms of the equations, the regressor, frames and points."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, cached_property, partial
from typing import TYPE_CHECKING, Any

from lagdsl.engines.backends.python.support.values import EVALUATED
from lagdsl.foundation.diagnostics.unknown import unknown_among
from lagdsl.interfaces.api.described import Described
from lagdsl.interfaces.api.one_state import ModelFrame, ModelPoint, at_one_state, kinematic_calls_at_one_state
from lagdsl.language.flat.listing import frame_names, point_names

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from lagdsl.derivation.program.program import Program
    from lagdsl.engines.backends.python.support.kinematics import PointKinematics
    from lagdsl.engines.backends.python.support.values import Call, Evaluate
    from lagdsl.engines.runtime.engines.broadcast import BatchEngine
    from lagdsl.interfaces.api.names import Given
    from lagdsl.motion.analysis.base_parameters import BaseParameters
    from lagdsl.motion.analysis.inverse_kinematics import Placement

_TERMS = ("equation_terms", "regressor")


class ByName(Described):
    """A model whose terms, frames and points are called by name. Their functions are made when they are first asked
    for."""

    _engine: BatchEngine

    def _choosing(self, evaluate: Evaluate) -> Evaluate:
        """`evaluate`, but for the functions that are made when they are first asked for."""

        def chosen(function: str, *arguments: Any) -> Any:
            own = self._terms(function).evaluate_many if function in _TERMS else evaluate
            return own(function, *arguments)

        return chosen

    @property
    def frames(self) -> list[str]:
        """Names of all frames, for `frame`."""
        return frame_names(self._compilation.flat)

    @property
    def points(self) -> list[str]:
        """Names of all points, for `point`."""
        return point_names(self._compilation.flat)

    def frame(self, name: str) -> ModelFrame:
        """The motion of a frame: `.position .rotation .velocity .jacobian .bias_acceleration` of t, q, qd.
        `.solve` places it.

        `name` is one of `frames`, or a component that has one frame only. Raises UnknownName.
        """
        own = _own_name("frame", name, self.frames)
        return ModelFrame(own, self, self._kinematic_calls("frame", own), self._placed)

    def point(self, name: str) -> ModelPoint:
        """The motion of a point: `.position .velocity .jacobian .bias_acceleration` of t, q, qd. `.solve` places
        it.

        `name` is one of `points`, or a component that has one point only. Raises UnknownName.
        """
        own = _own_name("point", name, self.points)
        return ModelPoint(own, self, self._kinematic_calls("point", own), self._placed)

    def _placed(
        self,
        part: PointKinematics,
        target: tuple[ArrayLike | None, ArrayLike | None],
        start: Given,
        hold: Sequence[str],
        t: float | None,
        parameters: Given,
    ) -> Placement:
        from lagdsl.interfaces.api.inverse_kinematics import placed
        from lagdsl.motion.analysis.point import System

        system = System(self._compilation.flat, self._compilation.program, self._engine)
        starts = self._named("start")
        coordinates = {name: starts[name] for name in self.coordinates}
        return placed(system, part, target, self._parameter_vector(parameters), (coordinates, start, hold), t)

    @property
    def inertial_parameter_names(self) -> list[str]:
        """Names of the entries of `inertial_parameters`: `arm.m`, its first moments `arm.hx`, `arm.hy`, `arm.hz` and
        its inertia about the origin of its frame, `arm.Ixx` to `arm.Iyz` (tensor elements, in its axes). Behind them
        stand coefficients of friction: `damping(q)`, `damping(q, s)` of two coordinates, `limit(f)` of `friction f`."""
        return [slot.name for slot in self._terms("regressor").layout.inertial]

    @cached_property
    def base_parameters(self) -> BaseParameters:
        """The combinations of these parameters that the equations of motion can tell apart."""
        from lagdsl.motion.analysis.base_parameters import base_parameters

        sizes = len(self.coordinates)
        return base_parameters(partial(self.regressor, 0.0), sizes, self.inertial_parameter_names)

    @cached_property
    def _kinematic_calls(self) -> Callable[[str, str], dict[str, Call]]:
        from lagdsl.derivation.mechanics.by_name import with_kinematics

        equations, program = self._compilation.equations, self._compilation.program

        @cache
        def made(what: str, name: str) -> dict[str, Call]:
            frames, points = ((name,), ()) if what == "frame" else ((), (name,))
            engine = self._engine_of(with_kinematics(equations, program, frames, points))
            return kinematic_calls_at_one_state(engine, what)

        return made

    @cached_property
    def _terms(self) -> Callable[[str], BatchEngine]:
        from lagdsl.derivation.mechanics.by_name import with_equation_terms, with_regressor

        equations, program = self._compilation.equations, self._compilation.program

        @cache
        def made(function: str) -> BatchEngine:
            extended = with_equation_terms if function == "equation_terms" else with_regressor
            return self._engine_of(extended(equations, program))

        return made

    def _engine_of(self, program: Program) -> BatchEngine:
        from lagdsl.engines.runtime.engines.selection import engine_of

        return engine_of(program, self._engine.name)


def calls_of_terms() -> dict[str, Call]:
    """The calls of Interface whose functions are made when they are first asked for."""
    return {name: _made_when_asked(name) for name, (function, _) in EVALUATED.items() if function in _TERMS}


def _made_when_asked(name: str) -> Call:
    made: list[Call] = []

    def call(own: ByName, *arguments: Any) -> Any:
        if not made:
            made.append(at_one_state(own._terms(EVALUATED[name][0]), name))
        return made[0](own, *arguments)

    return call


def _own_name(what: str, name: str, names: list[str]) -> str:
    """The one of `names` that is called so, or that is the only one of a component. Raises UnknownName."""
    if name in names:
        return name
    inside = [each for each in names if each.rpartition(".")[0] == name]
    if len(inside) == 1:
        return inside[0]
    raise unknown_among(what, name, inside or names)
