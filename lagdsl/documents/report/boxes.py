"""Formulas as trees of boxes: what every output format can set, and nothing that needs escaping twice."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, TypeAlias


@dataclass(frozen=True, slots=True)
class Name:
    """A letter or word in italics: `θ`, `gap`."""

    text: str


@dataclass(frozen=True, slots=True)
class VectorName(Name):
    """The letter of a vector, in bold italics where there are such: `r`, `ω`."""


def bold(box: Box) -> Box:
    """A letter as that of a vector; other forms of it, as 𝐫, are bold by themselves."""
    return VectorName(box.text) if isinstance(box, Name) and len(box.text) == 1 and box.text.isalpha() else box


@dataclass(frozen=True, slots=True)
class Upright:
    """A function name, or plain words inside a formula."""

    text: str


@dataclass(frozen=True, slots=True)
class Number:
    text: str


@dataclass(frozen=True, slots=True)
class Operator:
    """`=`, `·`, `<`; set with space on both sides."""

    text: str


@dataclass(frozen=True, slots=True)
class Row:
    """Boxes side by side: a product where they are factors."""

    items: tuple[Box, ...]


@dataclass(frozen=True, slots=True)
class Sum:
    """Signed terms; long ones are broken between terms."""

    terms: tuple[tuple[Literal["+", "-"], Box], ...]


@dataclass(frozen=True, slots=True)
class Fraction:
    above: Box
    below: Box


@dataclass(frozen=True, slots=True)
class Power:
    base: Box
    exponent: Box


@dataclass(frozen=True, slots=True)
class Subscript:
    base: Box
    index: Box


@dataclass(frozen=True, slots=True)
class Root:
    inside: Box


@dataclass(frozen=True, slots=True)
class Dotted:
    """Time derivatives: one or two dots over the base."""

    base: Box
    dots: int


@dataclass(frozen=True, slots=True)
class Derivative:
    """∂of/∂by or d/dby, with `of` None for the bare operator."""

    letter: Literal["∂", "d"]
    of: Box | None
    by: Box


@dataclass(frozen=True, slots=True)
class Call:
    """A function and its arguments; `sin θ` is set without brackets."""

    function: Box
    arguments: tuple[Box, ...]


@dataclass(frozen=True, slots=True)
class Bracket:
    """Round brackets; one that goes on in the next line has no `right` side yet, and the rest of it no `left` one."""

    inside: Box
    left: bool = True
    right: bool = True


@dataclass(frozen=True, slots=True)
class Marked:
    """A term with the numbers of the statements that it comes from; it looks as if it had none."""

    inside: Box
    sources: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Cases:
    """Values with their conditions, the last one otherwise."""

    value: Box
    condition: Box
    otherwise: Box


@dataclass(frozen=True, slots=True)
class Column:
    """A vector by its components."""

    components: tuple[Box, ...]


@dataclass(frozen=True, slots=True)
class Matrix:
    rows: tuple[tuple[Box, ...], ...]


@dataclass(frozen=True, slots=True)
class Joined:
    """One symbol of several letters, without a blank: δ and its coordinate."""

    items: tuple[Box, ...]


@dataclass(frozen=True, slots=True)
class Unit:
    """The unit of an equation, behind it in square brackets, as the language writes it: `N.m`."""

    text: str


Box: TypeAlias = (
    "Name | Upright | Number | Operator | Row | Sum | Fraction | Power | Subscript | Root | Dotted | Derivative | Call "
    "| Bracket | Marked | Cases | Column | Matrix | Joined | Unit"
)


def row(*items: Box) -> Row:
    return Row(items)


EQUALS = Operator("=")
