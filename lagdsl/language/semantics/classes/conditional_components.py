"""Components under a condition of parameters: what they add to energies, loads and masses is switched, nothing else."""

from __future__ import annotations

from lagdsl.language.semantics.scope.contents import Contents
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.scope import Instance, Symbol
from lagdsl.language.syntax import nodes

_MOTION = {"coordinate": "coordinates", "state": "states"}
_ITEMS: dict[type, str] = {
    nodes.Constraint: "a constraint",
    nodes.Gravity: "gravity",
    nodes.Invariant: "an invariant",
    nodes.CallEquation: "an assertion",
    nodes.Contact: "a contact",
    nodes.Friction: "friction",
    nodes.When: "a `when`",
}


def check_switched(ctx: Context, contents: Contents) -> None:
    """E0330 where such a component would change the number of equations."""
    for instance in contents.instances:
        if instance.conditions:
            for member in instance.members:
                if isinstance(member, Symbol) and member.kind in _MOTION:
                    _report(ctx, instance, _MOTION[member.kind])
    for placed in contents.items:
        if placed.instance.conditions and type(placed.node) in _ITEMS:
            _report(ctx, placed.instance, _ITEMS[type(placed.node)])
    listed = (
        (contents.kinematics, "kinematics"),
        (contents.closure, "kinematics"),
        (contents.connects, "a `connect`"),
        (contents.initial, "initial equations"),
    )
    for found, what in listed:
        for placed in found:
            if placed.instance.conditions:
                _report(ctx, placed.instance, what)


def _report(ctx: Context, instance: Instance, what: str) -> None:
    if instance.around is not None:
        with ctx.current.inside(instance.around):
            ctx.sink.report("E0330", instance.conditions[-1][1], what=f"a component with {what}")
