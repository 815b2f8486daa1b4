"""Forces that motions require of the loads: `inverse_dynamics` and `bias` of the language, for controllers in a model.

The forces of the mechanism without its loads are formed once, as functions of symbols, of about the size of T and V.
Each motion puts its own positions, rates, accelerations and parameters in the place of these symbols.
"""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import replace

from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.algebra.graph.substitute import Substitution
from lagdsl.derivation.mechanics.lagrange import lagrange
from lagdsl.derivation.mechanics.lagrange.inverse import bias_forces, inverse_dynamics
from lagdsl.derivation.mechanics.lowering.lowering import Lowering, Provided
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.diagnostics.suggest import listing
from lagdsl.foundation.record import record
from lagdsl.language.flat.expression import Motion, RequiredForce
from lagdsl.language.flat.model import FlatModel


@record()
class _Mechanism:
    """Forces of all coordinates as functions of symbols, those of parameters in `parameters`."""

    forces: list[int]
    parameters: dict[str, int]


class RequiredForces:
    """Answers for one model. Raises CompilationFailed (E0528) where the state does not tell the force."""

    def __init__(self, lowering: Lowering, flat: FlatModel) -> None:
        self._lowering = lowering
        self._flat = flat
        self._formed: dict[tuple[str, ...], _Mechanism] = {}
        self._sound: set[tuple[str, tuple[str, ...], bool]] = set()
        self._moved: dict[tuple[tuple[int, int], ...], Substitution] = {}

    def __call__(self, force: Provided, nodes: Sequence[int]) -> int:
        """`nodes` are those of the operands of the motion, in the lowering that asks."""
        assert isinstance(force, RequiredForce), force
        motion, symbols = force.motion, self._lowering.symbols
        mechanism = self._mechanism(motion)
        places = [symbols.coordinate_index[name] for name in motion.coordinates]
        graph = self._lowering.graph
        qdd = graph.symbols(Group.QDD, len(symbols.q))
        own = [group[place] for group in (symbols.q, symbols.qd) for place in places]
        own += [qdd[place] for place in places] if motion.accelerations else []
        own += [mechanism.parameters[name] for name, _ in motion.parameters]
        changed = tuple((old, new) for old, new in zip(own, nodes, strict=True) if old != new)
        elsewhere = any(graph.group(old) is not Group.QDD for old, _ in changed)
        asked = (motion.function, motion.coordinates, elsewhere)
        if asked not in self._sound:
            self._require_value(motion, set(graph.live([mechanism.forces[x] for x in places])), elsewhere)
            self._sound.add(asked)
        if changed not in self._moved:
            self._moved[changed] = Substitution(graph, dict(changed))
        return self._moved[changed].of(mechanism.forces[places[force.place]])

    def _mechanism(self, motion: Motion) -> _Mechanism:
        names = tuple(name for name, _ in motion.parameters)
        key = (motion.function, *names)
        if key not in self._formed:
            lowering, parameters = self._with_parameters(names)
            directions = lowering.symbols.directions
            mechanism = replace(self._flat, loads=())
            if motion.function == "bias":
                kept = tuple(term for term in mechanism.energies if term.kind != "dissipation")
                mechanism = replace(mechanism, energies=kept)
            found = lagrange.dynamics(lowering, mechanism, directions)
            form = bias_forces if motion.function == "bias" else inverse_dynamics
            self._formed[key] = _Mechanism(form(lowering, mechanism, found, directions), parameters)
        return self._formed[key]

    def _with_parameters(self, names: tuple[str, ...]) -> tuple[Lowering, dict[str, int]]:
        """A lowering in which these parameters are symbols, and the symbols: one that was fixed is a number else."""
        graph, symbols = self._lowering.graph, self._lowering.symbols
        parameters = {name: symbols.by_name[name] for name in names}
        fixed = [name for name, node in parameters.items() if graph.op[node] is not Op.SYMBOL]
        if not fixed:
            return self._lowering, parameters
        beyond = len(self._flat.parameters)
        parameters |= {name: graph.symbol(Group.P, beyond + place) for place, name in enumerate(fixed)}
        symbols = copy(symbols)
        symbols.by_name = {**symbols.by_name, **parameters}
        return Lowering(graph, self._flat, symbols), parameters

    def _require_value(self, motion: Motion, live: set[int], elsewhere: bool) -> None:
        """E0528 where a force of the motion reads an acceleration that the motion does not give or, `elsewhere` than in
        the state, a relation, whose truth is that of the state."""
        graph, symbols = self._lowering.graph, self._lowering.symbols
        given = set(motion.coordinates)
        others = [each.name for each in self._flat.coordinates if each.name not in given]
        missing = [x for x in others if graph.symbol(Group.QDD, symbols.coordinate_index[x]) in live]
        turning = [each.name for each in self._flat.events.relations if symbols.previous[each.name] in live]
        if missing:
            reason = f"it depends on accelerations that it is not given: of {listing('', missing, '`{}`')}"
            way = f"add `{missing[0]}` and its acceleration as two more arguments, or to the two arrays"
        elif turning and elsewhere:
            reason = (
                f"it depends on `{turning[0]}`, which is true or false for the present state, not for the given one"
            )
            way = "ask for the forces at the present state, or write the energy without a relation"
        else:
            return
        sink = Sink()
        sink.report("E0528", motion.span, function=motion.function, reason=reason, help=way)
        raise CompilationFailed(sink.diagnostics)
