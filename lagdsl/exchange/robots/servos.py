"""Statements of servos and tendons: inputs, what they act on, equations of activations."""

from __future__ import annotations

from collections.abc import Iterator

from lagdsl.exchange.model_text.numbers import number, quantity
from lagdsl.exchange.robots.description import Affine, Bounds, Joint, Tendon, Way
from lagdsl.exchange.robots.plan import NamedServo, Plan, coordinate_of
from lagdsl.exchange.robots.relations import difference, friction, sum_of


def servo_inputs(plan: Plan) -> Iterator[str]:
    """An input for each servo, of the kind of what it controls."""
    for named in plan.servos:
        control = named.servo.control
        parts = [f"min = {number(control.low)}"] if control.low is not None else []
        parts += [f"max = {number(control.high)}"] if control.high is not None else []
        attributes = f"({', '.join(parts)})" if parts else ""
        yield f"input {_input_type(plan, named)} {named.input}{attributes};"


def tendons(plan: Plan) -> Iterator[str]:
    """Lengths, springs, dampers, dry friction, inertia and limits of tendons."""
    for name, tendon in plan.tendons:
        unit = unit_along(plan, tendon.way)
        yield f"{_type(unit)} {name} = {_combination(plan, tendon.way)};"
        yield from _springs(name, tendon, unit)
        effort = _effort_unit(unit)
        if tendon.damping:
            yield f"dissipation 1/2*{quantity(tendon.damping, f'{effort}.s/{unit}')}*der({name})^2;"
        if tendon.friction:
            yield friction(plan.parts[name, "friction"], name, tendon.friction, effort)
        if tendon.armature:
            yield f"kinetic 1/2*{quantity(tendon.armature, 'kg.m2' if unit == 'rad' else 'kg')}*der({name})^2;"
        yield from _limits(plan, name, tendon.limits, unit)


def servos(plan: Plan) -> Iterator[str]:
    """Forces of servos, with the variables that they need."""
    of = {joint.name: joint for joint in plan.robot.every_joint}
    for named in plan.servos:
        servo, unit = named.servo, unit_along(plan, named.servo.way)
        if servo.activation != "none":
            yield f"state {_activation_type(plan, named)} {named.activation};"
        sees_length = any((*servo.gain[1:], *servo.bias[1:]))
        if len(servo.way) > 1 and sees_length:
            yield f"{_type(unit)} {named.length} = {_combination(plan, servo.way)};"
        force = _bounded(_force(plan, named), servo.force, _effort_unit(unit))
        if len(servo.way) > 1 or servo.way[0][1] != 1.0:
            yield f"{'Torque' if unit == 'rad' else 'Force'} {named.effort} = {force};"
            force = named.effort
        for name, factor in servo.way:
            load = _times(_factor(of[name], factor, unit), force)
            yield f"{_load(of[name])} {load} on {coordinate_of(plan, of[name])};"


def activations(plan: Plan) -> list[str]:
    """The equations of states of servos."""
    found = []
    for named in plan.servos:
        state, servo = named.activation, named.servo
        if servo.activation == "filter":
            found.append(f"der({state}) = ({named.input} - {state})/({quantity(servo.lag, 's')});")
        elif servo.activation == "integrator":
            is_rate = _input_type(plan, named) != "Real"
            found.append(f"der({state}) = {named.input}{'' if is_rate else '/(1 s)'};")
    return ["equation", *found] if found else []


# ---- forces ----------------------------------------------------------------------------------------------------------


def _force(plan: Plan, named: NamedServo) -> str:
    """gain x activation + bias; with the opposite factor of the length or of its rate as gain times a difference."""
    servo, unit = named.servo, unit_along(plan, named.servo.way)
    effort, length, rate = _effort_unit(unit), *_motion(plan, named)
    signal = named.input if servo.activation == "none" else named.activation
    constant, by_length, by_rate = servo.bias
    terms = []
    if _controls_length(servo.gain, servo.bias):
        terms.append(f"{quantity(servo.gain[0], f'{effort}/{unit}')}*{difference(signal, length)}")
        by_length = 0.0
    elif _controls_rate(servo.gain, servo.bias):
        terms.append(f"{quantity(servo.gain[0], f'{effort}.s/{unit}')}*{difference(signal, rate)}")
        by_rate = 0.0
    else:
        gains = _affine(servo.gain, effort, unit, length, rate)
        terms += [f"({sum_of(gains)})*{signal}" if len(gains) > 1 else f"{gains[0]}*{signal}"] if gains else []
    terms += _affine((constant, by_length, by_rate), effort, unit, length, rate)
    return sum_of(terms) if terms else "0"


def _affine(numbers: Affine, effort: str, unit: str, length: str, rate: str) -> list[str]:
    constant, by_length, by_rate = numbers
    found = [quantity(constant, effort)] if constant else []
    found += [f"{quantity(by_length, f'{effort}/{unit}')}*{length}"] if by_length else []
    return found + ([f"{quantity(by_rate, f'{effort}.s/{unit}')}*{rate}"] if by_rate else [])


