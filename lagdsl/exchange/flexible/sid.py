"""Standard Input Data of flexible bodies: O. Wallrapp, Mech. Struct. Mach. 22 (1994) 283.

The file is a tree of blocks, `name` to `end name`, of lines `key = value`. A Taylor matrix has its order and size, and
its elements: `m0(row, column)`, and the derivatives by the modes `m1(row, mode, column)`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import field

import numpy as np

from lagdsl.exchange.flexible.body import Floats
from lagdsl.exchange.flexible.keywords import LONGEST, number_of
from lagdsl.exchange.flexible.refusal import Refused, end_span, line_span
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile, Span

MAX_MODES = 200
MAX_NODES = 5_000
_ENTRY = re.compile(r"(m[01n])\s*\(([\s\d,]{3,40})\)")
_SHAPES: dict[str, tuple[int, int]] = {"mdCM": (3, 1), "J": (3, 3), "Ct": (-1, 3), "Cr": (-1, 3), "Me": (-1, -1)}
_SHAPES |= {"Ke": (-1, -1), "De": (-1, -1), "Oe": (-1, 6)}
_NODE_SHAPES = {"origin": (3, 1), "phi": (3, -1), "psi": (3, -1), "AP": (3, 3)}
_INERTIA = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
"""Elements of J where it is a column."""
_UNREAD = frozenset({"Gr", "Ge", "ksigma", "sigma"})
"""Matrices that follow from others, and stresses, which no motion depends on."""


@record(kw_only=True)
class Taylor:
    """A matrix m0 [rows, columns] with its derivatives m1 [rows, modes, columns], None where the file has none."""

    m0: Floats
    m1: Floats | None


@record(kw_only=True)
class Sid:
    """The body: its mass, the number of its modes, its matrices and those of its nodes by their names in the file."""

    file: SourceFile
    mass: float
    modes: int
    matrices: dict[str, Taylor]
    nodes: dict[int, dict[str, Taylor]]


@record(kw_only=True)
class _Line:
    span: Span
    path: tuple[str, ...]
    key: str
    value: str


@record(kw_only=True)
class _Draft:
    """Lines of a matrix as far as they are read."""

    span: Span
    header: dict[str, int] = field(default_factory=dict)
    m0: dict[tuple[int, ...], float] = field(default_factory=dict)
    m1: dict[tuple[int, ...], float] = field(default_factory=dict)


def read_sid(file: SourceFile) -> Sid:
    """The body of a file. Raises Refused."""
    mass: float | None = None
    modes = 0
    drafts: dict[str, _Draft] = {}
    nodes: dict[int, dict[str, _Draft]] = {}
    for line in _lines(file):
        match line.path:
            case ("part", "modal", "refmod"):
                mass = _real(line) if line.key == "mass" else mass
                modes = _integer(line, MAX_MODES) if line.key == "nelastq" else modes
            case ("part", "modal", "frame", node):
                if not line.key:
                    number = int(node)
                    if number in nodes:
                        raise Refused("E1206", line.span, what="node", name=number)
                    nodes[number] = {}
                    if len(nodes) > MAX_NODES:
                        raise Refused("E1204", line.span, what="the file", limit=MAX_NODES, unit="nodes")
            case ("part", "modal", "frame", node, name) if name not in _UNREAD:
                _into(nodes[int(node)], name, line, _NODE_SHAPES)
            case ("part", "modal", name) if name not in _UNREAD and name != "frame":
                _into(drafts, name, line, _SHAPES)
    if mass is None or modes == 0:
        raise Refused("E1203", None, name=file.name, what="refmod: mass" if mass is None else "refmod: nelastq")
    return Sid(
        file=file,
        mass=mass,
        modes=modes,
        matrices={name: _matrix(name, draft, modes) for name, draft in drafts.items()},
        nodes={
            number: {name: _taylor(name, draft, _NODE_SHAPES[name], modes) for name, draft in own.items()}
            for number, own in nodes.items()
        },
    )


def _lines(file: SourceFile) -> Iterator[_Line]:
    """Lines with the blocks around them; the opening line of a block has no key. The first line has the numbers of
    nodes and modes, and a comment."""
    path: list[str] = []
    closed = False
    for number, text in enumerate(file.text.split("\n"), 1):
        line = " ".join(text.split())
        if not line or (not path and re.match(r"\d{1,12} \d{1,12}( ?:|$)", line)):
            continue
        span = line_span(file, number)
        if closed:
            raise Refused("E1201", span, what="the line", text=line[:40], expected="the end of the file")
        if line.startswith("end "):
            if not path or line[4:] not in (path[-1], "node" if len(path) == 4 else path[-1]):
                expected = f"`end {_named(path)}`" if path else "a block"
                raise Refused("E1201", span, what="the line", text=line[:40], expected=expected)
            path.pop()
            closed = not path
        elif line.startswith(("new node", "new modal")) or "=" not in line:
            path.append(_opened(line, path, span))
            yield _Line(span=span, path=tuple(path), key="", value="")
        else:
            key, _, value = line.partition("=")
            yield _Line(span=span, path=tuple(path), key=key.strip(), value=value.strip())
    if path or not closed:
        raise Refused("E1202", end_span(file), what=f"`end {_named(path)}`" if path else "a block `part`")


def _named(path: list[str]) -> str:
    return "node" if len(path) == 4 else path[-1]


def _opened(line: str, path: list[str], span: Span) -> str:
    """The name of a block: `part`, `new modal = title`, `new node = 3`, `origin`."""
    if len(path) == 3 and path[2] == "frame":
        found = re.fullmatch(r"new node ?= ?(\d{1,12})", line)
        if found is not None:
            return str(int(found[1]))
    elif re.match(r"new modal( ?=|$)", line) and path == ["part"]:
        return "modal"
    elif (line == "part" and not path) or (re.fullmatch(r"[A-Za-z]{1,20}", line) and 2 <= len(path) <= 4):
        return line
    raise Refused("E1201", span, what="the line", text=line[:40], expected="a block of Standard Input Data")


def _into(drafts: dict[str, _Draft], name: str, line: _Line, known: dict[str, tuple[int, int]]) -> None:
    if name not in known:
        raise Refused("E1209", line.span, kind="matrix", name=name, known=", ".join([*known, *sorted(_UNREAD)]))
    if not line.key:
        if name in drafts:
            raise Refused("E1206", line.span, what="matrix", name=name)
        drafts[name] = _Draft(span=line.span)
        return
    draft = drafts[name]
    found = _ENTRY.fullmatch(line.key)
    if found is None:
        if line.key in ("order", "nrow", "ncol", "nq", "nqn", "structure"):
            draft.header[line.key] = _integer(line, 3 * MAX_MODES)
            return
        raise Refused("E1201", line.span, what="the line", text=line.key[:40], expected="an element of a matrix")
    cells = [cell.strip() for cell in found[2].split(",")]
    if found[1] == "mn" or len(cells) != (2 if found[1] == "m0" else 3) or not all(cell.isdigit() for cell in cells):
        raise Refused(
            "E1201", line.span, what="the element", text=line.key[:40], expected="`m0(i, j)` or `m1(i, k, j)`"
        )
    place = tuple(int(cell[:LONGEST]) for cell in cells)
    sizes = [draft.header.get(key, 0) for key in (("nrow", "ncol") if found[1] == "m0" else ("nrow", "nq", "ncol"))]
    if not all(1 <= index <= size for index, size in zip(place, sizes, strict=True)):
        bounds = " x ".join(map(str, sizes))
        raise Refused("E1201", line.span, what="the element", text=line.key[:40], expected=f"inside of {bounds}")
    (draft.m0 if found[1] == "m0" else draft.m1)[place] = _real(line)


def _real(line: _Line) -> float:
    value = number_of(line.value)
    if value is None:
        raise Refused("E1201", line.span, what=line.key, text=line.value[:40], expected="a finite number")
    return value


def _integer(line: _Line, most: int) -> int:
    text = line.value
    if not (text.isascii() and text.isdigit() and len(text) <= LONGEST):
        raise Refused("E1201", line.span, what=line.key, text=text[:40], expected="an integer")
    if int(text) > most:
        raise Refused("E1204", line.span, what=f"`{line.key}`", limit=most, unit="at most")
    return int(text)


def _matrix(name: str, draft: _Draft, modes: int) -> Taylor:
    """Of the body; its inertia is a 3 x 3 matrix, or a column, as programs write it."""
    if name != "J" or draft.header.get("ncol") != 1:
        return _taylor(name, draft, _SHAPES[name], modes)
    column = _taylor(name, draft, (len(_INERTIA), 1), modes)
    m0 = np.zeros((3, 3))
    m1 = None if column.m1 is None else np.zeros((3, modes, 3))
    for row, (i, j) in enumerate(_INERTIA):
        m0[i, j] = m0[j, i] = column.m0[row, 0]
        if m1 is not None and column.m1 is not None:
            m1[i, :, j] = m1[j, :, i] = column.m1[row, :, 0]
    return Taylor(m0=m0, m1=m1)


def _taylor(name: str, draft: _Draft, shape: tuple[int, int], modes: int) -> Taylor:
    """The matrix of a draft. Structures: 0 zero, 1 diagonal, 2 symmetric, 3 full, 4 unit matrix."""
    rows, columns = (modes if size < 0 else size for size in shape)
    header = draft.header
    given = (header.get("nrow"), header.get("ncol"), header.get("nq", modes) or modes, header.get("nqn", 0))
    if given != (rows, columns, modes, 0):
        text = f"{given[0]} x {given[1]}, nq = {given[2]}, nqn = {given[3]}"
        raise Refused("E1201", draft.span, what=name, text=text, expected=f"{rows} x {columns}, nq = {modes}, nqn = 0")
    m0 = np.eye(rows, columns) if header.get("structure") == 4 else np.zeros((rows, columns))
    mirrored = header.get("structure") == 2
    for (i, j), value in draft.m0.items():
        m0[i - 1, j - 1] = value
        if mirrored and (j, i) not in draft.m0:
            m0[j - 1, i - 1] = value
    if header.get("order", 0) == 0 and not draft.m1:
        return Taylor(m0=m0, m1=None)
    m1 = np.zeros((rows, modes, columns))
    for (i, k, j), value in draft.m1.items():
        m1[i - 1, k - 1, j - 1] = value
        if mirrored and (j, k, i) not in draft.m1:
            m1[j - 1, k - 1, i - 1] = value
    return Taylor(m0=m0, m1=m1)
