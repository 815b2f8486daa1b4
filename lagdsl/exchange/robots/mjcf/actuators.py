"""Actuators and tendons of a model that MuJoCo has read: https://mujoco.readthedocs.io/en/stable/computation/index.html."""

from __future__ import annotations

import math
from collections import Counter
from typing import Any, Literal

import numpy as np

from lagdsl.exchange.robots.description import Actuator, Affine, Bounds, Joint, Servo, Tendon, Way
from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.mjcf.parts import Places
from lagdsl.foundation.source import Span

_MOTIONS = ("revolute", "prismatic")
ACTUATORS = frozenset(
    {"motor", "position", "velocity", "intvelocity", "damper", "cylinder", "muscle", "adhesion", "dcmotor"}
    | {"general", "plugin"}
)
_LEFT_OUT = "it is left out"
_FILTER: Literal["filter"] = "filter"


def tendons_of(places: Places, joints: list[Joint], tied: set[int], findings: Findings) -> list[Tendon]:
    """Fixed tendons that act by themselves, have limits or are `tied`; E1016 for others that do or are."""
    model, found = places.model, []
    for index in range(model.ntendon):
        stiffness, damping = float(model.tendon_stiffness[index].item()), float(model.tendon_damping[index].item())
        armature, is_limited = float(model.tendon_armature[index]), bool(model.tendon_limited[index])
        friction = float(model.tendon_frictionloss[index])
        curved = [getattr(model, f"tendon_{name}poly", None) for name in ("stiffness", "damping")]
        is_curved = any(table is not None and np.any(table[index]) for table in curved)
        if not (stiffness or damping or armature or is_limited or friction or is_curved or index in tied):
            continue
        name = places.tendon(index)
        span, way = places.place("tendon", index), _way(places, index, joints)
        if way is None or is_curved:
            why = "which is no fixed one of hinges and slides," if way is None else "whose curved spring or damper"
            findings.error("E1016", span, what=f"the tendon {name}, {why}", instead=_LEFT_OUT)
            continue
        low, high = map(float, model.tendon_lengthspring[index])
        ends = tuple(map(float, model.tendon_range[index])) if is_limited else (None, None)
        found.append(
            Tendon(
                name=name,
                way=way,
                stiffness=stiffness,
                slack=(low, high),
                damping=damping,
                friction=friction,
                armature=armature,
                limits=Bounds(low=ends[0], high=ends[1]),
                span=span,
            )
        )
    return found


def actuators_of(places: Places, joints: list[Joint], findings: Findings) -> list[Actuator | Servo]:
    """Motors of joints, whose effort is gear times gain times the control, and servos. E1016 for other actuators."""
    model, found = places.model, list[Actuator | Servo]()
    taken: set[str] = set()
    users = Counter[str]()
    for index in range(model.nu):
        name = str(model.actuator(index).name)
        span = places.place("actuator", index)
        fault = _fault(places, index)
        way = _transmission(places, index, joints) if fault is None else None
        if fault is None and way is None:
            fault = "which drives no joint with one coordinate and no fixed tendon"
        if fault is not None or way is None:
            findings.error("E1016", span, what=f"the actuator {name or index + 1}, {fault}", instead=_LEFT_OUT)
            continue
        users.update(joint for joint, _ in way)
        own = name or f"u_{way[0][0] if len(way) == 1 else f'actuator_{index + 1}'}"
        own = next(each for each in (own, *(f"{own}_{count}" for count in range(2, index + 3))) if each not in taken)
        taken.add(own)
        found.append(_actuator(places, index, own, way, _force_range(places, index, way), span))
        if len(way) > 1 or users[way[0][0]] > 1:
            for joint, _ in way:
                if _joint_force(places, joint) is not None:
                    what = f"the limit that the joint {joint} has for the sum of its actuators"
                    findings.error("E1016", span, what=what, instead=_LEFT_OUT)
    return found


def _actuator(places: Places, index: int, name: str, way: Way, force: Bounds, span: Span) -> Actuator | Servo:
    model, mujoco = places.model, places.mujoco
    gain_is_fixed = int(model.actuator_gaintype[index]) == int(mujoco.mjtGain.mjGAIN_FIXED)
    has_bias = int(model.actuator_biastype[index]) != int(mujoco.mjtBias.mjBIAS_NONE)
    gain = _affine(model.actuator_gainprm[index], 1 if gain_is_fixed else 3)
    bias = _affine(model.actuator_biasprm[index], 3 if has_bias else 0)
    control = Bounds()
    if model.actuator_ctrllimited[index]:
        least, most = map(float, model.actuator_ctrlrange[index])
        control = Bounds(low=least, high=most)
    kinds: dict[int, Literal["none", "integrator", "filter"]] = {
        int(mujoco.mjtDyn.mjDYN_NONE): "none",
        int(mujoco.mjtDyn.mjDYN_INTEGRATOR): "integrator",
    }
    activation = kinds.get(int(model.actuator_dyntype[index]), _FILTER)
    is_motor = activation == "none" and len(way) == 1 and not any((*bias, *gain[1:]))
    if is_motor:
        low, high = _narrowed(control, force, gain[0])
        return Actuator(name=name, joint=way[0][0], gear=gain[0] * way[0][1], low=low, high=high, span=span)
    return Servo(
        name=name,
        way=way,
        gain=gain,
        bias=bias,
        control=control,
        force=force,
        activation=activation,
        lag=float(model.actuator_dynprm[index][0]),
        span=span,
    )