def _controls_length(gain: Affine, bias: Affine) -> bool:
    return gain[0] != 0.0 and gain[1:] == (0.0, 0.0) and bias[1] == -gain[0]


def _controls_rate(gain: Affine, bias: Affine) -> bool:
    return gain[0] != 0.0 and gain[1:] == (0.0, 0.0) and bias[1] == 0.0 and bias[2] == -gain[0]


def _bounded(force: str, bounds: Bounds, unit: str) -> str:
    if bounds.high is not None:
        force = f"min({force}, {quantity(bounds.high, unit)})"
    return force if bounds.low is None else f"max({force}, {quantity(bounds.low, unit)})"


def _input_type(plan: Plan, named: NamedServo) -> str:
    turns = unit_along(plan, named.servo.way) == "rad"
    if _controls_length(named.servo.gain, named.servo.bias):
        if named.servo.activation == "integrator":
            return "AngularVelocity" if turns else "Velocity"
        return "Angle" if turns else "Length"
    if _controls_rate(named.servo.gain, named.servo.bias) and named.servo.activation != "integrator":
        return "AngularVelocity" if turns else "Velocity"
    return "Real"


def _activation_type(plan: Plan, named: NamedServo) -> str:
    """That of the input, or of its integral."""
    turns = unit_along(plan, named.servo.way) == "rad"
    if _controls_length(named.servo.gain, named.servo.bias):
        return "Angle" if turns else "Length"
    return _input_type(plan, named)


# ---- lengths ---------------------------------------------------------------------------------------------------------


def _springs(name: str, tendon: Tendon, unit: str) -> Iterator[str]:
    """A spring whose length at rest is a number, or is free between two."""
    stiffness, (low, high) = quantity(tendon.stiffness, f"{_effort_unit(unit)}/{unit}"), tendon.slack
    if not tendon.stiffness:
        return
    if low == high:
        yield f"potential 1/2*{stiffness}*{difference(name, quantity(low, unit))}^2;"
        return
    yield f"potential 1/2*{stiffness}*max({_bare(difference(name, quantity(high, unit)))}, 0)^2;"
    yield f"potential 1/2*{stiffness}*max({sum_of([quantity(low, unit), f'-{name}']) if low else f'-{name}'}, 0)^2;"


def _limits(plan: Plan, name: str, limits: Bounds, unit: str) -> Iterator[str]:
    """Contacts without bounce, or the limits of an output."""
    if limits.low is None or limits.high is None:
        return
    if plan.style.limits == "contact":
        gap = _bare(difference(name, quantity(limits.low, unit)))
        yield f"contact {plan.parts[name, 'lower']}: {gap} >= 0 with restitution = 0;"
        gap = sum_of([quantity(limits.high, unit), f"-{name}"]) if limits.high else f"-{name}"
        yield f"contact {plan.parts[name, 'upper']}: {gap} >= 0 with restitution = 0;"
    elif plan.style.limits == "range":
        ends = f"min = {number(limits.low)}, max = {number(limits.high)}"
        yield f"output {_type(unit)} {plan.parts[name, 'within']}({ends}) = {name};"


def _motion(plan: Plan, named: NamedServo) -> tuple[str, str]:
    """Length and rate that a servo sees."""
    way = named.servo.way
    if len(way) > 1:
        return named.length, f"der({named.length})"
    joints = {joint.name: joint for joint in plan.robot.every_joint}
    ((name, factor),) = way
    coordinate = coordinate_of(plan, joints[name])
    return _times(_plain(factor), coordinate), _times(_plain(factor), f"der({coordinate})")


def _combination(plan: Plan, way: Way) -> str:
    of = {joint.name: joint for joint in plan.robot.every_joint}
    unit = unit_along(plan, way)
    terms = [_times(_factor(of[name], factor, unit), coordinate_of(plan, of[name])) for name, factor in way if factor]
    return sum_of(terms) if terms else "0"


def _factor(joint: Joint, factor: float, unit: str) -> str:
    """Of an angle in a length in meters it has a unit."""
    return f"{number(factor)} m/rad" if joint.kind == "revolute" and unit == "m" else _plain(factor)


def _plain(factor: float) -> str:
    return "" if factor == 1.0 else number(factor)


def _bare(text: str) -> str:
    return text.removeprefix("(").removesuffix(")") if text.startswith("(") else text


def _times(factor: str, text: str) -> str:
    return f"{factor}*{text}" if factor else text


def unit_along(plan: Plan, way: Way) -> str:
    """Radians where all joints turn, else meters."""
    kinds = {joint.name: joint.kind for joint in plan.robot.every_joint}
    return "rad" if all(kinds[name] == "revolute" for name, _ in way) else "m"


def _type(unit: str) -> str:
    return "Angle" if unit == "rad" else "Length"


def _effort_unit(unit: str) -> str:
    return "N.m" if unit == "rad" else "N"


def _load(joint: Joint) -> str:
    return "torque" if joint.kind == "revolute" else "force"
