"""Variables that an exported model shows: outputs that are asked for, what is hidden, arrays or their entries."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from lagdsl.exchange.fmi.variables.names import Name, named
from lagdsl.exchange.fmi.variables.scalar import Role, Scalar
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.diagnostics.suggest import did_you_mean
from lagdsl.foundation.record import record

# Roles of variables that importers cannot do without.
_ALWAYS = (Role.TIME, Role.STATE, Role.INDICATOR)
# Roles of values that a simulation computes.
_COMPUTED = (
    Role.STATE,
    Role.DEPENDENT,
    Role.DERIVATIVE,
    Role.LOCAL,
    Role.DISCRETE,
    Role.MULTIPLIER,
    Role.ENERGY,
    Role.RESIDUAL,
)
_MOST_NAMED = 4


@record(kw_only=True)
class Ports:
    """`outputs` and `hidden` are names, in which `*` stands for any text and `?` for one character. `scalar`: entries
    of arrays are variables of their own, also in FMI 3. `clocks`: FMI 3 tells of clocks."""

    outputs: tuple[str, ...] = ()
    hidden: tuple[str, ...] = ()
    scalar: bool = False
    clocks: bool = False


def shown(scalars: Sequence[Scalar], ports: Ports, sink: Sink, *, arrays: bool) -> list[Scalar]:
    """The scalars that the FMU has, outputs among them: those of the model and `ports.outputs`; its coordinates (or
    states) where there are none. An array is an output as a whole, where there are `arrays`.

    Reports E0925 for a name that is no variable which can be an output, E0926 for one that hides nothing, N0927 for
    coordinates that become outputs, N0929 for inputs that are hidden.
    """
    asked = _asked(scalars, ports.outputs, sink)
    if not ports.outputs and not any(scalar.attributes.role is Role.OUTPUT for scalar in scalars):
        asked = _natural(scalars, sink)
    wanted = {_identity(name, arrays=arrays) for name in asked}
    made = [
        _as_output(scalar)
        if scalar.attributes.role in _COMPUTED and _identity(scalar.name, arrays=arrays) in wanted
        else scalar
        for scalar in scalars
    ]
    hidden = _hidden(made, ports.hidden, sink)
    return [_without(scalar, ports.hidden) for place, scalar in enumerate(made) if place not in hidden]


def _without(scalar: Scalar, patterns: Sequence[str]) -> Scalar:
    """The variable without those of its other names that are protected or hidden."""
    kept = tuple(
        other
        for other in scalar.others
        if not other.protected and not any(_fits(other.name, pattern) for pattern in patterns)
    )
    return scalar if kept == scalar.others else replace(scalar, others=kept)


def _names(scalar: Scalar) -> list[Name]:
    return [scalar.name, *(other.name for other in scalar.others)]


def _asked(scalars: Sequence[Scalar], patterns: Sequence[str], sink: Sink) -> list[Name]:
    found = []
    possible = [scalar for scalar in scalars if scalar.attributes.role in (*_COMPUTED, Role.OUTPUT)]
    possible = [scalar for scalar in possible if scalar.attributes.causality in ("local", "output")]
    for pattern in patterns:
        own = [scalar.name for scalar in possible if any(_fits(name, pattern) for name in _names(scalar))]
        if not own:
            others = [name.text for scalar in possible for name in _names(scalar)]
            sink.report("E0925", None, help=did_you_mean(pattern, others), name=pattern)
        found += own
    return found


def _natural(scalars: Sequence[Scalar], sink: Sink) -> list[Name]:
    """Coordinates, without them the states of first order."""
    entries = [scalar for scalar in scalars if scalar.attributes.role in (Role.STATE, Role.DEPENDENT)]
    rates = {_identity(scalar.name, arrays=False) for scalar in entries if scalar.name.order == 1}
    states = [scalar.name for scalar in entries if scalar.name.order == 0]
    chosen = [name for name in states if _identity(replace(name, order=1), arrays=False) in rates] or states
    if chosen:
        names = [f"`{name.text}`" for name in chosen[:_MOST_NAMED]]
        more = f" and {len(chosen) - len(names)} more" if len(chosen) > len(names) else ""
        verb = "is an output" if len(chosen) == 1 else "are outputs"
        sink.report("N0927", None, names=f"{', '.join(names)}{more} {verb}", first=chosen[0].text)
    return chosen


def _as_output(scalar: Scalar) -> Scalar:
    return replace(scalar, attributes=replace(scalar.attributes, causality="output"), protected=False)


def _hidden(scalars: Sequence[Scalar], patterns: Sequence[str], sink: Sink) -> set[int]:
    """Places of what is protected or fits a pattern."""
    possible = [
        place
        for place, scalar in enumerate(scalars)
        if scalar.attributes.role not in _ALWAYS and scalar.derivative_of is None
    ]
    hidden = {place for place in possible if scalars[place].protected}
    for pattern in patterns:
        own = [place for place in possible if _fits(scalars[place].name, pattern)]
        others_too = (name for scalar in scalars for name in _names(scalar)[1:])
        if not own and not any(_fits(name, pattern) for name in others_too):
            others = [scalars[place].name.text for place in possible]
            sink.report("E0926", None, help=did_you_mean(pattern, others), name=pattern)
        _tell_inputs([scalars[place] for place in own if place not in hidden], pattern, sink)
        hidden.update(own)
    return hidden


def _tell_inputs(hidden: Sequence[Scalar], pattern: str, sink: Sink) -> None:
    names = [f"`{scalar.name.text}`" for scalar in hidden if scalar.attributes.role is Role.INPUT]
    if names:
        more = f" and {len(names) - _MOST_NAMED} more" if len(names) > _MOST_NAMED else ""
        sink.report("N0929", None, names=f"{', '.join(names[:_MOST_NAMED])}{more}", pattern=pattern)


def _fits(name: Name, pattern: str) -> bool:
    """A name is that of the language, `der(der(q[2]))`, or that of the FMU, `der(q[2],2)`; an array is all of it."""
    parts = re.split(r"([*?])", pattern)
    expression = "".join(".*" if part == "*" else "." if part == "?" else re.escape(part) for part in parts)
    own = (name.text, name.array)
    return any(re.fullmatch(expression, text) for text in own) or named(pattern).text in own


def _identity(name: Name, *, arrays: bool) -> tuple[object, ...]:
    return (name.path, name.order) if arrays else (name.path, name.order, name.indices)
