"""Words of the language with what the manual says of them: statements, types, constants, functions, attributes."""

from __future__ import annotations

import re
from functools import cache

from lagdsl.resources import language_reference
from lagdsl.semantics.events.event_functions import OF_EVENTS
from lagdsl.semantics.expressions.mechanics_functions import SPECIALS
from lagdsl.semantics.operators.builtin import BUILTINS
from lagdsl.semantics.scope.prelude import CONSTANTS, TYPES

_ROW = re.compile(r"^\| (`.*?) \| (.*) \|$", re.MULTILINE)
_CODE = re.compile(r"`([^`]+)`")
_LINK = re.compile(r"\[([^\]]+)\]\([^)]*\)")

FUNCTIONS = tuple(sorted({*BUILTINS, *SPECIALS, *OF_EVENTS, "sum", "product"}))
VARIABLES = {"time": "the time [s]", "world": "the frame that does not move: origin and axes `x`, `y`, `z`"}

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
def statement_of(word: str) -> tuple[str, str] | None:
    """Examples of the statement that `word` begins, and its meaning."""
    for examples, meaning in _tables():
        texts = _CODE.findall(examples)
        if any(re.match(rf"{re.escape(word)}\b", text) for text in texts):
            return "\n".join(texts), _LINK.sub(r"\1", meaning)
    return None


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
