"""Random trees of classes, and the same written out by hand: every instance with its own values."""

from __future__ import annotations

from dataclasses import dataclass
from random import Random


@dataclass(frozen=True)
class Pair:
    """A text of classes and one of scalars, with coordinates in the same order."""

    classes: str
    by_hand: str


def class_tree(seed: int) -> Pair:
    """Houses of rows of cells: masses, springs and starts come down as arrays, in all the ways there are."""
    random = Random(seed)
    sizes = [random.randint(1, 3) for _ in range(random.randint(2, 3))]
    rows = [_Row(random, index, size) for index, size in enumerate(sizes)]
    way = random.choice(["m", "2*m", "{m[i] for i in 1:n}", "m .* {1 for i in 1:n}", "m[1:n]", "0.5*(m + m)"])
    factor = 2.0 if way == "2*m" else 1.0
    inherited = random.random() < 0.5
    base = "  extends Springs;\n" if inherited else "  parameter Real c = 1;\n"
    classes = (
        "model Cell\n  parameter Real m = 1, k = 1, s = 0;\n  coordinate Real x(start = s);\n"
        "  point P = {x, k};\n  kinetic 1/2*m*der(x)^2;\n  potential 1/2*k*P.x^2;\n"
        '  annotation(units = "none");\nend Cell;\n'
        'partial model Springs\n  parameter Real c = 1;\n  annotation(units = "none");\nend Springs;\n'
        f"model Row\n{base}  structural parameter Integer n = 1;\n  parameter Real m[n], k[n], s[n];\n"
        f"  Cell cell[n](m = {way}, k = k, s = s);\n"
        "  for i in 1:n - 1 loop\n    potential 1/2*c*(cell[i + 1].x - cell[i].x)^2;\n  end for;\n"
        '  annotation(units = "none");\nend Row;\n'
        f"model House\n{''.join(row.instance() for row in rows)}"
        f"  potential 1/2*({rows[0].last()} - {rows[1].first()})^2;\n"
        '  annotation(units = "none");\nend House;\n'
        "model Street\n  House one, two(r0(c = 7));\n"
        '  annotation(units = "none");\nend Street;\n'
    )
    lines: list[str] = []
    for house, c in (("one", None), ("two", 7.0)):
        for row in rows:
            lines += row.by_hand(house, factor, c if row.index == 0 else None)
        lines.append(f"  potential 1/2*({rows[0].names(house)[-1]} - {rows[1].names(house)[0]})^2;")
    by_hand = "model Street\n" + "\n".join(lines) + '\n  annotation(units = "none");\nend Street;\n'
    return Pair(classes, by_hand)


class _Row:
    def __init__(self, random: Random, index: int, size: int) -> None:
        self.index, self._size = index, size
        self._m, self._k, self._s = ([round(random.uniform(0.5, 3), 3) for _ in range(size)] for _ in range(3))
        self._c = round(random.uniform(1, 9), 3)

    def instance(self) -> str:
        def array(values: list[float]) -> str:
            return "{" + ", ".join(map(repr, values)) + "}"

        given = f"m = {array(self._m)}, k = {array(self._k)}, s = {array(self._s)}"
        return f"  Row r{self.index}(n = {self._size}, {given}, c = {self._c!r});\n"

    def first(self) -> str:
        return f"r{self.index}.cell[1].x"

    def last(self) -> str:
        return f"r{self.index}.cell[{self._size}].x"

    def names(self, house: str) -> list[str]:
        return [f"{house}_r{self.index}_x{i}" for i in range(self._size)]

    def by_hand(self, house: str, factor: float, c: float | None) -> list[str]:
        names, spring = self.names(house), self._c if c is None else c
        lines = []
        for name, m, k, s in zip(names, self._m, self._k, self._s, strict=True):
            lines.append(f"  coordinate Real {name}(start = {s!r});")
            lines.append(f"  kinetic 1/2*{factor * m!r}*der({name})^2; potential 1/2*{k!r}*{name}^2;")
        pairs = zip(names[1:], names[:-1], strict=True)
        return [*lines, *(f"  potential 1/2*{spring!r}*({right} - {left})^2;" for right, left in pairs)]
