"""Scopes and symbols: who is meant by a name.

Lookup goes outward: loop indices and function arguments, the class, enclosing classes and the file (constants, types,
functions only); then the imports of these, named ones before wildcards; then installed packages, which the outermost
scope finds; the prelude is asked by the caller. A package
that is a folder finds a name in its files when it is asked for it. A scope carries the prefix of qualified names and
the stack of spans of the instance it belongs to, so that instances of classes can nest.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import field
from typing import Literal, Protocol, TypeAlias

from lagdsl.foundation.record import mutable_record, record
from lagdsl.foundation.source import Span
from lagdsl.foundation.units import Dimension
from lagdsl.language.semantics.scope.prelude import BaseType
from lagdsl.language.semantics.scope.values import Poison, Scalar, Value
from lagdsl.language.syntax import nodes

SymbolKind: TypeAlias = Literal[
    "constant",
    "structural",
    "parameter",
    "input",
    "output",
    "state",
    "discrete",
    "algebraic",
    "coordinate",
    "point",
    "frame",
    "energy",
    "load",
    "constraint",
    "contact",
    "friction",
    "body",
    "invariant",
    "unknown",
]
Indices: TypeAlias = "tuple[int, ...]"

LABELS = ("energy", "load", "constraint", "contact", "friction", "body", "invariant")


@record()
class TypeInfo:
    """`dimension` is None for a plain `Real`, which a binding may determine. `modifiers` come from type definitions,
    `literals` are those of an enumeration, with texts in `literal_docs`; `is_difference`: an amount of temperature, not
    a point on its scale."""

    name: str
    base: BaseType
    dimension: Dimension | None
    unit: str
    display_unit: str | None = None
    minimum: float | None = None
    shape: tuple[tuple[nodes.Subscript, Scope] | int, ...] = ()
    modifiers: tuple[tuple[nodes.AnyModifier, Scope], ...] = ()
    quaternion: bool = False
    is_difference: bool = False
    literals: tuple[str, ...] = ()
    literal_docs: tuple[str | None, ...] = ()
    doc: str | None = None


@mutable_record()
class Binding:
    """The text that gives a value, with the scope it is read in (it holds the loop indices)."""

    node: nodes.Expression
    scope: Scope
    span: Span


def bindings_of(kind: SymbolKind, value: Binding, *, array: bool) -> dict[Indices | None, Binding]:
    """The bindings of a symbol by one text: frames in braces are frames one by one, for there is no value that holds
    several."""
    if kind == "frame" and array and isinstance(value.node, nodes.Array):
        return {(i,): Binding(each, value.scope, value.span) for i, each in enumerate(value.node.elements, 1)}
    return {() if kind in ("point", "frame") and not array else None: value}


Labelled: TypeAlias = (
    nodes.Energy | nodes.Load | nodes.Constraint | nodes.Contact | nodes.Friction | nodes.RigidBody | nodes.Invariant
)


@mutable_record()
class LabelInstance:
    """One labelled item; inside loops there is one for each set of indices."""

    node: Labelled
    scope: Scope
    name: str


@mutable_record()
class Given:
    """The texts that give a symbol its values, by index; None stands for all of an array.

    `overrides` are modifiers from outside, outer ones last; `sealed` is the place of the `final` one, after which none
    is allowed, and `final` the word at the declaration.
    """

    bindings: dict[Indices | None, Binding] = field(default_factory=dict)
    derivatives: dict[Indices | None, Binding] = field(default_factory=dict)
    overrides: list[tuple[tuple[nodes.AnyModifier, ...], Scope]] = field(default_factory=list)
    final: bool = False
    sealed: Span | None = None


@mutable_record()
class Made:
    """State of a symbol so far: its shape, its values and labelled items by index, whether it is read."""

    shape: tuple[int, ...] | None = None
    cells: dict[Indices, Value] = field(default_factory=dict)
    labels: dict[Indices, LabelInstance] = field(default_factory=dict)
    used: bool = False


@mutable_record()
class Symbol:
    """A declared name, before and while it gets its value. `prefixes` are the words before its type."""

    name: str
    kind: SymbolKind
    span: Span
    scope: Scope
    title: str
    declarator: nodes.Declarator | None = None
    info: TypeInfo | None = None
    prefixes: tuple[str, ...] = ()
    given: Given = field(default_factory=Given)
    made: Made = field(default_factory=Made)

    @property
    def word(self) -> str:
        """Kind of the symbol, for diagnostics."""
        return {"structural": "structural parameter", "algebraic": "variable", "unknown": "name"}.get(
            self.kind, self.kind
        )

    @property
    def flow(self) -> bool:
        """True if the values of connected ones sum up to zero."""
        return "flow" in self.prefixes

    @property
    def is_name(self) -> bool:
        """True if it stands for its binding: a variable, or an input of a component that is bound or has a default."""
        return self.kind in ("algebraic", "output") or (
            self.kind == "input" and bool(self.scope.spans) and bool(self.given.bindings)
        )

    @property
    def short(self) -> str:
        return self.declarator.name if self.declarator is not None else self.name.rpartition(".")[2]


@mutable_record()
class FunctionSymbol:
    node: nodes.Function
    scope: Scope


@mutable_record()
class TypeSymbol:
    node: nodes.TypeDefinition | nodes.ShortClass
    scope: Scope


@mutable_record()
class ClassSymbol:
    """A class; `inner` holds the names of a package.

    `instead`: the place of the `redeclare` that put it in, and the name of the class it stands in for.
    """

    node: nodes.Class | nodes.ShortClass
    scope: Scope
    inner: Scope | None = None
    instead: tuple[Span, str] | None = None


@mutable_record()
class Instance:
    """A component: one instance of a class, with its names in a scope of its own (prefix `arm.`, `wheel[2].`).

    `protected` are the names that may not be reached from outside. `members` are
    its quantities and components in the order of the text. A component whose condition is false is not `present`;
    `conditions` of parameters, its own and those of the components around, switch what it contributes. `around` is the
    scope in which it is declared, None for the model itself. `misfit`: a modifier of it was wrong, so that what has no
    value may have been meant by that.
    """

    name: str
    span: Span
    definition: ClassSymbol
    scope: Scope
    protected: set[str] = field(default_factory=set)
    members: list[Symbol | Instance | InstanceArray] = field(default_factory=list)
    present: bool = True
    conditions: tuple[tuple[Scalar, Span], ...] = ()
    around: Scope | None = None
    misfit: bool = False

    @property
    def kind(self) -> str:
        """The keyword of its class."""
        return self.definition.node.kind


@mutable_record()
class InstanceArray:
    """An array of components by their 1-based indices."""

    name: str
    span: Span
    shape: tuple[int, ...]
    elements: dict[Indices, Instance] = field(default_factory=dict)


Entry: TypeAlias = "Symbol | Instance | InstanceArray | FunctionSymbol | TypeSymbol | ClassSymbol | Value"
ScopeKind: TypeAlias = Literal["file", "class", "local"]


class Files(Protocol):
    """Names that stand in files of their own, read when they are first asked for; `span` is where that is."""

    def find(self, name: str, span: Span | None) -> Entry | None: ...

    def names(self) -> Iterable[str]: ...


class Root(Files, Protocol):
    """The names that an import may begin with."""

    def places(self, name: str) -> tuple[str, ...]:
        """Places in which `name` was looked up, in words."""


class Imports(Protocol):
    """The imports of one scope."""

    def named(self, name: str, span: Span | None) -> Entry | None: ...

    def wildcard(self, name: str, span: Span | None) -> Entry | None: ...

    def is_broken(self) -> bool: ...

    def names(self) -> Iterable[str]: ...


@mutable_record()
class Outside:
    """Sources of names that the text of a scope does not declare: imports, the files of a package, and `root`, the
    names that an import may begin with."""

    imports: Imports | None = None
    files: Files | None = None
    root: Root | None = None


@mutable_record()
class Scope:
    """`path` are the indices of the loops around, for labels; `title` names the scope in diagnostics.

    The scope of a class knows the place of its `text` and the `instance` that it is of.
    """

    kind: ScopeKind
    title: str
    parent: Scope | None = None
    prefix: str = ""
    spans: tuple[Span, ...] = ()
    path: Indices = ()
    entries: dict[str, Entry] = field(default_factory=dict)
    outside: Outside = field(default_factory=Outside)
    text: Span | None = None
    instance: Instance | None = None

    def find(self, name: str, span: Span | None = None) -> Entry | None:
        """The entry of this scope itself: declared, or in a file of the package."""
        entry = self.entries.get(name)
        if entry is None and self.outside.files is not None:
            entry = self.outside.files.find(name, span)
        return entry

    def names(self) -> Iterator[str]:
        """The names that `find` knows, without reading their files."""
        yield from self.entries
        if self.outside.files is not None:
            yield from self.outside.files.names()

    def qualify(self, name: str) -> str:
        return f"{self.prefix}{name}"

    def local(self, entries: dict[str, Entry], path: Indices = ()) -> Scope:
        """A scope for loop indices or function arguments inside this one."""
        return Scope("local", self.title, self, self.prefix, self.spans, self.path + path, entries)

    def of_function(self, entries: dict[str, Entry]) -> Scope:
        """The scope of a function's body: its arguments, and outside it constants, types and functions only."""
        return Scope("class", self.title, self, self.prefix, self.spans, self.path, entries)

    def chain(self) -> Iterator[Scope]:
        scope: Scope | None = self
        while scope is not None:
            yield scope
            scope = scope.parent

    @property
    def owner(self) -> Scope:
        """The class or file around."""
        return next(scope for scope in self.chain() if scope.kind != "local")


