"""Random trees of classes with a small interpreter of their own: the text, and what it must come to, written out.

`tree(draw)` makes classes of masses on springs: arrays of components inside arrays of components, values given through
modifiers, `each`, slices, comprehensions, inheritance. `instances` says what the text means, by following the rules of
`docs/reference/classes.md` on the tree that was drawn, not by reading the text: one `Mass` for every coordinate, with
numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise
from random import Random
from typing import TypeAlias

from hypothesis import strategies as st

Number: TypeAlias = "float | list[Number]"
Env: TypeAlias = "dict[str, Number]"
Shape: TypeAlias = "tuple[int, ...]"

UNITS = {"m": "kg", "k": "N/m", "s": "m", "h": "m"}
TYPES = {"m": "Mass", "k": "Stiffness", "s": "Length", "h": "Length"}
LEAF = "m", "k", "s", "h"


@dataclass(frozen=True)
class Expression:
    """A text with what it is worth among the values of names."""

    text: str
    value: Callable[[Env], Number]


@dataclass(frozen=True)
class Modifier:
    """`name = value` or, with `inner`, `name(...)`; `index` is the one element that it is for (0: all)."""

    name: str
    value: Expression | None = None
    inner: tuple[Modifier, ...] = ()
    each: bool = False
    index: int = 0

    def text(self) -> str:
        at = f"[{self.index}]" if self.index else ""
        inner = f"({', '.join(each.text() for each in self.inner)})" if self.inner else ""
        value = f" = {self.value.text}" if self.value is not None else ""
        return f"{'each ' if self.each else ''}{self.name}{at}{inner}{value}"


@dataclass(frozen=True)
class Part:
    """A component, an array of them if `extent` is not 0."""

    name: str
    extent: int
    kind: Kind
    modifiers: tuple[Modifier, ...]


@dataclass(frozen=True)
class Kind:
    """A class: parameters with shape and default, components, springs between coordinates, the class it extends."""

    name: str
    parameters: dict[str, tuple[str, Shape, Expression]]
    parts: tuple[Part, ...] = ()
    springs: tuple[tuple[str, str, Expression], ...] = ()
    base: tuple[Kind, tuple[Modifier, ...]] | None = None

    def text(self, order: Random | None = None) -> str:
        """The class; with `order` its items stand in another one."""
        lines = []
        if self.base is not None:
            lines.append(f"  extends {self.base[0].name}{_list(self.base[1])};")
        for name, (quantity, shape, default) in self.parameters.items():
            extents = f"[{', '.join(map(str, shape))}]" if shape else ""
            lines.append(f"  parameter {TYPES[quantity]} {name}{extents} = {default.text};")
        for part in self.parts:
            extent = f"[{part.extent}]" if part.extent else ""
            lines.append(f"  {part.kind.name} {part.name}{extent}{_list(part.modifiers)};")
        if self.name == "Leaf":
            lines += ["  coordinate Length x(start = s);", "  point P = {x, h};", "  mass m at P;"]
            lines += ["  potential 1/2*k*x^2;"]
        for one, two, stiffness in self.springs:
            lines.append(f"  potential 1/2*({stiffness.text})*({one}.x - {two}.x)^2;")
        if order is not None:
            order.shuffle(lines)
        return "\n".join([f"model {self.name}", *lines, f"end {self.name};"])

    def line(self) -> list[Kind]:
        """The class after those that it extends."""
        return [*(self.base[0].line() if self.base is not None else []), self]

    def names(self) -> dict[str, tuple[str, Shape]]:
        """All parameters, inherited ones too."""
        return {name: entry[:2] for kind in self.line() for name, entry in kind.parameters.items()}

    def all_parts(self) -> list[Part]:
        return [part for kind in self.line() for part in kind.parts]


def _list(modifiers: Sequence[Modifier]) -> str:
    return f"({', '.join(each.text() for each in modifiers)})" if modifiers else ""


# ---- what it means ---------------------------------------------------------------------------------------------------


@dataclass
class Mass:
    """A coordinate with its numbers."""

    name: str
    m: float
    k: float
    start: float
    height: float


@dataclass
class Meaning:
    masses: list[Mass] = field(default_factory=list)
    springs: list[tuple[str, str, float]] = field(default_factory=list)

    def text(self) -> str:
        """The model without classes."""
        short = {mass.name: f"x{number}" for number, mass in enumerate(self.masses)}
        lines = ["model ByHand", "  gravity = {0, 0};"]
        for mass in self.masses:
            x = short[mass.name]
            lines.append(f"  coordinate Length {x}(start = {mass.start!r} m);")
            lines.append(f"  mass {mass.m!r} kg at {{{x}, {mass.height!r} m}};")
            lines.append(f"  potential 1/2*({mass.k!r} N/m)*{x}^2;")
        for one, two, k in self.springs:
            lines.append(f"  potential 1/2*({k!r} N/m)*({short[one]} - {short[two]})^2;")
        return "\n".join([*lines, "end ByHand;"])


# A modifier whose values are known: what is said of a name, or of a member of it.
@dataclass(frozen=True)
class _Said:
    name: str
    value: Number | None
    inner: tuple[_Said, ...]
    each: bool
    index: int


def _known(modifier: Modifier, env: Env) -> _Said:
    value = modifier.value.value(env) if modifier.value is not None else None
    inner = tuple(_known(each, env) for each in modifier.inner)
    return _Said(modifier.name, value, inner, modifier.each, modifier.index)


def _of_element(said: _Said, index: int) -> _Said:
    """The part of an array's modifier that counts for one element: `each` counts for this array."""
    if said.each:
        return replace(said, each=False)
    value = said.value[index - 1] if isinstance(said.value, list) else said.value
    return replace(said, value=value, inner=tuple(_of_element(each, index) for each in said.inner))


