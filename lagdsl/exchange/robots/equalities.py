"""Constraints between coordinates, and between lengths of tendons: polynomials of one of them."""

from __future__ import annotations

from collections.abc import Iterator

from lagdsl.exchange.model_text.numbers import number, quantity
from lagdsl.exchange.robots.description import Equality
from lagdsl.exchange.robots.plan import Plan, coordinate_of
from lagdsl.exchange.robots.relations import difference, sum_of, unit_of
from lagdsl.exchange.robots.servos import unit_along


def equalities(plan: Plan) -> Iterator[str]:
    """A constraint for each."""
    for name, equality in plan.equalities:
        one, own = _side(plan, equality, equality.one)
        yield f"constraint {name}: {one} = {_polynomial(plan, equality, own)};"


def _side(plan: Plan, equality: Equality, name: str) -> tuple[str, str]:
    """A coordinate or a length, and its unit."""
    if equality.of == "joint":
        joint = next(joint for joint in plan.robot.every_joint if joint.name == name)
        return coordinate_of(plan, joint), unit_of(joint)
    own, tendon = next((own, tendon) for own, tendon in plan.tendons if tendon.name == name)
    return own, unit_along(plan, tendon.way)


def _polynomial(plan: Plan, equality: Equality, own: str) -> str:
    """`2*elbow.q + 0.1 rad`; with higher powers in ways from the rests. A factor between an angle and a length has a
    unit, which a power of a length needs, too."""
    constant = equality.rests[0] + equality.coefficients[0]
    factors = {power: factor for power, factor in enumerate(equality.coefficients) if power and factor}
    if equality.other is None or not factors:
        return quantity(constant, own)
    name, unit = _side(plan, equality, equality.other)
    if set(factors) == {1}:
        constant -= factors[1] * equality.rests[1]
    else:
        name = difference(name, quantity(equality.rests[1], unit))
    terms = [_term(power, factor, name, own, unit) for power, factor in factors.items()]
    return sum_of([*terms, quantity(constant, own)] if constant else terms)


def _term(power: int, factor: float, name: str, own: str, unit: str) -> str:
    variable = name if power == 1 else f"{name}^{power}"
    if own == unit and (power == 1 or unit == "rad"):
        return {1.0: variable, -1.0: f"-{variable}"}.get(factor, f"{number(factor)}*{variable}")
    return f"{quantity(factor, f'{own}/{unit}{power if power > 1 else str()}')}*{variable}"
