"""Actuators that are the effort in a joint."""

from __future__ import annotations

from lagdsl.exchange.robots.description import Actuator, Joint
from lagdsl.foundation.source import Span


def effort_of(joint: Joint, span: Span) -> Actuator:
    """The actuator whose input is the effort in a joint, within the limits of it."""
    most = joint.limits.effort
    return Actuator(name=joint.name, joint=joint.name, low=None if most is None else -most, high=most, span=span)
