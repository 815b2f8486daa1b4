"""Statements about coordinates: joints that imitate others, springs, dampers, rotors, friction, stops, weights."""

from __future__ import annotations

from collections.abc import Iterator

from lagdsl.exchange.model_text.numbers import array, number, quantity
from lagdsl.exchange.robots.description import ZERO, Joint, Link, Mimic
from lagdsl.exchange.robots.plan import COORDINATES, Plan, coordinate_of, frame_of, is_body

_AXES = "xyz"


def energies(plan: Plan) -> list[str]:
    """Rotors, springs, dampers, and bodies whose moments no body has."""
    found = [line for link in plan.robot.links if is_body(plan, link) for line in _moments(plan, link)]
    for joint in plan.robot.every_joint:
        if joint.kind in COORDINATES:
            found += _energies(joint, coordinate_of(plan, joint))
        else:
            found += _energies_in_space(joint, plan.joints[joint.name])
    return found


def lifts(plan: Plan) -> list[str]:
    """Forces that carry the weight of links, or a share of it."""
    found = []
    gravity = plan.robot.gravity or ZERO
    for link in plan.robot.links:
        if link.lift and is_body(plan, link) and link.inertial is not None and link.inertial.mass and any(gravity):
            force = array(quantity(-link.lift * link.inertial.mass * part, "N") for part in gravity)
            frame = frame_of(plan, link)
            place = f"{frame}.point({plan.links[link.name]}.com)" if any(link.inertial.com) else frame
            found.append(f"force {force} at {place};")
    return found


def acting(plan: Plan) -> list[str]:
    """Joints that imitate others, dry friction, stops."""
    of = {joint.name: joint for joint in plan.robot.every_joint}
    found = []
    for joint in _moved(plan):
        name, coordinate = plan.joints[joint.name], coordinate_of(plan, joint)
        if joint.mimic is not None:
            value = _imitated(plan, joint, of[joint.mimic.joint], joint.mimic)
            found.append(f"constraint {plan.parts[name, 'gear']}: {coordinate} = {value};")
        if joint.passive.friction:
            effort = "N" if joint.kind == "prismatic" else "N.m"
            found.append(friction(plan.parts[name, "friction"], coordinate, joint.passive.friction, effort))
        if plan.style.limits == "contact":
            found += _stops(plan, joint, name, coordinate)
    return found


def _moved(plan: Plan) -> Iterator[Joint]:
    return (joint for joint in plan.robot.every_joint if joint.kind in COORDINATES)


def _moments(plan: Plan, link: Link) -> Iterator[str]:
    """The kinetic energy of moments that a `body` cannot have: w I w/2, in the axes of the link."""
    inertial = link.inertial
    if inertial is None or inertial.is_possible:
        return
    frame = frame_of(plan, link)
    rates = [f"(omega({frame})*{frame}.{axis})" for axis in _AXES]
    pairs = [(0, 0, 0.5), (1, 1, 0.5), (2, 2, 0.5), (0, 1, 1.0), (0, 2, 1.0), (1, 2, 1.0)]
    terms = [
        f"{quantity(factor * entry, 'kg.m2')}*{rates[i]}" + ("^2" if i == j else f"*{rates[j]}")
        for (i, j, factor), entry in zip(pairs, inertial.inertia, strict=True)
        if entry
    ]
    yield f"kinetic {sum_of(terms)};"


def _energies(joint: Joint, coordinate: str) -> Iterator[str]:
    turns, passive = joint.kind != "prismatic", joint.passive
    if passive.armature:
        yield f"kinetic 1/2*{quantity(passive.armature, 'kg.m2' if turns else 'kg')}*der({coordinate})^2;"
    if passive.stiffness:
        way = difference(coordinate, quantity(passive.rest, "rad" if turns else "m"))
        yield f"potential 1/2*{quantity(passive.stiffness, 'N.m/rad' if turns else 'N/m')}*{way}^2;"
    if passive.damping:
        yield f"dissipation 1/2*{quantity(passive.damping, 'N.m.s/rad' if turns else 'N.s/m')}*der({coordinate})^2;"


def _energies_in_space(joint: Joint, name: str) -> Iterator[str]:
    """Armature and damping of balls and free joints: the square of the angular velocity is four times that of the rate
    of the unit quaternion."""
    square, way = f"(der({name}.e)*der({name}.e))", f"(der({name}.r)*der({name}.r))"
    slides = joint.kind == "floating"
    if joint.kind not in ("spherical", "floating"):
        return
    if joint.passive.armature:
        yield f"kinetic 2*{quantity(joint.passive.armature, 'kg.m2')}*{square};"
        if slides:
            yield f"kinetic 1/2*{quantity(joint.passive.armature, 'kg')}*{way};"
    if joint.passive.damping:
        yield f"dissipation 2*{quantity(joint.passive.damping, 'N.m.s/rad')}*{square};"
        if slides:
            yield f"dissipation 1/2*{quantity(joint.passive.damping, 'N.s/m')}*{way};"


def _imitated(plan: Plan, joint: Joint, leader: Joint, mimic: Mimic) -> str:
    """`2*elbow.q + 0.1 rad`; a factor between an angle and a length has a unit."""
    own, other = unit_of(joint), unit_of(leader)
    name = coordinate_of(plan, leader)
    if own != other:
        term = f"{quantity(mimic.multiplier, f'{own}/{other}')}*{name}"
    else:
        term = {1.0: name, -1.0: f"-{name}"}.get(mimic.multiplier, f"{number(mimic.multiplier)}*{name}")
    terms = [] if mimic.multiplier == 0.0 else [term]
    if mimic.offset or not terms:
        terms.append(quantity(mimic.offset, own))
    return sum_of(terms)


def friction(name: str, along: str, limit: float, unit: str) -> str:
    """Dry friction along the rate of a coordinate or a length whose effort has this unit."""
    return f"friction {name}: der({along}) with limit = {quantity(limit, unit)};"


def _stops(plan: Plan, joint: Joint, name: str, coordinate: str) -> Iterator[str]:
    """Contacts without bounce at the limits."""
    unit = unit_of(joint)
    if joint.limits.lower is not None:
        gap = difference(coordinate, quantity(joint.limits.lower, unit)).strip("()")
        yield f"contact {plan.parts[name, 'lower']}: {gap} >= 0 with restitution = 0;"
    if joint.limits.upper is not None:
        gap = sum_of([quantity(joint.limits.upper, unit), f"-{coordinate}"]) if joint.limits.upper else f"-{coordinate}"
        yield f"contact {plan.parts[name, 'upper']}: {gap} >= 0 with restitution = 0;"


def unit_of(joint: Joint) -> str:
    """Unit of the one coordinate of a joint."""
    return "m" if joint.kind == "prismatic" else "rad"


def difference(left: str, right: str) -> str:
    """`(left - right)`, or `left` alone."""
    return left if right == "0" else f"({sum_of([left, right[1:] if right.startswith('-') else f'-{right}'])})"


def sum_of(terms: list[str]) -> str:
    text = terms[0]
    for term in terms[1:]:
        text += f" - {term[1:]}" if term.startswith("-") else f" + {term}"
    return text
