"""Events on the graph: indicators, passes over the `when` clauses, gaps, clocks, corners.

In a pass a discrete variable means its new value wherever the flow of data has it already; `pre` and everything that is
not assigned is an entry of `w`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import copy
from graphlib import TopologicalSorter
from typing import assert_never

from lagdsl.algebra.graph.differentiate import jacobian
from lagdsl.algebra.graph.graph import Graph
from lagdsl.algebra.graph.operation import Group, Op
from lagdsl.algebra.graph.substitute import Substitution
from lagdsl.algebra.graph.taylor import TimeDerivative
from lagdsl.derivation.mechanics.lowering.acceleration import needs_accelerations
from lagdsl.derivation.mechanics.lowering.lowering import Lowering
from lagdsl.derivation.mechanics.lowering.symbols import delay_rates
from lagdsl.derivation.program.functions import OPTIONAL
from lagdsl.derivation.program.program import Block, Function, matrix_block, number_block, vector_block
from lagdsl.language.flat.dependence import Dependence
from lagdsl.language.flat.event_flow import assignments, branches, needs, reset_states
from lagdsl.language.flat.events import (
    Action,
    Assign,
    Branch,
    Check,
    Contact,
    Entry,
    Impact,
    Reset,
    Terminate,
    When,
    entries,
)
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.flat.quantity import Experiment
from lagdsl.language.flat.ways import differentiated, positions

# Of the length of the experiment: the time left of bounces below which a contact rests where no `t_eps` is given. The
# runtime takes the same part of a run where the model states no length.
_REST = 1e-6


def event_functions(lowering: Lowering, flat: FlatModel) -> tuple[Function, ...]:
    """The functions of OPTIONAL that a model with discretes has; none for others."""
    if not entries(flat.events):
        return ()
    graph = lowering.graph
    indicators = _indicators(lowering, flat)
    found = {
        "discrete_start": [vector_block("w", _starts(lowering, flat))],
        "indicator": [vector_block("g", indicators)],
        "indicator_rate": _rates(lowering, flat, indicators),
        "standing": [vector_block("w", _standing(lowering, flat))],
        "contact": _gaps(lowering, flat),
        "clock": [
            vector_block("start", [lowering.scalar(each.start) for each in flat.events.clocks]),
            vector_block("period", [lowering.scalar(each.period) for each in flat.events.clocks]),
        ],
        "event": Pass(graph, lowering, flat).blocks(),
    }
    found["time_event"] = _time_events(lowering, flat)
    return tuple(Function(name=name, arguments=OPTIONAL[name], results=tuple(found[name])) for name in found)


def _indicators(lowering: Lowering, flat: FlatModel) -> list[int]:
    """Sides of relations, one less the other. A contact only pushes: where its multiplier pulls, at the instant at
    which it opens, relations see zero."""
    symbols = lowering.symbols
    rows = [row for each in flat.constraints if each.contact for row in each.rows]
    forces = [symbols.rows[row] for row in rows]
    pushing = {force: lowering.graph.binary(Op.MAX, force, lowering.graph.constant(0.0)) for force in forces}
    differences = [lowering.scalar(each.difference) for each in flat.events.relations]
    return Substitution(lowering.graph, pushing).of_all(differences)


def _rates(lowering: Lowering, flat: FlatModel, indicators: Sequence[int]) -> list[Block]:
    """First and second derivatives along the motion. Of what the equations do not differentiate, accelerations,
    multipliers and inputs without their own derivatives, the rates are symbols, which stay as they are; so do
    those of delayed values, entries of w. In first derivatives those of states are symbols, too: there a rate of
    a position or a state is a direction, in which a relation of positions changes linearly."""
    graph, delayed = lowering.graph, delay_rates(lowering.symbols, flat)
    differentiated_inputs = {item.derivative_of for item in flat.inputs}
    given = {Group.U: Group.DIRECTION_U, Group.QDD: Group.DIRECTION_QDD, Group.LAMBDA: Group.DIRECTION_LAMBDA}
    given[Group.Z] = Group.DIRECTION_Z

    def direction(symbol: int) -> int:
        index, group = graph.b[symbol], graph.group(symbol)
        is_known = group is Group.U and flat.inputs[index].name in differentiated_inputs
        return lowering.rate.of(symbol) if is_known else graph.symbol(given[group], index)

    def rate(symbol: int) -> int:
        return lowering.rate.of(symbol) if graph.group(symbol) is Group.Z else direction(symbol)

    first = TimeDerivative(graph, direction, delayed=delayed)
    along = TimeDerivative(graph, rate, delayed=delayed)
    rates = [first.of(node) for node in indicators]
    accelerations = [along.of(along.of(node)) for node in indicators]
    return [vector_block("rate", rates), vector_block("acceleration", accelerations)]


def corner_functions(lowering: Lowering, flat: FlatModel) -> tuple[Function, ...]:
    """`corner` of a model with corners along the motion; none for others."""
    graph = lowering.graph
    nodes = {lowering.scalar(each.distance): each.solved for each in flat.events.corners}
    moving = {node: solved for node, solved in nodes.items() if graph.op[node] is not Op.CONSTANT}
    if not moving:
        return ()
    solved = number_block("solved", graph.constant(float(any(moving.values()))))
    blocks = (vector_block("far", list(moving)), solved)
    return (Function(name="corner", arguments=OPTIONAL["corner"], results=blocks),)


def delay_functions(lowering: Lowering, flat: FlatModel) -> tuple[Function, ...]:
    """`delayed` of a model with delayed values; none for others."""
    graph, delays = lowering.graph, flat.events.delays
    if not delays:
        return ()
    values = []
    for each in delays:
        lowering.place = each.spans
        values.append(lowering.scalar(each.value))
        if graph.depends(values[-1], Group.QDD, Group.LAMBDA):
            raise needs_accelerations(each.spans, f"`{each.name}`")
    own = {lowering.symbols.previous[each.name] for each in delays}
    blocks = (
        vector_block("value", values),
        vector_block("time", [lowering.scalar(each.time) for each in delays]),
        number_block("direct", graph.constant(float(not own.isdisjoint(graph.live(values))))),
    )
    return (Function(name="delayed", arguments=OPTIONAL["delayed"], results=blocks),)


def way_functions(lowering: Lowering, flat: FlatModel) -> tuple[Function, ...]:
    """`way` of a model in which ways of masses depend on discretes or on states that clauses set; none for others."""
    if not entries(flat.events):
        return ()
    graph, states, dependence = lowering.graph, reset_states(flat), Dependence(flat)
    places = [(vector, lowering.vector(vector)) for vector in positions(flat)]
    found = [*places, *((way, _continuous(lowering, way)) for way in differentiated(flat))]
    ways = {
        node: None
        for expression, nodes in found
        for node in nodes
        if graph.depends(node, Group.W)
        or (states and graph.depends(node, Group.Z) and not states.isdisjoint(dependence.of(expression)))
    }
    return (
        (Function(name="way", arguments=OPTIONAL["way"], results=(vector_block("way", list(ways)),)),) if ways else ()
    )


def _continuous(lowering: Lowering, way: FlatExpression) -> tuple[int, ...]:
    """A vector as it is; cosine and sine of a scalar: an angle may jump by whole turns, `wrap(a)`."""
    value, graph = lowering.value(way), lowering.graph
    return value if isinstance(value, tuple) else (graph.unary(Op.COS, value), graph.unary(Op.SIN, value))


def _starts(lowering: Lowering, flat: FlatModel) -> list[int]:
    """Discrete variables as declared, what time alone changes as it is, what is delayed as it is with the start values;
    all else is found by looking, at the start."""
    known = dict.fromkeys(lowering.symbols.previous, lowering.graph.zero)
    known |= {each.name: lowering.scalar(each.start) for each in flat.events.discretes}
    known |= _as_time_stands(lowering, flat, known)
    if flat.events.delays:
        symbols, scalar = lowering.symbols, lowering.scalar
        starts = [*(each.start for each in flat.coordinates), *(each.rate_start for each in flat.coordinates)]
        starts += [*(each.start for each in flat.states), *(each.default for each in flat.inputs)]
        moving = (*symbols.q, *symbols.qd, *symbols.z, *symbols.u)
        values = dict(zip(moving, map(scalar, starts), strict=True))
        values |= {symbols.previous[name]: node for name, node in known.items()}
        at_start = Substitution(lowering.graph, values)
        known |= {each.name: at_start.of(scalar(each.value)) for each in flat.events.delays}
    return list(known.values())


def _standing(lowering: Lowering, flat: FlatModel) -> list[int]:
    graph = lowering.graph
    truths = {
        each.name: graph.binary(Op.LESS if each.strict else Op.LESS_EQUAL, graph.zero, lowering.scalar(each.difference))
        for each in flat.events.relations
    }
    truths |= _as_time_stands(lowering, flat, {})
    return [truths.get(name, node) for name, node in lowering.symbols.previous.items()]


def _as_time_stands(lowering: Lowering, flat: FlatModel, known: Mapping[str, int]) -> dict[str, int]:
    """The entries that time alone changes, as they are at its present value: one after the other, as a later one may
    read earlier ones. Discretes that are `known` have these values, the others their entries of w."""
    if not flat.events.timed:
        return {}
    fresh = renamed(lowering, flat, known)
    found: dict[str, int] = {}
    for each in flat.events.timed:
        found[each.name] = fresh.symbols.by_name[each.name] = fresh.scalar(each.value)
    return found


def renamed(lowering: Lowering, flat: FlatModel, known: Mapping[str, int]) -> Lowering:
    """Lowers the same model with other nodes for some names; more of them may be put into its symbols."""
    symbols = copy(lowering.symbols)
    symbols.by_name = {**lowering.symbols.by_name, **known}
    fresh = Lowering(lowering.graph, flat, symbols)
    fresh.provide = lowering.provide
    return fresh


def _time_events(lowering: Lowering, flat: FlatModel) -> list[Block]:
    """Entries that time alone changes, with the distance to the next change. If the second derivative of a distance is
    zero at all times, the distance is affine between events."""
    graph = lowering.graph
    timed = flat.events.timed
    places = [place for place, each in enumerate(timed) for _ in each.distances]
    distances = [lowering.scalar(distance) for each in timed for distance in each.distances]
    rates = [lowering.rate.of(distance) for distance in distances]
    affine = [float(lowering.rate.of(rate) == graph.zero) for rate in rates]
    stands = _as_time_stands(lowering, flat, {})
    told = [float(_TOLD[each.kind]) for each in timed]
    return [
        vector_block("value", [stands[each.name] for each in timed]),
        vector_block("told", [graph.constant(flag) for flag in told]),
        vector_block("distance", distances),
        vector_block("rate", rates),
        vector_block("affine", [graph.constant(flag) for flag in affine]),
        vector_block("entry", [graph.constant(float(place)) for place in places]),
    ]


_TOLD = {"corner": 0, "relation": 1, "jump": 2}


def impacts(flat: FlatModel) -> list[Contact | Impact]:
    """Items that may collide: contacts, then the `impact(...)` of `when` clauses."""
    actions = (action for branch in branches(flat) for action in branch.actions)
    return [*flat.events.contacts, *(action for action in actions if isinstance(action, Impact))]


def _gaps(lowering: Lowering, flat: FlatModel) -> list[Block]:
    graph = lowering.graph
    found = impacts(flat)
    told = [lowering.scalar(each.gap) for each in found]
    contacts = flat.events.contacts
    one_way = {place for place, each in enumerate(contacts) if each.one_way}
    gaps = [graph.zero if place in one_way else gap for place, gap in enumerate(told)]
    speeds = [rate if place in one_way else lowering.rate.of(rate) for place, rate in enumerate(told)]
    moved, driven = (jacobian(graph, told, graph.symbols(by, len(flat.coordinates))) for by in (Group.Q, Group.QD))
    rows = [driven[place] if place in one_way else row for place, row in enumerate(moved)]
    unknown = graph.constant(-1.0)
    capture_speed = [
        unknown if each.capture_speed is None else lowering.scalar(each.capture_speed) for each in contacts
    ]
    brief = _brief(graph, flat.experiment)
    zeno_time = [brief if each.zeno_time is None else lowering.scalar(each.zeno_time) for each in contacts]
    return [
        vector_block("gap", gaps),
        vector_block("speed", speeds),
        matrix_block("jacobian", rows, len(flat.coordinates)),
        vector_block("restitution", [lowering.scalar(each.restitution) for each in contacts]),
        vector_block("capture_speed", capture_speed),
        vector_block("zeno_time", zeno_time),
    ]


def _brief(graph: Graph, experiment: Experiment) -> int:
    """The time left of bounces below which a contact rests: by the experiment that the model states, so that a run that
    ends elsewhere carries out the same motion; -1 where it states none, which leaves it to the length of the run."""
    length = experiment.stop_time - experiment.start_time
    return graph.constant(_REST * length if experiment.stop_time_explicit and length > 0.0 else -1.0)


class Pass:
    """One pass over the clauses of a model."""

    def __init__(self, graph: Graph, lowering: Lowering, flat: FlatModel) -> None:
        self._graph, self._flat = graph, flat
        self._lowering = renamed(lowering, flat, {})
        self._symbols = self._lowering.symbols
        self._firing: dict[int, int] = {}
        self._memories: dict[str, int] = {}
        giver = {action.variable: when for when in flat.events.whens for action, _ in assignments(when)}
        for variable in TopologicalSorter(needs(flat, Dependence(flat))).static_order():
            when = giver[variable]
            if id(when.branches[0]) not in self._firing:
                self._fire(when)
            self._symbols.by_name[variable] = self._assigned(when, variable)
        for when in flat.events.whens:
            if id(when.branches[0]) not in self._firing:
                self._fire(when)
        self._memories |= {each.name: self._lowering.scalar(each.value) for each in flat.events.memories}

    def blocks(self) -> list[Block]:
        """w after the pass; what is to be done, action by action in the order of the text."""
        values = [self._value(entry) for entry in entries(self._flat.events)]
        actions = [(branch, action) for branch in branches(self._flat) for action in branch.actions]
        acting = {
            kind: [(self._acts(branch, action), action) for branch, action in actions if isinstance(action, kind)]
            for kind in (Reset, Impact, Terminate, Check)
        }
        scalar = self._lowering.scalar
        failing = [
            self._fails(flag, self._graph.unary(Op.NOT, scalar(action.condition)), action.warning)
            for flag, action in acting[Check]
            if isinstance(action, Check)
        ]
        return [
            vector_block("w", values),
            vector_block("reset", [flag for flag, _ in acting[Reset]]),
            vector_block("value", [scalar(action.value) for _, action in acting[Reset] if isinstance(action, Reset)]),
            vector_block("impact", [flag for flag, _ in acting[Impact]]),
            vector_block(
                "restitution",
                [scalar(action.restitution) for _, action in acting[Impact] if isinstance(action, Impact)],
            ),
            vector_block("stop", [flag for flag, _ in acting[Terminate]]),
            vector_block("fail", failing),
        ]

    def _value(self, entry: Entry) -> int:
        match entry.kind:
            case "variable":
                return self._symbols.by_name[entry.name]
            case "condition":
                return self._memories[entry.name]
            case "contact" | "impacts" | "sticks" | "direction" | "relation" | "timed" | "delay" | "delay_rate":
                return self._symbols.previous[entry.name]
            case "clock" | "instant" | "load":
                return self._symbols.previous[entry.name]
            case _:
                assert_never(entry.kind)

    def _fire(self, when: When) -> None:
        """The conditions of a clause, once the variables that they read have their new values."""
        graph = self._graph
        free = graph.one
        for branch in when.branches:
            rising = graph.zero
            for condition, memory in zip(branch.conditions, branch.memories, strict=True):
                truth = self._lowering.scalar(condition)
                self._memories[memory] = truth
                before = self._symbols.previous[memory]
                rising = graph.binary(Op.OR, rising, self._both(truth, graph.unary(Op.NOT, before)))
            self._firing[id(branch)] = self._both(free, rising)
            free = self._both(free, graph.unary(Op.NOT, rising))

    def _assigned(self, when: When, variable: str) -> int:
        value = self._symbols.previous[variable]
        for branch in when.branches:
            for action in branch.actions:
                if isinstance(action, Assign) and action.variable == variable:
                    value = self._graph.select(self._acts(branch, action), self._lowering.scalar(action.value), value)
        return value

    def _acts(self, branch: Branch, action: Action) -> int:
        firing = self._firing[id(branch)]
        return firing if action.guard is None else self._both(firing, self._lowering.scalar(action.guard))

    def _fails(self, flag: int, broken: int, warning: bool) -> int:
        """1 for a failure, -1 for a warning."""
        both = self._both(flag, broken)
        return self._graph.unary(Op.NEGATE, both) if warning else both

    def _both(self, one: int, two: int) -> int:
        return self._graph.binary(Op.AND, one, two)