def lookup(scope: Scope, name: str, span: Span | None = None) -> Entry | None:
    """The entry that `name` means in `scope`, without the prelude; `span` is the place that asks."""
    own = True
    for step in scope.chain():
        entry = step.find(name, span) if step.parent is not None else step.entries.get(name)
        if entry is not None and (own or _is_constant(entry)):
            return entry
        own = own and step.kind == "local"
    return _imported(scope, name, span) or step.find(name, span)


def _is_constant(entry: Entry) -> bool:
    """True if classes inside see it: constants, types, functions and classes."""
    if isinstance(entry, Symbol):
        return entry.kind in ("constant", "structural")
    return not isinstance(entry, Instance | InstanceArray)


def lookup_path(scope: Scope, parts: tuple[str, ...], span: Span | None = None) -> Entry | None:
    """The entry of a dotted name: the first part as `lookup`, the others in the package before them."""
    entry = lookup(scope, parts[0], span)
    for part in parts[1:]:
        if not isinstance(entry, ClassSymbol) or entry.inner is None:
            return entry if isinstance(entry, Poison) else None
        entry = entry.inner.find(part, span)
    return entry


def _imported(scope: Scope, name: str, span: Span | None) -> Entry | None:
    around = [step.outside.imports for step in scope.chain() if step.outside.imports is not None]
    for imports in around:
        if (entry := imports.named(name, span)) is not None:
            return entry
    for imports in around:
        if (entry := imports.wildcard(name, span)) is not None:
            return entry
    return None


def is_guess(scope: Scope) -> bool:
    """True if a name could have come from an import that leads nowhere."""
    return any(step.outside.imports is not None and step.outside.imports.is_broken() for step in scope.chain())


def visible(scope: Scope) -> Iterator[tuple[str, Entry]]:
    """Every name that `lookup` can find, innermost first."""
    seen: set[str] = set()
    for step in scope.chain():
        for name in step.entries:
            if name not in seen:
                seen.add(name)
                entry = lookup(scope, name)
                if entry is not None:
                    yield name, entry


def reachable(scope: Scope) -> Iterator[str]:
    """Names of packages and classes that a text in `scope` could mean and that may stand in files not read yet."""
    for step in scope.chain():
        if step.outside.files is not None:
            yield from step.outside.files.names()
        if step.outside.imports is not None:
            yield from step.outside.imports.names()
