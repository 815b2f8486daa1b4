"""Motions that `inverse_dynamics` and `bias` ask about must have forces (E0528): they name coordinates and parameters,
no constraint acts on them, and the forces have no part in themselves."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.reached import reached
from lagdsl.language.flat.traversal import rewritten


def with_required_forces(flat: fm.FlatModel, sink: Sink) -> fm.FlatModel:
    """`flat` with the coordinates and parameters of its motions by their own names, not those of components that are
    bound to them."""
    names = _Names(flat)

    def rule(part: Any, inside: Callable[[Any], Any]) -> Any:
        if not isinstance(part, fx.Motion):
            return None
        coordinates = tuple(map(names.end, part.coordinates))
        made = fx.Motion(
            part.function,
            coordinates,
            tuple(names.variable(each) or inside(each) for each in part.positions),
            tuple(names.rate(each) or inside(each) for each in part.rates),
            inside(part.accelerations),
            tuple((names.end(name), inside(value)) for name, value in part.parameters),
            part.span,
        )
        names.motions.append((part, made))
        return made

    flat = rewritten(flat, rule)
    dependence = Dependence(flat)
    for written, motion in names.motions:
        fault = names.fault(written, motion) or _held(flat, motion, dependence)
        if fault is not None:
            reason, way = fault
            sink.report("E0528", motion.span, function=motion.function, reason=reason, help=way)
    if not sink.has_errors:
        _check_circle(flat, sink)
    return flat


_Fault = tuple[str, str]
"""A reason and a way out."""


class _Names:
    """Coordinates and parameters behind names that are bound to them."""

    def __init__(self, flat: fm.FlatModel) -> None:
        self.motions: list[tuple[fx.Motion, fx.Motion]] = []
        self._bound = {item.name: item.value for item in flat.named if isinstance(item, fm.Definition)}
        self._coordinates = {item.name for item in flat.coordinates}
        self._parameters = {item.name for item in flat.parameters if not item.structural}

    def end(self, name: str) -> str:
        value = self._bound.get(name)
        while isinstance(value, fx.Variable):
            name = value.name
            value = self._bound.get(name)
        return name

    def variable(self, expression: fx.FlatExpression) -> fx.Variable | None:
        """The variable itself that an expression is by another name."""
        return fx.Variable(self.end(expression.name)) if isinstance(expression, fx.Variable) else None

    def rate(self, expression: fx.FlatExpression) -> fx.Derivative | None:
        found = self.variable(expression.operand) if isinstance(expression, fx.Derivative) else None
        return None if found is None else fx.Derivative(found)

    def fault(self, written: fx.Motion, motion: fx.Motion) -> _Fault | None:
        for name, end in zip(written.coordinates, motion.coordinates, strict=True):
            if end not in self._coordinates:
                way = "name coordinates of the equations of motion, which `lag check` lists"
                return f"`{name}` is no coordinate of the equations", way
        for (name, _), (end, _) in zip(written.parameters, motion.parameters, strict=True):
            if end not in self._parameters:
                way = "name parameters of the model that are neither structural nor computed from others"
                return f"`{name}` is no parameter whose value may be changed", way
        for names in (motion.coordinates, tuple(name for name, _ in motion.parameters)):
            twice = next((name for name in names if names.count(name) > 1), None)
            if twice is not None:
                return f"`{twice}` is given twice", "keep one of the two"
        return None


def _held(flat: fm.FlatModel, motion: fx.Motion, dependence: Dependence) -> _Fault | None:
    """A constraint on the coordinates of a motion: forces share in its reactions in many ways."""
    if motion.function == "bias":
        return None
    for constraint in flat.constraints:
        orders = dependence.of_all(constraint.residuals) if not constraint.of_law else ()
        name = next((name for name in motion.coordinates if name in orders), None)
        if name is not None:
            reason = f"the constraint `{constraint.name}` holds `{name}`, so that its reactions share in the force"
            way = "describe the motion by independent coordinates; `bias` gives the forces without reactions"
            return reason, way
    return None


def _check_circle(flat: fm.FlatModel, sink: Sink) -> None:
    """E0528 where a mass, a body or an energy reads a force that it has a part in."""
    rates = {state.name: state.derivative for state in flat.states}
    roots = [*(term.value for term in flat.energies), *([flat.gravity] if flat.gravity is not None else [])]
    roots += [x for mass in flat.masses for x in (mass.mass, mass.position)]
    roots += [x for body in flat.bodies for x in (fx.FrameOrigin(body.frame), body.mass, *body.com, *body.inertia)]
    seen: set[str] = set()
    while roots:
        further: list[fx.FlatExpression] = []
        for node in reached(flat, roots):
            if isinstance(node, fx.RequiredForce):
                motion = node.motion
                reason = "masses and energies depend on its value, from which it is computed"
                way = "let the value enter by loads only: `torque tau on q;`"
                sink.report("E0528", motion.span, function=motion.function, reason=reason, help=way)
                return
            if isinstance(node, fx.Variable) and node.name in rates and node.name not in seen:
                seen.add(node.name)
                further.append(rates[node.name])
        roots = further
