"""A model as the page integrates it: its scene among its outputs, its start values among its parameters."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from lagdsl.derivation.scene.circuits import circuits
from lagdsl.derivation.scene.drawings import drawn, is_mass_centre, is_symbol
from lagdsl.derivation.scene.links import arms, rods, ropes, springs
from lagdsl.derivation.scene.looks import dressed
from lagdsl.derivation.scene.machine import Machine, up_of
from lagdsl.derivation.scene.masses import bodies, have_inertia, levers, masses
from lagdsl.derivation.scene.shapes import Scene, scene_with
from lagdsl.derivation.scene.surroundings import frames, gauges, grounds, is_planar, loads, supports, tracks
from lagdsl.foundation.record import record
from lagdsl.foundation.units.dimension import DIMENSIONLESS, TIME
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat import model as fm
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.evaluate import Evaluator, Values

START = ".start"
"""Ending of the name of the parameter that is the start value of a coordinate."""


@record(kw_only=True)
class Living:
    """`flat` is the model with further outputs, `scene[1]`, ..., and further parameters, `theta.start`."""

    flat: fm.FlatModel
    scene: Scene


def living(flat: fm.FlatModel, starts: Collection[str] = ()) -> Living:
    """The model with its scene. Start values that depend on parameters stay so, but for those named in `starts`
    and those with a slider."""
    return with_scene(flat, scene_of(flat), starts)


def with_scene(flat: fm.FlatModel, scene: Scene, starts: Collection[str] = ()) -> Living:
    """The model with these columns among its outputs, and its start values among its parameters."""
    outputs = (
        fm.Output(name=f"scene[{k}]", dimension=DIMENSIONLESS, value=value, spans=())
        for k, value in enumerate(scene.columns, 1)
    )
    coordinates, own = _starts_as_parameters(flat, {*starts, *flat.page.sliders})
    whole = (*flat.outputs, *outputs)
    changed = replace(flat, outputs=whole, coordinates=coordinates, parameters=(*flat.parameters, *own))
    return Living(flat=changed, scene=scene)


def scene_of(flat: fm.FlatModel) -> Scene:
    """Shapes of the drawings, then those that the rules add. Meshes show the links themselves: symbols of joints and
    massless arms would stand in them. The ellipsoid of inertia says more than the symbol of a mass centre."""
    has_meshes = any(drawing.shape == "mesh" for drawing in flat.drawings)
    centres = [] if has_meshes else [drawing for drawing in flat.drawings if is_mass_centre(drawing)]
    if has_meshes:
        seen = [drawing for drawing in flat.drawings if not is_symbol(drawing)]
    else:
        ellipsoids = have_inertia(flat)
        seen = [each for each in flat.drawings if not (each in centres and each.spans[1:] in ellipsoids)]
        flat = replace(flat, drawings=tuple(seen))
    machine = Machine(flat)
    shapes = [drawn(each) for each in seen if not is_symbol(each) or not machine.is_hidden(each)]
    shapes += levers(machine, centres)
    for rule in (masses, bodies, springs, ropes, rods, arms, grounds, tracks, loads):
        if not (has_meshes and rule is arms):
            shapes += rule(machine)
    shapes += [*gauges(machine, shapes), *frames(machine)]
    planar = is_planar(machine, shapes)
    up = up_of(flat, planar=planar)
    solid = dressed(shapes, planar)
    solid += dressed(supports(machine, solid, up if machine.down is None else -machine.down), planar)
    diagram = circuits(machine, scene_with(solid, planar=planar), up)
    return scene_with((*solid, *diagram), planar=planar)


def _starts_as_parameters(
    flat: fm.FlatModel, chosen: Collection[str]
) -> tuple[tuple[fm.Coordinate, ...], list[fm.Parameter]]:
    """Start values of positions and rates that depend on no parameter, and the chosen ones."""
    dependence, at = Dependence(flat), Evaluator(flat, Values())
    coordinates, found = [], []
    for item in flat.coordinates:
        starts: dict[str, fx.FlatExpression] = {"start": item.start, "rate_start": item.rate_start}
        for field, value in starts.items():
            name = item.name if field == "start" else f"der({item.name})"
            if name in chosen or not dependence.of(value):
                found.append(_parameter(item, name, at.scalar(value)))
                starts[field] = fx.Variable(name + START)
        coordinates.append(replace(item, **starts))  # type: ignore[arg-type]
    return tuple(coordinates), found


def _parameter(item: fm.Coordinate, name: str, value: float) -> fm.Parameter:
    """The start value of a coordinate, or of its rate by another name."""
    own = name == item.name
    return fm.Parameter(
        name=name + START,
        dimension=item.dimension if own else item.dimension / TIME,
        unit=item.unit if own else f"{item.unit}/s",
        display_unit=item.display_unit if own or item.display_unit is None else f"{item.display_unit}/s",
        doc=item.doc,
        type_name=item.type_name if own else "Real",
        value=value,
        minimum=item.minimum if own else None,
        maximum=item.maximum if own else None,
        spans=item.spans,
    )
