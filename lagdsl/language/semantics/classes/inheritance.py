"""A class with all that it inherits: short definitions and `extends` followed, sections merged."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import field
from typing import TypeAlias, assert_never

from lagdsl.foundation.diagnostics import Label
from lagdsl.foundation.record import mutable_record, record
from lagdsl.foundation.source import Span
from lagdsl.language.semantics.classes.modification import Given, check_duplicates, report_no_such, target
from lagdsl.language.semantics.scope.context import Context
from lagdsl.language.semantics.scope.imports import check_imports, declare_imports
from lagdsl.language.semantics.scope.scope import ClassSymbol, FunctionSymbol, Scope, TypeSymbol, lookup_path
from lagdsl.language.semantics.types.declarations import enter
from lagdsl.language.semantics.types.types import report_unknown_type
from lagdsl.language.syntax import nodes


@record()
class Part:
    """One item of a class or of a base; `scope` shares the entries of the instance but sees what its class sees."""

    item: nodes.Item
    scope: Scope
    section: str
    protected: bool


@mutable_record()
class Body:
    """`given` are the modifiers of `extends` and from outside, innermost first; `line` the class and its bases."""

    parts: list[Part] = field(default_factory=list)
    given: list[Given] = field(default_factory=list)
    line: list[nodes.Class] = field(default_factory=list)
    ways: dict[int, Way] = field(default_factory=dict)


@record()
class Way:
    """The way to a base class: its names, the `extends` that names it, the modifiers on the way there."""

    names: frozenset[str]
    item: nodes.Extends
    given: list[Given]

    def said(self) -> list[nodes.AnyModifier]:
        """The modifiers that concern the base."""
        return [modifier for modifier, _ in self.given if target(modifier) in self.names]


def class_at(ctx: Context, scope: Scope, name: nodes.Name) -> ClassSymbol | None:
    """The class that `name` means in `scope`, or None after E0208."""
    entry = lookup_path(scope, name.parts, name.span)
    if isinstance(entry, ClassSymbol) and entry.inner is None:
        return entry
    report_unknown_type(ctx, name, scope)
    return None


Step: TypeAlias = "tuple[nodes.ShortClass, Scope]"


def steps_to(ctx: Context, symbol: ClassSymbol) -> tuple[ClassSymbol, list[Step]] | None:
    """The class behind short definitions and these, outermost first, each with its scope; None after a diagnostic."""
    steps: list[Step] = []
    while isinstance(symbol.node, nodes.ShortClass):
        node = symbol.node
        if any(node is other for other, _ in steps):
            ctx.sink.report("E0305", node.span, path=f"model `{node.name}` is defined by itself")
            return None
        steps.append((node, symbol.scope))
        base = class_at(ctx, symbol.scope, node.base)
        if base is None:
            return None
        symbol = base
    return symbol, steps


def expand_short(
    ctx: Context, symbol: ClassSymbol, what: str, span: Span | None = None
) -> tuple[ClassSymbol, list[Given]] | None:
    """The class behind a short definition and the modifiers on the way, innermost first; None after a diagnostic.

    `what`, at `span`, needs one class, no array of them (E0245).
    """
    found = steps_to(ctx, symbol)
    if found is None:
        return None
    for node, _ in found[1]:
        if node.subscripts:
            sized = node.subscripts[0].span
            labels = [Label(sized, "its size")] if span is not None else []
            ctx.sink.report("E0245", span or sized, *labels, name=node.name, what=what)
            return None
        check_duplicates(ctx, node.modifiers)
    return found[0], [(modifier, scope) for node, scope in reversed(found[1]) for modifier in node.modifiers]


def body_of(ctx: Context, node: nodes.Class, scope: Scope, given: list[Given]) -> Body:
    """All parts of the class in order, a base's where its `extends` stands; names of classes are entered.

    `given` are the modifiers from outside, innermost first: they may redeclare classes.
    """
    body = Body()
    _collect(ctx, node, scope, given, body, protected=False, below=())
    body.given += given
    return body


def _collect(
    ctx: Context,
    node: nodes.Class,
    scope: Scope,
    given: list[Given],
    body: Body,
    *,
    protected: bool,
    below: tuple[nodes.Class, ...],
) -> frozenset[str]:
    """Adds the parts of the class; its names, inherited ones included."""
    body.line.append(node)
    own = [Part(item, scope, keyword, protected or keyword == "protected") for item, keyword in items_of(node)]
    declare_imports(ctx.sink, scope, [part.item for part in own])
    if node.span.file is ctx.conventions.home:
        check_imports(scope)
    for part in own:
        enter_class(ctx, part, given)
    names = set(names_in(part.item for part in own))
    for part in own:
        if isinstance(part.item, nodes.Extends):
            names |= _extend(ctx, part.item, part, given, body, (*below, node))
        else:
            body.parts.append(part)
    return frozenset(names)


def items_of(node: nodes.Class) -> Iterator[tuple[nodes.Item, str]]:
    """The items of a class with the keyword of their section."""
    for item in node.items:
        yield item, "public"
    for section in node.sections:
        for item in section.items:
            yield item, section.keyword


def names_in(items: Iterable[nodes.Item]) -> Iterator[str]:
    """The names that items of a class declare, those in branches and loops included."""
    for item in items:
        match item:
            case nodes.Component() | nodes.Coordinate() | nodes.Geometry():
                yield from (declarator.name for declarator in item.declarators)
            case nodes.Class() | nodes.ShortClass():
                yield item.name
            case nodes.For():
                yield from names_in(item.body)
            case nodes.If():
                for branch in item.branches:
                    yield from names_in(branch.body)
                yield from names_in(item.otherwise or ())
            case nodes.Import() | nodes.TypeDefinition() | nodes.Function() | nodes.Physics() | nodes.Relation():
                pass
            case nodes.Extends() | nodes.Annotation() | nodes.When():
                pass
            case _:
                assert_never(item)


def enter_class(ctx: Context, part: Part, given: list[Given]) -> None:
    """Enter the name of a class, type or function; a class is the one that the outermost `redeclare` puts there."""
    item, scope = part.item, part.scope
    match item:
        case nodes.Function():
            enter(ctx, scope, item.name, FunctionSymbol(item, scope), item.span)
        case nodes.TypeDefinition():
            enter(ctx, scope, item.name, TypeSymbol(item, scope), item.span)
        case nodes.Class() | nodes.ShortClass():
            span = item.name_span if isinstance(item, nodes.Class) else item.span
            enter(ctx, scope, item.name, _redeclared(ctx, item, span, given) or ClassSymbol(item, scope), span)
        case nodes.Import() | nodes.Declaration() | nodes.Physics() | nodes.Relation() | nodes.Block():
            pass
        case nodes.Extends() | nodes.Annotation():
            pass
        case _:
            assert_never(item)


def _redeclared(
    ctx: Context, item: nodes.Class | nodes.ShortClass, span: Span, given: list[Given]
) -> ClassSymbol | None:
    found = [(each, scope) for each, scope in given if target(each) == item.name]
    for modifier, _ in found:
        if not isinstance(modifier, nodes.RedeclareClass):
            hint = f"put another class there: `redeclare {item.kind} {item.name} = ...`"
            ctx.sink.report("E0236", modifier.span, Label(span, "declared here"), name=item.name, help=hint)
        elif "replaceable" not in item.prefixes:
            ctx.sink.report("E0235", modifier.span, Label(span, "declared here"), name=item.name, kind=item.kind)
    classes = [(each, scope) for each, scope in found if isinstance(each, nodes.RedeclareClass)]
    if not classes or "replaceable" not in item.prefixes:
        return None
    modifier, scope = classes[-1]
    assert isinstance(modifier, nodes.RedeclareClass)
    short = nodes.ShortClass(
        span=modifier.span,
        prefixes=(),
        kind=modifier.kind,
        name=modifier.name,
        base=modifier.type_name,
        subscripts=(),
        modifiers=modifier.modifiers,
        doc=None,
    )
    return ClassSymbol(short, scope, instead=(modifier.span, item.name))


def _extend(
    ctx: Context, item: nodes.Extends, part: Part, given: list[Given], body: Body, below: tuple[nodes.Class, ...]
) -> frozenset[str]:
    """Adds the parts of the base; its names."""
    symbol = class_at(ctx, part.scope, item.base)
    expanded = expand_short(ctx, symbol, "`extends`", item.base.span) if symbol is not None else None
    if expanded is None:
        ctx.reports.incomplete = True
        return frozenset()
    base, short = expanded
    assert isinstance(base.node, nodes.Class)
    if any(base.node is other for other in below):
        _report_circle(ctx, item, base.node, below)
        return frozenset()
    check_duplicates(ctx, item.modifiers)
    own = [*short, *((modifier, part.scope) for modifier in item.modifiers)]
    known = body.ways.get(id(base.node))
    if known is None:
        view = _view(base, base.node, part.scope)
        names = _collect(ctx, base.node, view, [*own, *given], body, protected=part.protected, below=below)
        known = body.ways[id(base.node)] = Way(names, item, [*own, *given])
    elif known.said() != Way(known.names, item, [*own, *given]).said():
        label = Label(known.item.span, "with other modifiers here")
        ctx.sink.report("E0243", item.span, label, name=base.node.name)
    for modifier, scope in own:
        if target(modifier) in known.names:
            body.given.append((modifier, scope))
        elif not ctx.reports.incomplete:
            report_no_such(ctx, modifier, target(modifier), base.node, sorted(known.names))
    return known.names


def _report_circle(ctx: Context, item: nodes.Extends, base: nodes.Class, below: tuple[nodes.Class, ...]) -> None:
    names = [each.name for each in below[[each is base for each in below].index(True) :]] + [base.name]
    path = " extends ".join(f"`{name}`" for name in names)
    labels = [Label(each.name_span, f"`{each.name}` is declared here") for each in below]
    ctx.sink.report("E0226", item.span, *labels, path=path)


def _view(base: ClassSymbol, node: nodes.Class, scope: Scope) -> Scope:
    """The names of the instance as the text of a base sees them."""
    return Scope(
        "class",
        f"`{node.name}`",
        base.scope,
        scope.prefix,
        scope.spans,
        entries=scope.entries,
        text=node.span,
        instance=scope.instance,
    )