def _affine(numbers: Any, count: int) -> Affine:
    """The first `count` of three numbers: constant, factor of the length, factor of its rate."""
    constant, length, rate = (float(number) if place < count else 0.0 for place, number in enumerate(numbers[:3]))
    return constant, length, rate


def _fault(places: Places, index: int) -> str | None:
    """The reason for which an actuator has no place in the text, or None."""
    model, mujoco = places.model, places.mujoco
    dynamics, gain, bias = (int(getattr(model, f"actuator_{name}type")[index]) for name in ("dyn", "gain", "bias"))
    dyn = mujoco.mjtDyn
    if dynamics not in map(int, (dyn.mjDYN_NONE, dyn.mjDYN_INTEGRATOR, dyn.mjDYN_FILTER, dyn.mjDYN_FILTEREXACT)):
        return "whose activation has a law of its own"
    if gain not in map(int, (mujoco.mjtGain.mjGAIN_FIXED, mujoco.mjtGain.mjGAIN_AFFINE)):
        return "whose gain is not affine"
    if bias not in map(int, (mujoco.mjtBias.mjBIAS_NONE, mujoco.mjtBias.mjBIAS_AFFINE)):
        return "whose bias is not affine"
    if dynamics in map(int, (dyn.mjDYN_FILTER, dyn.mjDYN_FILTEREXACT)) and model.actuator_dynprm[index][0] <= 0.0:
        return "whose filter has no time constant"
    if model.actuator_actlimited[index]:
        return "whose activation has limits"
    if model.actuator_actearly[index]:
        return "which acts a step early"
    names = ("damping", "dampingpoly", "armature", "delay")
    if any(np.any(getattr(model, f"actuator_{name}")[index]) for name in names if hasattr(model, f"actuator_{name}")):
        return "which has damping, an armature or a delay of its own"
    counts = (getattr(model, name, None) for name in ("actuator_ctrlnum", "actuator_outnum"))
    if any(table is not None and int(table[index]) != 1 for table in counts):
        return "which has several controls or outputs"
    return None


def _transmission(places: Places, index: int, joints: list[Joint]) -> Way | None:
    """The length that an actuator sees, as a combination of coordinates."""
    model, kinds = places.model, places.mujoco.mjtTrn
    kind, target = int(model.actuator_trntype[index]), int(model.actuator_trnid[index][0])
    gear = float(model.actuator_gear[index][0])
    if kind in (int(kinds.mjTRN_JOINT), int(kinds.mjTRN_JOINTINPARENT)):
        name = places.joint(target)
        return ((name, gear),) if any(joint.name == name and joint.kind in _MOTIONS for joint in joints) else None
    if kind == int(kinds.mjTRN_TENDON):
        way = _way(places, target, joints)
        return None if way is None else tuple((name, gear * factor) for name, factor in way)
    return None


def _way(places: Places, tendon: int, joints: list[Joint]) -> Way | None:
    """The length of a fixed tendon, a combination of coordinates; None for others."""
    model = places.model
    first, count = int(model.tendon_adr[tendon]), int(model.tendon_num[tendon])
    moved = {joint.name for joint in joints if joint.kind in _MOTIONS}
    found = []
    for at in range(first, first + count):
        if int(model.wrap_type[at]) != int(places.mujoco.mjtWrap.mjWRAP_JOINT):
            return None
        name = places.joint(int(model.wrap_objid[at]))
        if name not in moved:
            return None
        found.append((name, float(model.wrap_prm[at])))
    return tuple(found)


def _force_range(places: Places, index: int, way: Way) -> Bounds:
    """Bounds of the force of an actuator: its own, and those that its joint has for the sum of all actuators."""
    model = places.model
    low, high = -math.inf, math.inf
    if model.actuator_forcelimited[index]:
        low, high = map(float, model.actuator_forcerange[index])
    for name, gear in way:
        limits = _joint_force(places, name)
        if limits is not None and gear:
            ends = sorted(limit / gear for limit in limits)
            low, high = max(low, ends[0]), min(high, ends[1])
    return Bounds(low=low if math.isfinite(low) else None, high=high if math.isfinite(high) else None)


def _joint_force(places: Places, name: str) -> tuple[float, float] | None:
    model = places.model
    (joint,) = (index for index in range(model.njnt) if places.joint(index) == name)
    if not model.jnt_actfrclimited[joint]:
        return None
    low, high = map(float, model.jnt_actfrcrange[joint])
    return low, high


def _narrowed(control: Bounds, force: Bounds, gain: float) -> tuple[float | None, float | None]:
    """Bounds of the control of a motor, and those that a bound of the force means for it."""
    low = -math.inf if control.low is None else control.low
    high = math.inf if control.high is None else control.high
    if force.low is not None and force.high is not None and gain:
        ends = sorted((force.low / gain, force.high / gain))
        low, high = max(low, ends[0]), min(high, ends[1])
    return (low if math.isfinite(low) else None), (high if math.isfinite(high) else None)
