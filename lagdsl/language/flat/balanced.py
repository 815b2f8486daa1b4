"""Balances of forces among the constraints."""

from __future__ import annotations

from lagdsl.language.flat.expression import ForceBalance
from lagdsl.language.flat.model import Constraint


def balanced(constraint: Constraint) -> tuple[str, ...]:
    """The coordinates of the direction without inertia along which `constraint` balances forces: its multiplier is
    zero. None for what the text writes."""
    found = (residual for residual in constraint.residuals if isinstance(residual, ForceBalance))
    return tuple(name for residual in found for name, _ in (*residual.weights, *residual.ties))
