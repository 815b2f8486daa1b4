"""Tables of the page in an FMU: ports, parameters, statements of the model with the components that hold them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from lagdsl.documents.report.document import Block, Code, Heading, Inline, Table, text
from lagdsl.exchange.fmi.description.xml import start_text
from lagdsl.exchange.fmi.variables.scalar import Role, Variable
from lagdsl.exchange.fmi.variables.variables import Table as Variables
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.flat.quantity import Item

_LONGEST = 200
_WHEN = {"START": "before the start", "TUNABLE": "at any time", "ALWAYS": "at any time", "NEVER": "never"}
# Statements of the flat model by the words of the language.
_STATEMENTS = ("energies", "masses", "bodies", "loads", "constraints", "invariants", "assertions", "initial_equations")


def tables(variables: Variables) -> tuple[Block, ...]:
    """Sections with these tables; those that would be empty are left out."""
    shown = [v for v in variables.variables if v.attributes.role is not Role.OPTION]
    ports = [v for v in shown if v.attributes.causality in ("input", "output")]
    parameters = [v for v in shown if v.attributes.causality in ("parameter", "calculatedParameter")]
    return (
        *_section("Ports", ("name", "port", "type", "values", "start", "description"), _ports(ports)),
        *_section(
            "Parameters of the FMU",
            ("name", "value", "unit", "values", "may be set", "description"),
            _settings(parameters),
        ),
        *_section("Statements and their components", ("component", "statement"), _statements(variables.flat)),
    )


def _section(title: str, header: tuple[str, ...], rows: Iterable[tuple[Inline, ...]]) -> tuple[Block, ...]:
    found = tuple(rows)
    return (Heading(title), Table(header, found)) if found else ()


def _ports(variables: Sequence[Variable]) -> Iterator[tuple[Inline, ...]]:
    for variable in variables:
        attributes = variable.attributes
        unit = "" if attributes.unit in (None, "1") else f" [{attributes.unit}]"
        kind = attributes.type_name or attributes.type.capitalize()
        yield (
            (Code(_shaped(variable)),),
            text(f"{attributes.causality}, {attributes.variability}"),
            text(f"{kind}{unit}"),
            text(_values(variable)),
            text(_start(variable)),
            text(attributes.doc or ""),
        )


def _settings(variables: Sequence[Variable]) -> Iterator[tuple[Inline, ...]]:
    for variable in variables:
        attributes = variable.attributes
        yield (
            (Code(_shaped(variable)),),
            text(_start(variable)),
            text("" if attributes.unit in (None, "1") else attributes.unit or ""),
            text(_values(variable)),
            text(_WHEN[attributes.setting]),
            text(attributes.doc or ""),
        )


def _shaped(variable: Variable) -> str:
    return f"{variable.name}[{', '.join(map(str, variable.shape))}]" if variable.shape else variable.name


def _start(variable: Variable) -> str:
    return start_text(variable.attributes.type, variable.starts) or ""


def _values(variable: Variable) -> str:
    """The range, or the literals of an enumeration with their texts."""
    attributes = variable.attributes
    if attributes.literals:
        texts = zip(attributes.literals, attributes.literal_docs, strict=True)
        return ", ".join(f"{place} {name}" + (f" ({doc})" if doc else "") for place, (name, doc) in enumerate(texts, 1))
    low, high = attributes.minimum, attributes.maximum
    if low is None:
        return "" if high is None else f"up to {high:g}"
    return f"from {low:g}" if high is None else f"{low:g} to {high:g}"


def _statements(flat: FlatModel) -> Iterator[tuple[Inline, ...]]:
    """In the order of the text within each kind; statements that the compiler wrote have none."""
    groups: list[Sequence[Item]] = [getattr(flat, name) for name in _STATEMENTS]
    groups += [flat.events.contacts, flat.events.frictions, flat.events.whens]
    seen: set[tuple[str, str]] = set()
    for group in groups:
        for item in group:
            if not item.spans or not item.spans[0].text:
                continue
            owner = ".".join(span.text for span in reversed(item.spans[1:])) or flat.name
            words = " ".join(item.spans[0].text.split())
            words = words if len(words) <= _LONGEST else f"{words[: _LONGEST - 2]} …"
            if (owner, words) not in seen:
                seen.add((owner, words))
                yield ((Code(owner),), (Code(words),))
