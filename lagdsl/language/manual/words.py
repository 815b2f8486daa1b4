"""Words of the language with what the manual says of them: statements, types, constants, functions, attributes."""

from __future__ import annotations

import re
from functools import cache

from lagdsl.foundation.resources import language_reference
from lagdsl.foundation.units.naming import base_text
from lagdsl.foundation.units.parse import UnknownUnit, parse_unit
from lagdsl.language.semantics.events.event_functions import OF_EVENTS
from lagdsl.language.semantics.expressions.mechanics_functions import SPECIALS
from lagdsl.language.semantics.operators.builtin import BUILTINS
from lagdsl.language.semantics.scope.prelude import CONSTANTS, TYPES
from lagdsl.language.syntax.vocabulary import vocabulary

_ROW = re.compile(r"^\| (`.*?) \| (.*) \|$", re.MULTILINE)
_CODE = re.compile(r"`([^`]+)`")
_LINK = re.compile(r"\[([^\]]+)\]\([^)]*\)")

FUNCTIONS = tuple(sorted({*BUILTINS, *SPECIALS, *OF_EVENTS, "sum", "product"}))
VARIABLES = {"time": "the time [s]", "world": "the frame that does not move: origin and axes `x`, `y`, `z`"}

KEYWORDS = {
    "model": "a class of what moves: `model Name ... end Name;`",
    "joint": "a model of two frames that may move against one another",
    "block": "a class of signals without mechanics",
    "connector": "a class of what components meet in: potentials, and `flow` quantities that sum to zero",
    "package": "a class that holds classes, constants and functions",
    "record": "a class that holds quantities only: `record Sizes ... end Sizes;`",
    "type": "a name for a quantity with attributes: `type Stretch = Length(min = 0);`",
    "partial": "the class is made to be extended",
    "protected": "what follows is not seen from outside of the class",
    "public": "what follows is seen from outside of the class",
    "replaceable": "another class may be put in its place by `redeclare`",
    "redeclare": "puts another class in the place of a `replaceable` one",
    "final": "the value cannot be modified",
    "each": "every element of the array gets the value: `q(each start = 30 deg)`",
    "flow": "quantities of this name sum to zero where connectors are connected",
    "within": "the package of the file: `within Lag.Planar;`",
    "equation": "begins the equations of the class: `der(z) = ...;`, `when ...`, `connect(a, b);`",
    "kinematics": "begins the equations of a joint that place `frame_b` against `frame_a`",
    "closure": "begins the constraints of a joint that closes a loop",
    "stream": "a prefix of Modelica's connectors that this language has not",
    "initial": "`initial equation` begins equations that hold at the start",
    "enumeration": "a type of named values: `type Gear = enumeration(low, high);`",
    "if": "a value `if c then a else b`; a statement `if c then ... end if;` with a structural condition",
    "else": "the value or the statements where no condition holds",
    "elseif": "a further condition of an `if`",
    "for": "statements for each index: `for i in 1:n loop ... end for;`",
    "in": "stands between an index and its range: `for i in 1:n loop`",
    "loop": "begins the statements of a `for`",
    "end": "ends a class, `end Name;`, or a block: `end if;`, `end for;`, `end when;`",
    "and": "both conditions hold",
    "or": "at least one condition holds",
    "not": "the condition does not hold",
    "true": "a condition that holds",
    "false": "a condition that does not hold",
    "at": "stands before a place: `mass m at {x, y};`",
}

ATTRIBUTES = {
    "start": "value at the start, or a guess of it",
    "fixed": "`true`: the start is kept; `false`: it is a guess",
    "min": "least value",
    "max": "greatest value",
    "nominal": "size of a change of order one",
    "unit": "coherent SI unit of a `Real`",
    "displayUnit": "unit in which people see the values",
    "symbol": "LaTeX of the name in reports",
    "smooth": "number of time derivatives that the caller gives",
    "der": "attributes of the rate",
    "omega": "attributes of the angular velocity",
    "prefer": "`always` or `never`: choice of the unknowns of a loop",
}


@cache
def _tables() -> list[tuple[str, str]]:
    """Rows of the tables of the manual that begin with code."""
    return _ROW.findall(language_reference().read_text(encoding="utf-8"))


@cache
def _row_with(pattern: str) -> tuple[str, str] | None:
    """Examples and meaning of the first row of which an example matches."""
    for examples, meaning in _tables():
        texts = _CODE.findall(examples)
        if any(re.search(pattern, text) for text in texts):
            return "\n".join(texts), _LINK.sub(r"\1", meaning)
    return None


def statement_of(word: str) -> tuple[str, str] | None:
    """Examples of the statement that `word` begins, and its meaning."""
    return _row_with(rf"\A{re.escape(word)}\b")


def row_with(word: str) -> tuple[str, str] | None:
    """The first row of the manual whose examples hold a word that begins no statement, such as `on`."""
    return _row_with(rf"(?<![\w.]){re.escape(word)}\b")


def keyword_text(word: str) -> str | None:
    """`model`: its form, and the manual's words on it."""
    if word in KEYWORDS:
        return f"`{word}`: {KEYWORDS[word]}"
    found = statement_of(word) or (row_with(word) if word in vocabulary().words else None)
    return None if found is None else f"```lag\n{found[0]}\n```\n\n{found[1]}"


def unit_text(text: str) -> str | None:
    """`kN.m`: what one of it is in coherent SI base units."""
    try:
        unit = parse_unit(text)
    except UnknownUnit:
        return None
    base = base_text(unit.dimension)
    shown = "rad" if base == "1" else base
    if unit.shift:
        return f"unit `{text}`: a temperature is the number plus {float(unit.shift):g} in K"
    return f"unit `{text}`: `1 {text} = {unit.factor:.10g} {shown}`"


@cache
def paragraph_on(word: str) -> str | None:
    """The paragraph of the manual that first shows a function as `word(`."""
    text = language_reference().read_text(encoding="utf-8")
    for examples, meaning in _tables():
        if re.search(rf"`[^`]*\b{re.escape(word)}\(", examples):
            return f"{examples}: {_LINK.sub(chr(92) + '1', meaning)}"
    for paragraph in text.split("\n\n"):
        if re.search(rf"`[^`\n]*\b{re.escape(word)}\(", paragraph) and not paragraph.startswith(("|", "```")):
            return _LINK.sub(r"\1", paragraph)
    return None


def function_of(word: str) -> tuple[str, str] | None:
    """The calls of a function in the row of the manual that first shows it, and its meaning."""
    return _row_with(rf"(?<![\w.]){re.escape(word)}\(")


def type_text(name: str) -> str | None:
    """`Angle`: unit and display unit of a type that needs no import."""
    found = TYPES.get(name)
    if found is None:
        return None
    shown = f", shown in `{found.display_unit}`" if found.display_unit is not None else ""
    unit = "without a unit" if found.unit == "1" else f"in `{found.unit}`{shown}"
    least = f", at least {found.minimum:g}" if found.minimum is not None else ""
    return f"a {found.base} {unit}{least}" if found.base == "Real" else f"a {found.base}"


def constant_text(name: str) -> str | None:
    found = CONSTANTS.get(name)
    if found is None:
        return None
    unit = f" {found.unit}" if found.unit != "1" else ""
    return f"`{name} = {found.value!r}{unit}`: {found.doc}"


def arguments_of(name: str) -> tuple[int, int] | None:
    """The least and the greatest number of arguments of a function of the language."""
    found = BUILTINS.get(name)
    return (found[1], found[2]) if found is not None else (1, 1) if name in FUNCTIONS else None
