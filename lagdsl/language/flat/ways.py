"""Ways of masses: places, orientations and other quantities that a motion changes continuously, as the
kinetic energy has their rates."""

from __future__ import annotations

from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.reached import reached


def ways(flat: fm.FlatModel) -> list[fx.FlatExpression]:
    """Positions of masses and bodies, and what the kinetic energy differentiates."""
    places = [mass.position for mass in flat.masses] + [fx.FrameOrigin(body.frame) for body in flat.bodies]
    return [*places, *differentiated(flat)]


def positions(flat: fm.FlatModel) -> list[fx.FlatExpression]:
    """Vectors: positions of masses, origins and axes of the frames of bodies."""
    axes = [fx.FrameAxis(body.frame, axis) for body in flat.bodies for axis in range(3)]
    return [*(mass.position for mass in flat.masses), *(fx.FrameOrigin(body.frame) for body in flat.bodies), *axes]


def differentiated(flat: fm.FlatModel) -> list[fx.FlatExpression]:
    """Arguments of `der` in the kinetic energy and in terms of the Lagrangian, scalars and vectors."""
    terms = [term.value for term in flat.energies if term.kind in ("kinetic", "lagrangian")]
    return [x.operand for x in reached(flat, terms) if isinstance(x, fx.Derivative)]


def held(flat: fm.FlatModel) -> list[fx.FlatExpression]:
    """Residuals of constraints of position level, without those of contacts."""
    return [x for each in flat.constraints if each.level == "position" and not each.contact for x in each.residuals]