def meaning(kind: Kind) -> Meaning:
    found = Meaning()
    _instance(kind, "", [], found)
    return found


def _instance(kind: Kind, prefix: str, said: list[_Said], found: Meaning) -> None:
    """`said` are the modifiers from outside, outer ones last."""
    env: Env = {}
    # Modifiers that a class gives its base count before those from outside; it may use the parameters of both.
    inherited: list[Modifier] = []
    for each in reversed(kind.line()):
        inherited = [*(each.base[1] if each.base is not None else ()), *inherited]
    given = {item.name: item.value for item in said if not item.inner}
    order = [name for each in reversed(kind.line()) for name in each.parameters]
    defaults = {name: entry[2] for each in kind.line() for name, entry in each.parameters.items()}
    changed = {item.name: item.value for item in inherited if not item.inner and item.value is not None}
    for name in order:
        source = changed.get(name, defaults[name])
        value = given.get(name)
        env[name] = value if value is not None else source.value(env)
    own = [_known(item, env) for item in inherited if item.inner]
    if kind.name == "Leaf":
        numbers = {name: value for name, value in env.items() if isinstance(value, float)}
        start = numbers["s"]
        for item in said:
            if item.name == "x":
                start = next((inner.value for inner in item.inner if isinstance(inner.value, float)), start)
        found.masses.append(Mass(f"{prefix}x", numbers["m"], numbers["k"], start, numbers["h"]))
    for part in kind.all_parts():
        declared = [_known(modifier, env) for modifier in part.modifiers]
        outside = [item for item in (*own, *said) if item.name == part.name]
        for index in range(1, part.extent + 1) if part.extent else (0,):
            here = [_of_element(item, index) if index else item for item in declared]
            for item in outside:
                if item.index in (0, index):
                    whole = _of_element(item, index) if index and not item.index else item
                    here += whole.inner
            at = f"[{index}]" if index else ""
            _instance(part.kind, f"{prefix}{part.name}{at}.", here, found)
    for each in kind.line():
        for one, two, stiffness in each.springs:
            value = stiffness.value(env)
            assert isinstance(value, float)
            found.springs.append((f"{prefix}{one}.x", f"{prefix}{two}.x", value))


# ---- drawing a tree --------------------------------------------------------------------------------------------------

