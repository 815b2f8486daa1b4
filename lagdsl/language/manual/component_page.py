"""The page of a component: parameters with defaults, ports, variables, equations, text. `lag explain DCMotor`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from lagdsl.foundation.record import record
from lagdsl.language.manual.library import LibraryClass, library_class, lineage
from lagdsl.language.semantics.scope.prelude import TYPES
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.printer import print_expression

_EQUATIONS = (
    nodes.Energy,
    nodes.PointMass,
    nodes.RigidBody,
    nodes.Load,
    nodes.Constraint,
    nodes.Contact,
    nodes.Friction,
    nodes.Equation,
    nodes.When,
    nodes.For,
    nodes.If,
)


@record(kw_only=True)
class Row:
    """A row of a table: a parameter, a port or a variable."""

    group: str
    name: str
    kind: str
    unit: str
    default: str
    doc: str


def component_page(name: str) -> str:
    """The page of the class of the full name `name`, as Markdown."""
    found = library_class(name)
    chain = list(lineage(found))
    rows = [row for ancestor, modifiers in chain for row in _rows(ancestor, modifiers)]
    lines = [f"# {name}", "", f"{found.node.doc or _inherited_doc(chain)}.", ""]
    lines += [*_facts(found, chain)]
    lines += _table("Parameters", ("name", "type", "unit", "default", ""), [r for r in rows if r.group == "parameter"])
    lines += _table("Ports", ("name", "kind", "unit", "default", ""), [r for r in rows if r.group == "port"])
    lines += _table("Inputs", ("name", "type", "unit", "default", ""), [r for r in rows if r.group == "input"])
    lines += _table("Variables", ("name", "type", "unit", "value", ""), [r for r in rows if r.group == "variable"])
    lines += _equations(ancestor for ancestor, _ in chain)
    lines += ["## Text", "", "```modelica fragment", found.node.span.text, "```", ""]
    return "\n".join(lines)


def _inherited_doc(chain: list[tuple[LibraryClass, tuple[nodes.AnyModifier, ...]]]) -> str:
    return next((a.node.doc for a, _ in reversed(chain) if a.node.doc), "")


def _facts(found: LibraryClass, chain: list[tuple[LibraryClass, tuple[nodes.AnyModifier, ...]]]) -> Iterator[str]:
    yield f"- Kind: {' '.join((*found.node.prefixes, found.node.kind))}"
    ancestors = [f"`{ancestor.name}`" for ancestor, _ in chain[:-1]]
    if ancestors:
        yield f"- Inherits from: {', '.join(reversed(ancestors))}"
    yield f"- Import: `import {found.name};`"
    yield ""


def _rows(found: LibraryClass, modifiers: tuple[nodes.AnyModifier, ...]) -> Iterator[Row]:
    """The public declarations of one class; `modifiers` are those of the classes that extend it."""
    if isinstance(found.node, nodes.ShortClass):
        return
    given = {".".join(m.name.parts): m.value for m in modifiers if isinstance(m, nodes.Modifier)}
    public = [section.items for section in found.node.sections if section.keyword == "public"]
    for item in (*found.node.items, *(item for items in public for item in items)):
        if isinstance(item, nodes.Component | nodes.Coordinate | nodes.Geometry):
            kind = item.keyword if isinstance(item, nodes.Geometry) else ".".join(item.type_name.parts)
            docs = _docs(item.declarators)
            for declarator, doc in zip(item.declarators, docs, strict=True):
                yield _row(item, kind, declarator, doc, given.get(declarator.name))


def _docs(declarators: tuple[nodes.Declarator, ...]) -> list[str]:
    """The doc strings of one statement. One at its end is for all; parts between `;` are for one name each."""
    last = declarators[-1].doc or ""
    if any(declarator.doc for declarator in declarators[:-1]):
        return [declarator.doc or "" for declarator in declarators]
    parts = last.split("; ")
    return parts if len(parts) == len(declarators) else [last] * len(declarators)


def _row(
    item: nodes.Component | nodes.Coordinate | nodes.Geometry,
    kind: str,
    declarator: nodes.Declarator,
    doc: str,
    given: nodes.Expression | None,
) -> Row:
    value = declarator.value if given is None else given
    size = f"[{', '.join(s.span.text for s in declarator.subscripts)}]" if declarator.subscripts else ""
    attributes = [m.span.text for m in declarator.modifiers]
    default = "" if value is None else f"`{_one_line(value)}`"
    if attributes:
        default = f"{default} (`{', '.join(attributes)}`)".strip()
    known = TYPES.get(kind)
    return Row(
        group=_group(item, value),
        name=f"`{declarator.name}{size}`",
        kind=_kind(item, kind),
        unit="" if known is None or known.unit == "1" else known.unit,
        default=default,
        doc=doc,
    )


def _one_line(value: nodes.Expression) -> str:
    return print_expression(value).replace("|", "\\|")


def _group(item: nodes.Component | nodes.Coordinate | nodes.Geometry, value: nodes.Expression | None) -> str:
    match item:
        case nodes.Coordinate():
            return "port"
        case nodes.Geometry():
            return "port" if value is None or item.keyword == "frame" else "variable"
        case nodes.Component(prefixes=prefixes, type_name=kind):
            if "parameter" in prefixes:
                return "parameter"
            if "input" in prefixes:
                return "input"
            return "port" if kind.parts == ("Pin",) else "variable"


def _kind(item: nodes.Component | nodes.Coordinate | nodes.Geometry, kind: str) -> str:
    """`structural` and `final` parameters are told; other prefixes are the table's."""
    match item:
        case nodes.Coordinate():
            return f"coordinate {kind}"
        case nodes.Component(prefixes=prefixes):
            told = [prefix for prefix in prefixes if prefix not in ("parameter", "input")]
            return " ".join((*told, kind))
        case nodes.Geometry():
            return kind


def _table(title: str, head: tuple[str, ...], rows: list[Row]) -> list[str]:
    if not rows:
        return []
    cells = [(r.name, r.kind, r.unit, r.default, r.doc.replace("|", "\\|")) for r in rows]
    kept = [k for k in range(len(head)) if k == 0 or any(row[k] for row in cells)]
    lines = [f"## {title}", "", _line(head[k] for k in kept), _line("---" for _ in kept)]
    return [*lines, *(_line(row[k] for k in kept) for row in cells), ""]


def _line(cells: Iterable[str]) -> str:
    return f"| {' | '.join(cells)} |"


def _equations(chain: Iterable[LibraryClass]) -> list[str]:
    """The statements that say what the class adds to the model, those of its ancestors first."""
    texts: list[str] = []
    for found in chain:
        if isinstance(found.node, nodes.Class):
            for keyword, items in [("", found.node.items), *((s.keyword, s.items) for s in found.node.sections)]:
                headed = keyword not in ("", "public", "protected")
                said = [f"{'  ' * headed}{item.span.text}" for item in items if isinstance(item, _EQUATIONS)]
                texts += [keyword, *said] if said and headed else said
    if not texts:
        return []
    return ["## Equations", "", "```modelica fragment", *texts, "```", ""]
