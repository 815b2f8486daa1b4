"""Names of masses, bodies and loads in a report, from the model."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.documents.report.boxes import Box, Name, Number, Subscript, Upright
from lagdsl.documents.report.document import Code, Inline, Math, Paragraph, Text
from lagdsl.documents.report.notation import Notation, name_box
from lagdsl.documents.report.unicode_math import line
from lagdsl.language.flat.expression import FrameOrigin, PointReference
from lagdsl.language.flat.model import FlatModel, PointMass
from lagdsl.language.flat.quantity import Item

_LONGEST_STATEMENT = 100


def statement(item: Item, otherwise: str) -> str:
    """The user's own words, in one line."""
    if not item.spans:
        return otherwise
    words = " ".join(item.spans[0].text.split())
    return words if len(words) <= _LONGEST_STATEMENT else words[: _LONGEST_STATEMENT - 1] + "…"


def owned_statement(item: Item, otherwise: str) -> str:
    """The user's own words with the component that they are in, as `src: force -v on q;`."""
    components = ".".join(span.text for span in reversed(item.spans[1:]))
    words = statement(item, otherwise)
    return f"{components}: {words}" if components else words


def carrier_labels(flat: FlatModel) -> list[Box]:
    """An index for every mass, then every body: its component, point or label if that is its alone, else its number."""
    own = [_point_name(mass) for mass in flat.masses] + [body.label or body.frame for body in flat.bodies]
    scopes = [None if name is None else name.rpartition(".")[0] for name in own]
    names = [scope if scope and scopes.count(scope) == 1 else name for name, scope in zip(own, scopes, strict=True)]
    labels: list[Box] = []
    for number, name in enumerate(names, start=1):
        unique = name is not None and names.count(name) == 1
        labels.append(name_box(name) if unique and name is not None else Number(str(number)))
    return labels


def _point_name(mass: PointMass) -> str | None:
    place = mass.position
    if isinstance(place, PointReference):
        return place.name
    return place.frame if isinstance(place, FrameOrigin) else None


def indexed(letter: Box, index: Box) -> Box:
    """`r` with an index; a word, or an index with an index of its own, is set upright."""
    if isinstance(index, Subscript) or (isinstance(index, Name) and len(index.text) > 1):
        return Subscript(letter, Upright(line(index)))
    return Subscript(letter, index)


def listed(boxes: Sequence[Box]) -> Inline:
    """`a, b and c`."""
    pieces: list[Math | Text] = []
    for number, box in enumerate(boxes):
        if number:
            pieces.append(Text(" and " if number == len(boxes) - 1 else ", "))
        pieces.append(Math(box))
    return tuple(pieces)


def own_name(box: Box, name: str) -> Inline:
    """The name in the model, where it is not what the symbol reads like."""
    return () if line(box) == line(name_box(name)) and "." not in name else (Code(name),)


def gathered(names: Sequence[str]) -> str:
    """Names of scalars, elements of one array together: `com[1], com[2]` is `com[1, 2]`."""
    arrays: dict[str, list[str]] = {}
    for name in names:
        array, bracket, index = name.rpartition("[") if name.endswith("]") else (name, "", "")
        arrays.setdefault(array, []).extend([index.rstrip("]")] if bracket else [])
    return ", ".join(
        f"{array}[{'; '.join(indices) if any(',' in i for i in indices) else ', '.join(indices)}]" if indices else array
        for array, indices in arrays.items()
    )


def letters_note(signs: Notation) -> list[Paragraph]:
    """Letters of the derivation that gave way to those of the model."""
    if not signs.renamed:
        return []
    theirs, ours = listed([Name(each) for each in signs.renamed]), listed([*signs.renamed.values()])
    verb = "are letters" if len(signs.renamed) > 1 else "is a letter"
    return [Paragraph((*theirs, Text(f" {verb} of the model; the derivation writes "), *ours, Text(".")))]
