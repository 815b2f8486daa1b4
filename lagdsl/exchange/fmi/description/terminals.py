"""terminalsAndIcons.xml of FMI 3: which variables belong to one port of the mechanism.

A port is a coordinate on which an input acts as its force, with what outputs tell of its motion; or a motion that is
given, with its time derivatives. Members are called as those of flanges are in Modelica: phi, w, a, tau of what turns,
s, v, a, f of what slides.
"""

from __future__ import annotations

from lagdsl.exchange.fmi.description.xml import document, element
from lagdsl.exchange.fmi.variables.names import named
from lagdsl.exchange.fmi.variables.variables import Table
from lagdsl.foundation.record import record
from lagdsl.foundation.units import Dimension
from lagdsl.foundation.units.dimension import DIMENSIONLESS, LENGTH
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.model import Coordinate, Definition, FlatModel, GeneralizedForce, Input

# Names of members: motion with its derivatives, and force.
_MEMBERS: dict[Dimension, tuple[tuple[str, ...], str]] = {
    DIMENSIONLESS: (("phi", "w", "a"), "tau"),
    LENGTH: (("s", "v", "a"), "f"),
}
_CORNERS = {"x1": -100, "y1": -100, "x2": 100, "y2": 100}


@record(kw_only=True)
class Member:
    variable: str
    name: str
    kind: str


@record(kw_only=True)
class Terminal:
    name: str
    doc: str
    members: tuple[Member, ...]


def terminals(table: Table) -> str | None:
    """Text of the file, with the place of the icon; None in FMI 2, which has no such file."""
    if table.version == 2:
        return None
    variables = {variable.name for variable in table.variables}
    root = element("fmiTerminalsAndIcons", fmiVersion="3.0")
    picture = element("GraphicalRepresentation", root)
    element("CoordinateSystem", picture, **_CORNERS, suggestedScalingFactorTo_mm=0.1)
    element("Icon", picture, **_CORNERS)
    every = element("Terminals")
    for terminal in [*_loaded(table.flat), *_prescribed(table.flat)]:
        members = [member for member in terminal.members if member.variable in variables]
        if len(members) < len(terminal.members):  # entries of arrays have no names of their own
            continue
        port = element("Terminal", every, name=terminal.name, matchingRule="plug", description=terminal.doc)
        for member in members:
            element(
                "TerminalMemberVariable",
                port,
                variableName=member.variable,
                memberName=member.name,
                variableKind=member.kind,
            )
    if len(every):
        root.append(every)
    return document(root)


def _loaded(flat: FlatModel) -> list[Terminal]:
    """Coordinates with inputs as forces, of which outputs tell something."""
    coordinates = {c.name: c for c in flat.coordinates if c.dimension in _MEMBERS}
    inputs = {item.name for item in flat.inputs}
    definitions = {item.name: item for item in flat.named if isinstance(item, Definition)}
    seen: dict[str, dict[int, str]] = {}
    for output in flat.outputs:
        of, order = _plain(output.value, definitions)
        seen.setdefault(of, {}).setdefault(order, named(output.name).text)
    found: dict[str, Terminal] = {}
    for load in flat.loads:
        if not isinstance(load, GeneralizedForce) or load.origin is not None:
            continue
        (force, _), (on, order) = _plain(load.value, definitions), _plain(load.target, definitions)
        if force in inputs and on in coordinates and order == 0 and on in seen and on not in found:
            found[on] = _port(coordinates[on], named(force).text, seen[on])
    return list(found.values())


def _port(coordinate: Coordinate, force: str, outputs: dict[int, str]) -> Terminal:
    motion, effort = _MEMBERS[coordinate.dimension]
    told = [
        Member(variable=outputs[order], name=name, kind="signal")
        for order, name in enumerate(motion)
        if order in outputs
    ]
    return Terminal(
        name=named(coordinate.name).text,
        doc=f"force on {coordinate.name} and its motion",
        members=(*told, Member(variable=force, name=effort, kind="inflow")),
    )


def _prescribed(flat: FlatModel) -> list[Terminal]:
    """Inputs that come with their time derivatives."""
    return [
        Terminal(
            name=named(item.name).text,
            doc=f"motion {item.name} that is given, with its derivatives",
            members=tuple(
                Member(variable=named(item.name, order).text, name=name, kind="signal")
                for order, name in enumerate(_motion(item))
            ),
        )
        for item in flat.inputs
        if item.smooth and item.derivative_of is None and item.dimension in _MEMBERS
    ]


def _motion(item: Input) -> tuple[str, ...]:
    """Names of the members, beyond the second derivative with their order."""
    names, _ = _MEMBERS[item.dimension]
    beyond = (f"d{order}{names[0]}" for order in range(len(names), item.smooth + 1))
    return (*names[: item.smooth + 1], *beyond)


def _plain(expression: fx.FlatExpression, definitions: dict[str, Definition]) -> tuple[str, int]:
    """The variable that it only renames, and how many time derivatives of it are meant; an empty name for all else."""
    order = 0
    while True:
        if isinstance(expression, fx.Derivative):
            expression, order = expression.operand, order + 1
        elif not isinstance(expression, fx.Variable):
            return "", 0
        elif expression.name in definitions:
            expression = definitions[expression.name].value
        else:
            return expression.name, order
