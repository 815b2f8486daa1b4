"""Tables of the names of a model: each row in the words of its component, lists of numbers by a letter of their own."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from itertools import takewhile

from lagdsl.documents.report.document import Block, Bullets, Code, Inline, Paragraph, Table, Text, text
from lagdsl.documents.report.sections.families import rolled
from lagdsl.foundation.record import record

_MOST = 16
_LONGEST = 300
_DIGITS = 10
_OF = " of…"
SPANS = re.compile(r", (?=[a-z] = )")
_PATH = re.compile(
    r"(?<![\w.\[\]])(?:[A-Za-z_]\w*(?:\[[^\[\]]*\])?\.)*[A-Za-z_]\w*(?:\[[^\[\]]*\])?(?![\w(.\[])(?! in \d)|"
    r"(?<![\w.\[\]])(?:[A-Za-z_]\w*(?:\[[^\[\]]*\])?\.)+(?=point\()"
)
_WORDS = frozenset(("if", "then", "else", "and", "or", "not", "for", "in", "pi", "world", "gravity"))
_LIST = re.compile(r"\{-?[\d.e+-]+(?:, -?[\d.e+-]+)+\}(?=\[)")
_LONG_NUMBER = re.compile(r"(?<![\w.])\d+\.\d{10,}(?:e[+-]?\d+)?")


@record()
class Words:
    """`taken` are names of the model. `lists` grows with the tables that are made."""

    taken: frozenset[str]
    lists: dict[str, str]

    def table(
        self, header: tuple[str, ...], rows: Sequence[tuple[str, ...]], *, most: int = _MOST, longest: int = _LONGEST
    ) -> list[Block]:
        """Like rows together, at most a page of them; nothing of no rows."""
        return self.table_of(header, rolled(rows), most=most, longest=longest)

    def table_of(
        self, header: tuple[str, ...], rows: Sequence[tuple[str, ...]], *, most: int = _MOST, longest: int = _LONGEST
    ) -> list[Block]:
        """Of rows that are together already."""
        if not rows:
            return []
        shown = [self.told(row) for row in rows]
        more = len(shown) - most
        cells: list[tuple[Inline, ...]] = [
            tuple((Code(_cut(cell, longest)),) if cell else () for cell in row) for row in shown[:most]
        ]
        blocks: list[Block] = [Table(header, tuple(cells))]
        return [*blocks, Paragraph(text(f"… and {more} more."))] if more > 0 else blocks

    def runs(self, rows: Sequence[tuple[str, ...]]) -> list[Block]:
        """`name = value; name = value`, one run for each component and its indices; nothing of no rows."""
        runs: dict[tuple[str, ...], list[tuple[str, str]]] = {}
        for name, value in map(self.told, rolled(rows)):
            told, *spans = SPANS.split(name)
            owner, colon, own = told.partition(": ")
            first = [each for each in spans if colon and each.startswith("k = ")]
            others = [each for each in spans if each not in first]
            words = (own if colon else told, ", ".join([value, *others]))
            runs.setdefault((owner, *first) if colon else (), []).append(words)
        items: list[Inline] = []
        for key, run in runs.items():
            shown = _given(run) if key else [f"{name} = {value}" for name, value in run]
            items.append((Code(f"{', '.join(key)}: " if key else ""), Code("; ".join(shown))))
        return [Bullets(tuple(items))] if items else []

    def sums(self, rows: Sequence[tuple[str, ...]]) -> list[Block]:
        """`name: value + value`, one for each name and its indices; nothing of no rows."""
        sums: dict[str, list[str]] = {}
        for name, value in map(self.told, rolled(rows)):
            sums.setdefault(name, []).append(value)
        items: list[Inline] = [(Code(f"{name}: {' + '.join(values)}"),) for name, values in sums.items()]
        return [Bullets(tuple(items))] if items else []

    def told(self, row: tuple[str, ...]) -> tuple[str, ...]:
        """The row in the words of the component of all of its names: `arm: tip` where the first cell is `arm.tip`,
        `mass of arm` where it is `mass of…`."""
        first, *others = row
        kind, of, spans = first.partition(_OF)
        owner = _owner(others if of else row)
        if owner:
            others = [_PATH.sub(lambda path: path[0].removeprefix(owner), cell) for cell in others]
            first = f"{owner[:-1]}: {_PATH.sub(lambda path: path[0].removeprefix(owner), first)}"
        if of:
            first = f"{kind}{f' of {owner[:-1]}' if owner else ''}{spans}"
        return (first, *map(self._numbers, others))

    def numbers(self) -> list[Block]:
        """The lists of numbers that the tables have."""
        lists = "; ".join(f"{name} = {numbers}" for numbers, name in self.lists.items())
        return [Paragraph((Text("Numbers: "), Code(lists)))] if lists else []

    def _numbers(self, cell: str) -> str:
        short = _LONG_NUMBER.sub(lambda number: f"{float(number[0]):.{_DIGITS}g}", cell)
        return _LIST.sub(lambda found: self._name(found[0]), short).replace(" + -", " - ")

    def _name(self, numbers: str) -> str:
        if numbers not in self.lists:
            count = len(self.lists) + 1
            while f"c{count}" in self.taken:
                count += 1
            self.lists[numbers] = f"c{count}"
        return self.lists[numbers]


def _given(run: Sequence[tuple[str, str]]) -> list[str]:
    """`name = value`, and `component(name = value, name = value)` for what is given to a component."""
    shown: dict[str, list[str]] = {}
    for name, value in run:
        component, _, own = name.rpartition(".") if _PATH.fullmatch(name) else ("", "", name)
        shown.setdefault(component or f"{name} = {value}", []).append(f"{own} = {value}")
    return [f"{of}({', '.join(words)})" if _PATH.fullmatch(of) else of for of, words in shown.items()]


def _owner(row: Iterable[str]) -> str:
    """The component of which all names of the row are, with its point; "" if there is none."""
    paths = [f"{path}_".split(".")[:-1] for cell in row for path in _paths(cell)]
    alike = takewhile(lambda names: len(set(names)) == 1, zip(*paths, strict=False))
    return "".join(f"{names[0]}." for names in alike)


def _paths(cell: str) -> list[str]:
    return [path for path in _PATH.findall(cell.partition(", k = ")[0]) if path.partition("[")[0] not in _WORDS]


def _cut(words: str, longest: int) -> str:
    return words if len(words) <= longest else words[: longest - 1] + "…"
