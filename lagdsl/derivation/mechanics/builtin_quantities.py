"""Quantities of mechanics for outputs, invariants and assertions: energies, momenta, multipliers, reactions."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import assert_never

from lagdsl.algebra.graph.differentiate import jacobian
from lagdsl.algebra.graph.graph import ZERO
from lagdsl.algebra.graph.substitute import Substitution
from lagdsl.derivation.mechanics.force_balance import force_balance
from lagdsl.derivation.mechanics.kinematics.vectors import Vector
from lagdsl.derivation.mechanics.lagrange.energies import SystemEnergies
from lagdsl.derivation.mechanics.lagrange.inertial_elements import angular_momentum, linear_momentum
from lagdsl.derivation.mechanics.lagrange.lagrange import Dynamics
from lagdsl.derivation.mechanics.lagrange.required import RequiredForces
from lagdsl.derivation.mechanics.lowering.lowering import Lowering, Provided
from lagdsl.derivation.mechanics.lowering.symbols import Symbols
from lagdsl.derivation.mechanics.lowering.values import Value
from lagdsl.derivation.mechanics.reactions import Releases, plan_releases, reactions
from lagdsl.language.flat import expression as flat
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.model import Definition, FlatModel
from lagdsl.language.flat.traversal import operands, records


class Provider:
    """Answers for one model once its equations are formed; reactions are formed together when one is asked for."""

    def __init__(
        self,
        lowering: Lowering,
        model: FlatModel,
        symbols: Symbols,
        found: Dynamics,
        totals: SystemEnergies,
        required: RequiredForces,
    ) -> None:
        self._lowering = lowering
        self._model = model
        self._symbols = symbols
        self._dynamics = found
        self._totals = totals
        self._required = required
        self._releases: Releases | None = None
        self._reactions: list[int] = []

    def __call__(self, expression: Provided, nodes: Sequence[int]) -> Value:
        symbols = self._symbols
        found = self._dynamics.energies.inertial_elements
        match expression:
            case flat.RequiredForce():
                return self._required(expression, nodes)
            case flat.Multiplier(row):
                return symbols.rows[row]
            case flat.FrameReaction(frame, kind):
                return self._frame_reaction(frame, kind)
            case flat.ReactionAlong():
                releases = self._released()
                return self._reactions[releases.along[id(expression)]]
            case flat.SystemEnergy(kind):
                return self._totals.of(kind)
            case flat.GeneralizedMomentum(coordinate):
                return self._dynamics.terms.momentum[symbols.coordinate_index[coordinate]]
            case flat.ForceBalance():
                return self._force_balance(expression)
            case flat.LinearMomentum():
                return linear_momentum(self._lowering, found)
            case flat.AngularMomentum(body, about):
                chosen = found if body is None else tuple(carrier for carrier in found if carrier.label == body)
                return angular_momentum(self._lowering, chosen, self._lowering.vector(about))
            case flat.AdmissibleMotion(point, coordinate):
                moved = symbols.q[symbols.coordinate_index[coordinate]]
                x, y, z = jacobian(self._lowering.graph, self._lowering.vector(point), [moved])
                return (x.get(0, ZERO), y.get(0, ZERO), z.get(0, ZERO))
        assert_never(expression)

    def _force_balance(self, balance: flat.ForceBalance) -> int:
        """f along a direction; the same at rest, where rates have cancelled to zero but for their form."""
        graph, symbols = self._lowering.graph, self._symbols
        force = force_balance(self._lowering, self._model, symbols, self._dynamics.terms, balance)
        none = dict.fromkeys(symbols.qd, graph.zero)
        return Substitution(graph, none).of(force) if balance.still else force

    def _frame_reaction(self, frame: str, kind: str) -> Vector:
        releases = self._released()
        first = (releases.release.origins if kind == "force" else releases.release.turns)[frame]
        x, y, z = self._reactions[first : first + 3]
        return (x, y, z)

    def _released(self) -> Releases:
        if self._releases is None:
            requests = list(_requests(self._model))
            directions = {
                id(request): self._lowering.vector(request.direction)
                for request in requests
                if isinstance(request, flat.ReactionAlong)
            }
            self._releases = plan_releases(requests, directions)
            self._reactions = reactions(self._lowering, self._model, self._symbols, self._releases)
        return self._releases


def _requests(model: FlatModel) -> Iterator[flat.FrameReaction | flat.ReactionAlong]:
    """Every reaction of an output, invariant, assertion, initial equation, definition or event, in order."""
    stack: list[FlatExpression] = [item.residual for item in reversed(model.initial_equations)]
    stack += [each for each in records(model.events) if isinstance(each, flat.FrameReaction | flat.ReactionAlong)]
    stack += [item.condition for item in reversed(model.assertions)]
    stack += [item.value for item in reversed(model.invariants)]
    stack += [item.value for item in reversed(model.outputs)]
    stack += [item.value for item in reversed(model.named) if isinstance(item, Definition)]
    seen: set[int] = set()
    while stack:
        expression = stack.pop()
        if id(expression) in seen:
            continue
        seen.add(id(expression))
        if isinstance(expression, flat.FrameReaction | flat.ReactionAlong):
            yield expression
        stack += reversed(operands(expression))
