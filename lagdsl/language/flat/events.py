"""Events: relations, corners of time, discrete variables, `when` clauses, clocks, contacts, dry friction.

Each of them has entries in the vector of discretes; expressions read those as variables by their names (see
`discretes`).
"""

from __future__ import annotations

import math
from dataclasses import field
from typing import Literal, TypeAlias

from lagdsl.foundation.record import record
from lagdsl.foundation.units import Dimension
from lagdsl.language.flat.expression import FlatExpression
from lagdsl.language.flat.quantity import Item, Quantity

INITIAL = "initial()"
TERMINAL = "terminal()"

BRANCH = "branch of "
"""Begins the name of a relation that is the branch of a function, such as `abs(x)`."""


@record(kw_only=True)
class Discrete(Quantity):
    """A variable that keeps its value between events. Booleans are 0 and 1."""

    start: FlatExpression
    start_explicit: bool
    kind: Literal["Real", "Integer", "Boolean"] = "Real"
    minimum: float | None = None
    maximum: float | None = None


@record(kw_only=True)
class Relation(Item):
    """The truth of `difference > 0` or, where it is not `strict`, of `difference >= 0`; `name` is as written."""

    name: str
    difference: FlatExpression
    dimension: Dimension
    strict: bool


@record(kw_only=True)
class Timed(Item):
    """An entry that depends on time, parameters and discretes only: the instants at which it changes are known ahead.

    `value` is what it is as time stands: the truth of a relation, the number of a piece. Between its changes every one
    of `distances`, which read the entry itself, is positive; where one reaches zero the entry changes. A `corner`
    is told only where rates jump with it.
    """

    name: str
    kind: Literal["relation", "jump", "corner"]
    value: FlatExpression
    distances: tuple[FlatExpression, ...]


@record(kw_only=True)
class Corner(Item):
    """A place at which a function of the motion has a corner or a jump: `distance` passes zero there. `solved`: it
    reads accelerations or multipliers."""

    distance: FlatExpression
    solved: bool


@record(kw_only=True)
class SampledCorner(Item):
    """A function with a corner or a jump in what clauses compute, `name` as written; it reaches these `variables`, and
    the states and rates that clauses set. Nothing is located there: the clause takes it as it stands."""

    name: str
    variables: tuple[str, ...]


@record(kw_only=True)
class Memory(Item):
    """`pre(v)` of a quantity that no clause assigns, as an input: `value` as it was before the event. A `truth` is 0 or
    1."""

    name: str
    value: FlatExpression
    truth: bool


@record(kw_only=True)
class Clock(Item):
    """`sample(start, period)`: ticks at start + k*period, k = 0, 1, 2 ...; both depend on parameters only."""

    name: str
    start: FlatExpression
    period: FlatExpression


@record(kw_only=True)
class Contact(Item):
    """`gap >= 0` with an impact law. The constraint of its name holds while it is closed.

    `one_way`: `gap` is a rate, linear in the rates, the constraint is of velocity level and the restitution zero.
    `capture_speed` is the rebound speed below which it closes, `zeno_time` the time left of a series of impacts
    below which it does; None: no speed, a millionth of the length that the experiment states, else of the run.
    """

    name: str
    gap: FlatExpression
    dimension: Dimension
    restitution: FlatExpression
    capture_speed: FlatExpression | None
    zeno_time: FlatExpression | None
    one_way: bool = False

    @property
    def closed(self) -> str:
        return f"closed({self.name})"

    @property
    def impacts(self) -> str:
        return f"impacts({self.name})"


@record(kw_only=True)
class Friction(Item):
    """Dry friction along `slips`, one or two scalars of one `dimension` that are linear in the rates.

    It opposes slip with the force `limit`, and holds slip at zero with forces up to `sticking` (None: `limit`), which
    are those of the constraint of its name. `contact` names the contact under which it acts, None: always.
    """

    name: str
    slips: tuple[FlatExpression, ...]
    dimension: Dimension
    limit: FlatExpression
    sticking: FlatExpression | None
    contact: str | None = None

    @property
    def rows(self) -> tuple[str, ...]:
        """Names of the rows of its constraint, one for each slip."""
        if len(self.slips) == 1:
            return (self.name,)
        return tuple(f"{self.name}[{place}]" for place in range(1, len(self.slips) + 1))

    @property
    def sticks(self) -> str:
        return f"sticks({self.name})"

    @property
    def directions(self) -> tuple[str, ...]:
        """One slip: the sign of the force's opposite, -1, 0 or 1. Two: a speed that gives slip at rest a direction."""
        if len(self.slips) == 1:
            return (f"direction({self.name})",)
        return tuple(f"direction({self.name})[{place}]" for place in range(1, len(self.slips) + 1))


@record(kw_only=True)
class Feedback(Item):
    """A scalar in a load that depends on the accelerations or multipliers that it causes. The load reads the entry
    `name`, which has to be as `value` is with them."""

    name: str
    value: FlatExpression
    dimension: Dimension