Names: TypeAlias = "dict[str, tuple[str, Shape]]"


def _literal(draw: st.DrawFn, quantity: str) -> Expression:
    number = draw(st.integers(1, 99)) / 8
    return Expression(f"{number} {UNITS[quantity]}", lambda env: number)


def _scaled(factor: float, value: Number) -> Number:
    return [_scaled(factor, part) for part in value] if isinstance(value, list) else factor * value


def _sum(one: Number, two: Number) -> Number:
    if isinstance(one, list) and isinstance(two, list):
        return [_sum(a, b) for a, b in zip(one, two, strict=True)]
    assert isinstance(one, float) and isinstance(two, float)
    return one + two


def _at(value: Number, index: int) -> Number:
    assert isinstance(value, list)
    return value[index - 1]


def _of_names(draw: st.DrawFn, names: Names, quantity: str, shape: Shape) -> list[Expression]:
    """Names of the quantity with this shape; elements and slices of larger ones."""
    found = []
    for name, (other, extents) in names.items():
        if other != quantity:
            continue
        if extents == shape:
            found.append(Expression(name, lambda env, name=name: env[name]))  # type: ignore[misc]
        if len(extents) == len(shape) + 1 and extents[1:] == shape:
            k = draw(st.integers(1, extents[0]))
            found.append(Expression(f"{name}[{k}]", lambda env, name=name, k=k: _at(env[name], k)))  # type: ignore[misc]
        if len(extents) == len(shape) >= 1 and extents[1:] == shape[1:] and extents[0] > shape[0]:
            first = draw(st.integers(1, extents[0] - shape[0] + 1))
            last = first + shape[0] - 1

            def cut(env: Env, name: str = name, first: int = first, last: int = last) -> Number:
                value = env[name]
                assert isinstance(value, list)
                return value[first - 1 : last]

            found.append(Expression(f"{name}[{first}:{last}]", cut))
    return found


def expression(draw: st.DrawFn, names: Names, quantity: str, shape: Shape, depth: int = 2) -> Expression:
    """A text of that quantity and shape."""
    known = _of_names(draw, names, quantity, shape)
    ways = ["name"] * 3 * bool(known) + ["listed" if shape else "literal"]
    if depth:
        ways += ["scaled", "sum"] + ["each index", "filled"] * bool(shape)
    match draw(st.sampled_from(ways)):
        case "name":
            return draw(st.sampled_from(known))
        case "literal":
            return _literal(draw, quantity)
        case "scaled":
            factor = float(draw(st.integers(2, 5)))
            inner = expression(draw, names, quantity, shape, depth - 1)
            return Expression(f"{factor}*({inner.text})", lambda env: _scaled(factor, inner.value(env)))
        case "sum":
            one, two = (expression(draw, names, quantity, shape, depth - 1) for _ in range(2))
            return Expression(f"({one.text} + {two.text})", lambda env: _sum(one.value(env), two.value(env)))
        case "each index":
            inner = expression(draw, names, quantity, shape[1:], depth - 1)
            count = shape[0]
            turn = f"i{depth}"
            return Expression(
                f"{{{turn}*({inner.text}) for {turn} in 1:{count}}}",
                lambda env: [_scaled(float(i + 1), inner.value(env)) for i in range(count)],
            )
        case "filled" if len(shape) == 1:
            inner = expression(draw, names, quantity, (), depth - 1)
            return Expression(f"fill({inner.text}, {shape[0]})", lambda env: [inner.value(env)] * shape[0])
        case _:
            parts = [expression(draw, names, quantity, shape[1:], max(depth - 1, 0)) for _ in range(shape[0])]
            text = ", ".join(part.text for part in parts)
            return Expression(f"{{{text}}}", lambda env: [part.value(env) for part in parts])


