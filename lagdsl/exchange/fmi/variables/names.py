"""Names of variables by the structured naming convention of FMI: `arm.q`, `der(theta,2)`, `q[2,1]`, `'odd name'`."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace

from lagdsl.foundation.record import record

_PART = r"[A-Za-z_][A-Za-z0-9_]*(?:\[[0-9]+(?:,[0-9]+)*\])?"
_PATH = re.compile(rf"{_PART}(?:\.{_PART})*")
_LAST_INDICES = re.compile(r"(?P<base>.+)\[(?P<indices>[0-9]+(?:,[0-9]+)*)\]")
_ABOUT = re.compile(r"(?P<what>[A-Za-z_][A-Za-z0-9_]*)\((?P<of>.+)\)")
# Characters of a quoted name beside letters and digits; all other characters become their number in braces. The
# escapes of the convention are left alone: importers read them in different ways.
_PLAIN = frozenset("_!#$%&()*+,-./:;<>=?@[]^|~ ")


@record()
class Name:
    """The `order`-th time derivative of the entry `indices` of the variable at `path`; `owner` is what it hangs on."""

    path: str
    indices: tuple[int, ...] = ()
    order: int = 0

    @property
    def text(self) -> str:
        entry = f"{self.path}[{','.join(map(str, self.indices))}]" if self.indices else self.path
        return derivative(entry, self.order)

    @property
    def array(self) -> str:
        """Of the whole array."""
        return derivative(self.path, self.order)


def derivative(path: str, order: int) -> str:
    """`theta`, `der(theta)`, `der(theta,2)`."""
    return path if order == 0 else f"der({path})" if order == 1 else f"der({path},{order})"


def named(text: str, order: int = 0) -> Name:
    """The name of a variable of the model: `arm.q[2]`, also `der(road)`."""
    while text.startswith("der(") and text.endswith(")"):
        text, order = text[4:-1], order + 1
    found = _LAST_INDICES.fullmatch(text)
    if found is None:
        return Name(structured(text), (), order)
    return Name(structured(found["base"]), tuple(int(index) for index in found["indices"].split(",")), order)


def belonging(owner: str, what: str) -> Name:
    """Name of a quantity of a named item: `wire.multiplier`, `pin.multiplier[2]`. Rows that the compiler wrote are
    named after their component: `closure(D)[2]` gives `D.closure.multiplier[2]`."""
    found = _LAST_INDICES.fullmatch(owner)
    base, indices = (found["base"], found["indices"]) if found else (owner, "")
    about = _ABOUT.fullmatch(base)
    path = f"{structured(about['of'])}.{about['what']}" if about else structured(base)
    return Name(f"{path}.{what}", tuple(int(index) for index in indices.split(",") if index))


def structured(path: str) -> str:
    """The path as it is where the convention has it, else as one quoted name."""
    return path if _PATH.fullmatch(path) else quoted(path)


def quoted(text: str) -> str:
    """A name in quotes; what these cannot hold becomes its number in hexadecimal: `'caf{e9}'`."""
    return "'" + ("".join(_character(character) for character in text) or "{}") + "'"


def _character(character: str) -> str:
    if character in _PLAIN or (character.isascii() and character.isalnum()):
        return character
    return f"{{{ord(character):x}}}"


def aside(wanted: str, taken: Iterable[str]) -> str:
    """The first name of a group of variables that no other begins with: `wanted`, and as many `_` as it takes."""
    firsts = {re.split(r"[.\[]", text.removeprefix("der("), maxsplit=1)[0].rstrip(")") for text in taken}
    while wanted in firsts:
        wanted += "_"
    return wanted


def apart(names: Sequence[Name], taken: Iterable[str]) -> list[Name]:
    """The names, moved aside where they are taken; entries of one array together."""
    known, moved = set(taken), list(names)
    for path in dict.fromkeys(name.path for name in names):
        own = [place for place, name in enumerate(names) if name.path == path]
        while any(moved[place].text in known for place in own):
            for place in own:
                moved[place] = replace(moved[place], path=f"{moved[place].path}_")
        known |= {moved[place].text for place in own}
    return moved
