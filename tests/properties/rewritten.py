"""Texts that say the same in another way: a stranger beside it, other order, other names, a class around it."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.units.vocabulary import UNITS
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.parser import parse
from lagdsl.motion.pipeline import read


@dataclass(frozen=True)
class Source:
    """A text and its last class, which is the model."""

    text: str
    model: nodes.Class
    others: tuple[nodes.Class, ...] = ()

    @property
    def unitless(self) -> bool:
        return 'units = "none"' in self.text


def source(path: Path) -> Source:
    sink = Sink()
    file = read(path, sink)
    assert file is not None
    unit = parse(file, sink)
    assert unit is not None
    *others, model = [item for item in unit.items if isinstance(item, nodes.Class)]
    return Source(file.text, model, tuple(others))


def with_stranger(s: Source, start: float, rate: float, mass: float) -> str:
    """A coordinate beside it that nothing couples to it, first of all."""
    kind, unit = ("Real", "") if s.unitless else ("Length", " kg")
    added = (
        f"coordinate {kind} stranger(start = {start!r}, der(start = {rate!r}));\n"
        f"  kinetic 1/2*({mass!r}{unit})*der(stranger)^2;\n  "
    )
    at = s.model.items[0].span.start
    return s.text[:at] + added + s.text[at:]


def reordered(s: Source) -> str:
    """Its statements from the last to the first; components and what joins them stay in their order, from which merged
    coordinates have their names and `connect` its frames, and come last."""
    items = s.model.items
    joined = [item for item in items if isinstance(item, nodes.Component | nodes.Connect | nodes.For | nodes.If)]
    others = [item for item in reversed(items) if item not in joined]
    text = "\n  ".join(item.span.text for item in (*others, *joined))
    return s.text[: items[0].span.start] + text + s.text[items[-1].span.end :]


def wrapped(s: Source) -> str:
    """An instance of it in another model."""
    return s.text + around(s)


def around(s: Source, items: str = "", equations: str = "") -> str:
    """A model with an instance of it, and with its experiment, by which contacts rest."""
    return f"\nmodel Around\n  {s.model.name} inner;\n{items}{_experiment(s)}{equations}end Around;\n"


def _experiment(s: Source) -> str:
    stop = re.search(r"StopTime\s*=\s*([^,)]+)", s.text[s.model.span.start : s.model.span.end])
    return "" if stop is None else f"  annotation(experiment(StopTime = {stop[1]}));\n"


def in_files(s: Source) -> dict[str, str]:
    """Each of its classes in a file of its own, as an import wants them, with imports of the others that it names."""
    classes = (*s.others, s.model)
    texts = {}
    for each in classes:
        others = (other.name for other in classes if other is not each)
        imports = "".join(f"import {name};\n" for name in others if re.search(rf"\b{name}\b", each.span.text))
        texts[f"{each.name}.lag"] = f"{imports}{each.span.text}\n"
    return texts


def names_of(s: Source) -> tuple[str, ...]:
    """Coordinates of the model itself that can be renamed word by word: no unit is called like them."""
    names = [d.name for item in s.model.items if isinstance(item, nodes.Coordinate) for d in item.declarators]
    return tuple(name for name in names if name not in UNITS)


def renamed(s: Source, suffix: str) -> str:
    """Coordinates by other names, but for arguments of components that are called the same."""
    start, end = s.model.span.start, s.model.span.end
    body = s.text[start:end]
    for name in names_of(s):
        argument = rf"(?<=[(,])\s*{name}\s*=[^=]"
        body = re.sub(
            rf"{argument}|(?<![\w.]){name}(?!\w)",
            lambda found, name=name: found[0] if found[0] != name else name + suffix,
            body,
        )
    return s.text[:start] + body + s.text[end:]


@dataclass(frozen=True)
class Mass:
    """A parameter of the model itself, in kg."""

    name: str
    value: float


def mass_of(s: Source) -> Mass | None:
    """The first mass among its parameters that is a number."""
    found = re.search(r"parameter Mass (\w+) = ([\d.e]+) kg", s.text[s.model.span.start : s.model.span.end])
    return None if found is None else Mass(found[1], float(found[2]))


def lighter(s: Source, mass: Mass) -> str:
    items = f"  extends {s.model.name}({mass.name} = {_less(mass)});\n{_experiment(s)}"
    return f"{s.text}\nmodel Lighter\n{items}end Lighter;\n"


def twice(s: Source, mass: Mass | None) -> str:
    """With gravity, which a model has once, around both."""
    values = "" if mass is None else f"({mass.name} = {_less(mass)})"
    text, gravity = s.text, ""
    for item in s.model.items:
        if isinstance(item, nodes.Gravity):
            gravity = re.sub(r"(?<!\d )(?<![/.\w])[A-Za-z]\w*", lambda word: _inside(s, word[0]), item.span.text)
            text = s.text[: item.span.start] + s.text[item.span.end :]
    return text + around(s, f"  {s.model.name} other{values};\n  {gravity}\n")


def _inside(s: Source, name: str) -> str:
    own = (d.name for item in s.model.items for d in getattr(item, "declarators", ()))
    return f"inner.{name}" if name in own else name


def _less(mass: Mass) -> str:
    return f"{0.9 * mass.value!r} kg"