def _modifiers(draw: st.DrawFn, names: Names, kind: Kind, extents: Shape) -> tuple[Modifier, ...]:
    """Modifiers of components of a class inside arrays of these extents, innermost array last."""
    found: list[Modifier] = []
    for name, (quantity, shape) in kind.names().items():
        if not draw(st.booleans()):
            continue
        each = bool(extents) and draw(st.integers(0, 3)) == 0
        whole = (*(extents[1:] if each else extents), *shape)
        if len(whole) <= 3:
            found.append(Modifier(name, expression(draw, names, quantity, whole), each=each))
    if kind.name == "Leaf":
        if draw(st.booleans()):
            each = bool(extents) and draw(st.booleans())
            whole = extents[1:] if each else extents
            start = Modifier("start", expression(draw, names, "s", whole), each=each)
            found.append(Modifier("x", inner=(start,)))
        return tuple(found)
    for part in kind.all_parts():
        if draw(st.integers(0, 3)) == 0 and len(extents) < 2:
            one = part.extent and not extents and draw(st.booleans())
            deeper = extents if not part.extent or one else (*extents, part.extent)
            inner = _modifiers(draw, names, part.kind, deeper)
            if inner:
                index = draw(st.integers(1, part.extent)) if one else 0
                found.append(Modifier(part.name, inner=inner, index=index))
    return tuple(found)


def _class(draw: st.DrawFn, name: str, kinds: list[Kind], base: Kind | None) -> Kind:
    """A class of components of the classes so far."""
    stem = name.lower()
    parameters: dict[str, tuple[str, Shape, Expression]] = {}
    names: Names = base.names() if base is not None else {}
    own: Names = {}
    for number, quantity in enumerate(draw(st.lists(st.sampled_from("mks"), min_size=1, max_size=4))):
        shape = draw(st.sampled_from([(), (2,), (3,), (2, 2)]))
        default = expression(draw, own, quantity, shape)
        own[f"{quantity}_{stem}{number}"] = quantity, shape
        parameters[f"{quantity}_{stem}{number}"] = quantity, shape, default
    said: tuple[Modifier, ...] = ()
    if base is not None:
        said = tuple(
            Modifier(other, expression(draw, own, quantity, shape))
            for other, (quantity, shape) in base.names().items()
            if draw(st.booleans())
        )
    names = {**names, **own}
    parts = []
    for number in range(draw(st.integers(1, 2))):
        kind = draw(st.sampled_from(kinds))
        extent = draw(st.sampled_from([0, 2, 2, 3]))
        said_of = _modifiers(draw, names, kind, (extent,) if extent else ())
        parts.append(Part(f"{stem}_{kind.name.lower()}{number}", extent, kind, said_of))
    leaves = [f"{part.name}{f'[{k}]' if k else ''}" for part in parts if part.kind.name == "Leaf"
              for k in (range(1, part.extent + 1) if part.extent else (0,))]  # fmt: skip
    springs = [(one, two, expression(draw, names, "k", (), 1)) for one, two in pairwise(leaves) if draw(st.booleans())]
    return Kind(name, parameters, tuple(parts), tuple(springs), (base, said) if base is not None else None)


@st.composite
def trees(draw: st.DrawFn) -> list[Kind]:
    """Classes; the last is the model, which holds two instances of the one before with different values."""
    leaf = Kind("Leaf", {name: (name, (), _literal(draw, name)) for name in LEAF})
    kinds = [leaf]
    for name in ["Row", "Field", "Block"][: draw(st.integers(1, 3))]:
        base = draw(st.sampled_from([None, *kinds[1:]])) if len(kinds) > 1 else None
        kinds.append(_class(draw, name, kinds, base))
    last = kinds[-1]
    parts = tuple(Part(name, 0, last, _modifiers(draw, {}, last, ())) for name in ("a", "b"))
    return [*kinds, Kind("House", {}, parts)]


def text_of(kinds: Sequence[Kind], order: Random | None = None) -> str:
    """The file; with `order` classes and their items stand in another one. Gravity is said in a model around."""
    classes = [kind.text(order) for kind in kinds]
    if order is not None:
        order.shuffle(classes)
    return "\n".join([*classes, MODEL])


MODEL = "model Whole extends House; gravity = {0, 0}; end Whole;"