@record(kw_only=True)
class Delay(Item):
    """`value` as it was `time` [s] ago, `name` as written; in the time before the start it is what it is there. `time`
    depends on parameters only, `value` on what is known with the state. Expressions read the entry `name`."""

    name: str
    value: FlatExpression
    time: FlatExpression
    dimension: Dimension

    @property
    def rate(self) -> str:
        """Name of the entry of its derivative."""
        return f"der({self.name})"


@record(kw_only=True)
class Limit(Item):
    """Bounds of an argument of an event: `least <= value <= most`, with `strict` the first without equality."""

    what: str
    value: FlatExpression
    least: float = 0.0
    most: float = math.inf
    strict: bool = False


# ---- when ------------------------------------------------------------------------------------------------------------


@record(kw_only=True)
class Assign(Item):
    """`variable = value` where `guard` holds (None: always), else the variable keeps its value."""

    variable: str
    value: FlatExpression
    guard: FlatExpression | None


@record(kw_only=True)
class Reset(Item):
    """`reinit(x, value)` of a state or, with `rate`, of the rate of a coordinate."""

    name: str
    rate: bool
    value: FlatExpression
    guard: FlatExpression | None


@record(kw_only=True)
class Impact(Item):
    """`impact(gap, restitution)`: as in a contact, once."""

    gap: FlatExpression
    restitution: FlatExpression
    guard: FlatExpression | None


@record(kw_only=True)
class Terminate(Item):
    message: str
    guard: FlatExpression | None


@record(kw_only=True)
class Check(Item):
    """`assert(condition, message)` at the event only."""

    condition: FlatExpression
    message: str
    warning: bool
    guard: FlatExpression | None


Action: TypeAlias = "Assign | Reset | Impact | Terminate | Check"


@record(kw_only=True)
class Branch(Item):
    """Acts where one of `conditions` becomes true; `memories` are the names of the truths they had before."""

    conditions: tuple[FlatExpression, ...]
    memories: tuple[str, ...]
    actions: tuple[Action, ...]


@record(kw_only=True)
class When(Item):
    """`when ... elsewhen ...`: the first branch that acts, acts alone."""

    branches: tuple[Branch, ...]


@record(kw_only=True)
class Events:
    """All of a model that changes at instants. `instants` are those of INITIAL and TERMINAL that occur.

    Steps end at `corners`, those of forces, energies and rates; nothing else happens there. `others` are those of
    outputs, of what stands in `noEvent` and `smooth`, and cuts of `atan2`; `sampled` are those of clauses.
    """

    discretes: tuple[Discrete, ...] = ()
    contacts: tuple[Contact, ...] = ()
    frictions: tuple[Friction, ...] = ()
    feedbacks: tuple[Feedback, ...] = ()
    delays: tuple[Delay, ...] = ()
    relations: tuple[Relation, ...] = ()
    timed: tuple[Timed, ...] = ()
    corners: tuple[Corner, ...] = ()
    others: tuple[Corner, ...] = ()
    sampled: tuple[SampledCorner, ...] = ()
    whens: tuple[When, ...] = ()
    memories: tuple[Memory, ...] = ()
    clocks: tuple[Clock, ...] = ()
    instants: tuple[str, ...] = ()
    limits: tuple[Limit, ...] = ()


Kind: TypeAlias = Literal[
    "variable",
    "contact",
    "impacts",
    "sticks",
    "direction",
    "relation",
    "timed",
    "delay",
    "delay_rate",
    "condition",
    "clock",
    "instant",
    "load",
]


@record()
class Entry:
    """One entry of the vector of discretes; `item` is what it belongs to."""

    name: str
    kind: Kind
    item: Item | None = field(default=None, compare=False, repr=False)


def entries(events: Events) -> tuple[Entry, ...]:
    """The vector of discretes in its order."""
    branches = [branch for when in events.whens for branch in when.branches]
    return (
        *(Entry(each.name, "variable", each) for each in events.discretes),
        *(Entry(each.closed, "contact", each) for each in events.contacts),
        *(Entry(each.impacts, "impacts", each) for each in events.contacts),
        *(Entry(each.sticks, "sticks", each) for each in events.frictions),
        *(Entry(name, "direction", each) for each in events.frictions for name in each.directions),
        *(Entry(each.name, "relation", each) for each in events.relations),
        *(Entry(each.name, "timed", each) for each in events.timed),
        *(Entry(each.name, "delay", each) for each in events.delays),
        *(Entry(each.rate, "delay_rate", each) for each in events.delays),
        *(Entry(name, "condition", branch) for branch in branches for name in branch.memories),
        *(Entry(each.name, "condition", each) for each in events.memories),
        *(Entry(each.name, "clock", each) for each in events.clocks),
        *(Entry(name, "instant") for name in events.instants),
        *(Entry(each.name, "load", each) for each in events.feedbacks),
    )
