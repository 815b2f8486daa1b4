"""`import A.B;`, `import X = A.B;`, `import A.{b, c};`, `import A.*;`: names from elsewhere.

An import names from the top: a class of the same file or what lies beside the file, in LAGPATH, in the library. It is
followed when a name is asked for; it is neither inherited nor seen from outside.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import field

from lagdsl.foundation.diagnostics import Label, Sink
from lagdsl.foundation.diagnostics.catalog.habits import package_help
from lagdsl.foundation.diagnostics.catalog.modelica import import_help
from lagdsl.foundation.diagnostics.suggest import did_you_mean
from lagdsl.foundation.record import mutable_record, record
from lagdsl.foundation.source import Span
from lagdsl.language.semantics.scope.scope import ClassSymbol, Entry, Root, Scope, lookup_path
from lagdsl.language.semantics.scope.values import POISON
from lagdsl.language.syntax import nodes

_DEEPEST = 50  # short classes behind one another


@record()
class Target:
    """Meaning of one name of an import."""

    parts: tuple[str, ...]
    span: Span


@mutable_record()
class ImportList:
    """The imports of one scope: `Imports` of it."""

    sink: Sink
    root: Root
    targets: dict[str, Target] = field(default_factory=dict)
    wildcards: list[Target] = field(default_factory=list)
    ambiguous: set[str] = field(default_factory=set)
    packages: dict[tuple[str, ...], Scope] = field(default_factory=dict)

    def named(self, name: str, span: Span | None) -> Entry | None:
        target = self.targets.get(name)
        return None if target is None else follow(self.sink, self.root, target)

    def wildcard(self, name: str, span: Span | None) -> Entry | None:
        """The one that the wildcards give; E0203 where two give different ones."""
        found: list[tuple[Target, Entry]] = []
        for target in self.wildcards:
            package = self._package(target)
            entry = package.find(name, span) if package is not None else None
            if entry is not None and all(_identity(entry) is not _identity(other) for _, other in found):
                found.append((target, entry))
        if len(found) > 1:
            self._report(name, span, [target for target, _ in found])
            return POISON
        return found[0][1] if found else None

    def is_broken(self) -> bool:
        """True if a wildcard leads nowhere: what it was to bring is unknown then."""
        return any(self._package(target) is None for target in self.wildcards)

    def _package(self, target: Target) -> Scope | None:
        """The package of a wildcard; a path that leads to one is followed once."""
        found = self.packages.get(target.parts) or package_of(self.sink, self.root, target)
        if found is not None:
            self.packages[target.parts] = found
        return found

    def _report(self, name: str, span: Span | None, targets: list[Target]) -> None:
        if name in self.ambiguous:
            return
        self.ambiguous.add(name)
        places = [Label(target.span, f"has a `{name}`") for target in targets]
        names = " and ".join(f"`{'.'.join(target.parts)}.*`" for target in targets)
        way = f"say which: `import {'.'.join(targets[0].parts)}.{name};`, or write the full name"
        primary = places.pop() if span is None else span
        self.sink.report("E0203", primary, *places, name=name, imports=names, help=way)

    def names(self) -> Iterator[str]:
        yield from self.targets
        for target in self.wildcards:
            package = self._package(target)
            if package is not None:
                yield from package.names()


def declare_imports(sink: Sink, scope: Scope, items: Iterable[nodes.Item]) -> None:
    """Note the imports among `items` in `scope`; nothing is read, so their order does not matter."""
    for item in items:
        if isinstance(item, nodes.Import):
            if scope.outside.imports is None:
                scope.outside.imports = ImportList(sink, root_of(scope))
            assert isinstance(scope.outside.imports, ImportList)
            for name, target in imported(item):
                if name is None:
                    scope.outside.imports.wildcards.append(target)
                else:
                    _name(scope.outside.imports, name, target)


def check_imports(scope: Scope) -> None:
    """Follow every import of a scope, so that a wrong one is told even where no name needs it."""
    imports = scope.outside.imports
    if isinstance(imports, ImportList):
        for target in imports.targets.values():
            follow(imports.sink, imports.root, target)
        for target in imports.wildcards:
            package_of(imports.sink, imports.root, target)


def imported(item: nodes.Import) -> Iterator[tuple[str | None, Target]]:
    """The names that an import gives, with what they stand for; None for all names of a package."""
    parts = item.name.parts
    if item.wildcard:
        yield None, Target(parts, item.name.span)
    elif item.names:
        for name in item.names:
            yield name, Target((*parts, name), _within(item, name))
    else:
        yield item.alias or parts[-1], Target(parts, item.name.span)


def _name(imports: ImportList, name: str, target: Target) -> None:
    other = imports.targets.setdefault(name, target)
    if other is not target and other.parts != target.parts:
        imports.sink.report("E0258", target.span, Label(other.span, "imported here first"), name=name)


def _within(item: nodes.Import, name: str) -> Span:
    """The place of one of the names in braces."""
    text = item.span.text
    at = text.find(name, text.find("{"))
    start = item.span.start + max(at, 0)
    return Span(item.span.file, start, start + len(name)) if at >= 0 else item.span


def root_of(scope: Scope) -> Root:
    """Origin of the names of imports."""
    return next(step.outside.root for step in scope.chain() if step.outside.root is not None)


def import_hint(scope: Scope, name: str) -> str | None:
    """The import that makes a name known that lies beside the file or in an installed folder."""
    return f"write `import {name};` to use what lies beside this file" if name in root_of(scope).names() else None


def follow(sink: Sink, root: Root, target: Target) -> Entry:
    """Meaning of the full name; poison after E0250 (nothing of that name), E0210 (not in the package), E0252."""
    first, *rest = target.parts
    entry = root.find(first, target.span)
    if entry is None:
        way = package_help(first) or import_help(".".join(target.parts))
        hint = way or did_you_mean(first, root.names())
        sink.report("E0250", target.span, name=first, notes=("\n".join(root.places(first)),), help=hint)
        return POISON
    for position, part in enumerate(rest, 1):
        if not isinstance(entry, ClassSymbol) or entry.inner is None:
            if entry is not POISON:
                _no_package(sink, target, ".".join(target.parts[:position]))
            return POISON
        around = entry.inner
        entry = around.find(part, target.span)
        if entry is None:
            hint = did_you_mean(part, around.names())
            what = f"package `{'.'.join(target.parts[:position])}`"
            sink.report("E0210", target.span, name=part, what=what, help=hint)
            return POISON
    return entry


def package_of(sink: Sink, root: Root, target: Target) -> Scope | None:
    """The scope of the package that a wildcard names, or None after a diagnostic."""
    entry = follow(sink, root, target)
    if isinstance(entry, ClassSymbol) and entry.inner is not None:
        return entry.inner
    if entry is not POISON:
        _no_package(sink, target, ".".join(target.parts))
    return None


def _no_package(sink: Sink, target: Target, name: str) -> None:
    sink.report("E0252", target.span, name=name)


def _identity(entry: Entry) -> object:
    """Key of an entry: equal for equal entries; a short class without modifiers is another name of its base."""
    for _ in range(_DEEPEST):
        if not isinstance(entry, ClassSymbol) or not isinstance(entry.node, nodes.ShortClass):
            break
        base = (
            None if entry.node.modifiers or entry.node.subscripts else lookup_path(entry.scope, entry.node.base.parts)
        )
        if not isinstance(base, ClassSymbol):
            break
        entry = base
    return getattr(entry, "node", entry)
