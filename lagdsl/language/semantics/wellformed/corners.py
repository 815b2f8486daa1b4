"""Kinks of functions along the motion, such as that of `abs(x)` at x = 0: in the text they are corners.

At a corner of a force, an energy, a constraint or a gap a step ends (`with_corners`). At a corner in the position of
a mass, in a constraint or in a gap velocities jump: a bead on the track `y = abs(x)` meets one. The balance of momenta
does not determine this jump, which depends on the materials of bead and track. The simulation takes the limit of a
rounded corner, which conserves the energy (`docs/adr/0017`). So the branches of such a function become relations
(`over_which_velocities_jump`), and the model is warned (`check_corners`, W0520).
"""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.foundation.diagnostics import Sink
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.events import Relation
from lagdsl.language.flat.reached import reached, switch
from lagdsl.language.flat.ways import held, ways


def check_corners(flat: fm.FlatModel, dependence: Dependence, sink: Sink) -> None:
    """W0520 for each relation of the motion, written or of a function, over which velocities jump."""
    branching = _relations_of_the_motion(flat, dependence)
    if not branching:
        return
    rows = held(flat)
    for what, roots, relations in (
        ("velocities of masses", ways(flat), branching),
        ("velocities", rows, _without_switches(rows, branching)),
    ):
        for name in dict.fromkeys(x.name for x in reached(flat, roots) if isinstance(x, fx.Variable)):
            if name in relations:
                span = relations[name].spans[0]
                sink.report("W0520", span, name=span.text, what=what)


def _without_switches(roots: Sequence[fx.FlatExpression], branching: dict[str, Relation]) -> dict[str, Relation]:
    """Without relations that switch a constraint on and off: `(if l > l0 then l - l0 else 0) = 0`."""
    switches = [found for found in map(switch, roots) if found is not None]
    off = {each.condition.name for each in switches if isinstance(each.condition, fx.Variable)}
    return {name: each for name, each in branching.items() if name not in off}


def check_changing_inertia(flat: fm.FlatModel, dependence: Dependence, sink: Sink) -> None:
    """N0521 for each discrete variable of which the kinetic energy is made: what is kept where it changes."""
    if not flat.events.discretes:
        return
    inertias = [term.value for term in flat.energies if term.kind == "kinetic"]
    inertias += [mass.mass for mass in flat.masses]
    inertias += [x for body in flat.bodies for x in (body.mass, *body.com, *body.inertia)]
    found = dependence.of_all(inertias)
    for discrete in flat.events.discretes:
        if discrete.name in found:
            sink.report("N0521", discrete.spans[0], name=discrete.name)


def _relations_of_the_motion(flat: fm.FlatModel, dependence: Dependence) -> dict[str, Relation]:
    """Relations that coordinates or states turn, by name."""
    moving = {item.name for item in (*flat.coordinates, *flat.states)}
    return {
        each.name: each
        for each in flat.events.relations
        if each.spans and not moving.isdisjoint(dependence.of(each.difference))
    }
