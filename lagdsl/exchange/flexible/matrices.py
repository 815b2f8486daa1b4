"""Stiffness and mass matrices that CalculiX (`.sti`, `.mas`, `.dof`) and Abaqus (`.mtx`) write for a free body."""

from __future__ import annotations

from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

from lagdsl.exchange.flexible.files import InputFile, read_file
from lagdsl.exchange.flexible.keywords import number_of
from lagdsl.exchange.flexible.refusal import Refused, end_span, line_span
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile

Floats: TypeAlias = NDArray[np.float64]
Integers: TypeAlias = NDArray[np.int64]
Sparse: TypeAlias = Any
"""A sparse matrix by rows: SciPy's own names of its types change with its version."""
MAX_UNKNOWNS = 300_000
_PER_LINE = {"calculix": 3, "abaqus": 5}


@record(kw_only=True)
class Matrices:
    """Matrices over the unknowns of `nodes`: three displacements of each, one node after the other.

    `stiffness` and `mass` are symmetric, in the units of the files.
    """

    nodes: tuple[int, ...]
    stiffness: Sparse
    mass: Sparse
    files: tuple[InputFile, ...]


def read_matrices(deck: Path, stem: Path | None) -> Matrices:
    """The matrices that belong to a deck: files of its name, or of the name `stem`, beside it. Raises Refused."""
    name = deck.with_suffix("") if stem is None else stem
    calculix = [name.with_name(name.name + ending) for ending in (".dof", ".sti", ".mas")]
    if any(path.exists() for path in calculix):
        return _calculix(calculix)
    abaqus = [sorted(name.parent.glob(f"{_literal(name.name)}_{kind}*.mtx")) for kind in ("STIF", "MASS")]
    if all(len(found) == 1 for found in abaqus):
        return _abaqus([found[0] for found in abaqus])
    if any(len(found) > 1 for found in abaqus):
        found = ", ".join(path.name for paths in abaqus for path in paths)
        raise Refused(
            "E1205", None, name=deck, files=f"one `{name.name}_STIF*.mtx` and one `{name.name}_MASS*.mtx`, not {found}"
        )
    raise Refused(
        "E1205", None, name=deck, files=f"`{name.name}.sti`, `.mas`, `.dof`, or `{name.name}_STIF*.mtx`, `_MASS*.mtx`"
    )


def _literal(name: str) -> str:
    return "".join(f"[{letter}]" if letter in "*?[" else letter for letter in name)


def _calculix(paths: list[Path]) -> Matrices:
    missing = [path for path in paths if not path.exists()]
    if missing:
        raise Refused(
            "E1205", None, name=paths[0].with_suffix(""), files=", ".join(f"`{path.name}`" for path in missing)
        )
    unknowns, *matrices = (read_file(path) for path in paths)
    keys = _unknowns(unknowns.source)
    read = []
    for file in matrices:
        cells = _cells(file.source, "calculix")
        places = _indices(file.source, cells[:, :2], len(keys))
        read.append((file.source, places[:, 0], places[:, 1], cells[:, 2]))
    return _assembled(keys, read, (unknowns, *matrices))


def _abaqus(paths: list[Path]) -> Matrices:
    files = [read_file(path) for path in paths]
    tables = [_cells(file.source, "abaqus") for file in files]
    pairs = np.vstack([np.vstack([cells[:, :2], cells[:, 2:4]]) for cells in tables])
    keys = np.unique(pairs, axis=0)
    if not np.array_equal(keys, np.round(keys)) or (keys[:, 0] < 1).any():
        raise Refused(
            "E1210", end_span(files[0].source), name=paths[0].name, reason="it has unknowns of no node of the deck"
        )
    order = {(int(node), int(direction)): k for k, (node, direction) in enumerate(keys)}
    read = []
    for file, cells in zip(files, tables, strict=True):
        ends = [np.array([order[int(a), int(b)] for a, b in cells[:, k : k + 2]], dtype=np.int64) for k in (0, 2)]
        read.append((file.source, ends[0], ends[1], cells[:, 4]))
    return _assembled(keys.astype(np.int64), read, tuple(files))


def _unknowns(file: SourceFile) -> Integers:
    """`node.direction` of each row, from a `.dof` file."""
    found = []
    for number, line in enumerate(file.text.split("\n"), 1):
        if not line.strip():
            continue
        node, _, direction = line.strip().partition(".")
        if not (node.isascii() and node.isdigit() and direction.isascii() and direction.isdigit() and len(line) < 30):
            text = line.strip()[:40]
            raise Refused("E1201", line_span(file, number), what="the unknown", text=text, expected="`node.direction`")
        found.append((int(node), int(direction)))
        if len(found) > MAX_UNKNOWNS:
            raise Refused("E1204", line_span(file, number), what="the file", limit=MAX_UNKNOWNS, unit="unknowns")
    if not found:
        raise Refused("E1203", None, name=file.name, what="unknowns")
    if max(node for node, _ in found) > 2**62:
        raise Refused(
            "E1201", None, what="the number of a node", text=str(max(found)[0])[:40], expected="a positive integer"
        )
    return np.array(found, dtype=np.int64)


def _cells(file: SourceFile, program: str) -> Floats:
    """The numbers of a matrix file, a row for each line."""
    width = _PER_LINE[program]
    words = file.text.replace(",", " ").split()
    if not words:
        raise Refused("E1203", None, name=file.name, what="entries")
    try:
        values = np.array(words, dtype=np.float64)
    except ValueError:
        values = None
    if values is None or not np.isfinite(values).all() or len(values) % width:
        raise _faulty(file, width)
    return values.reshape(-1, width)


def _faulty(file: SourceFile, width: int) -> Refused:
    """The first line of a matrix file that is wrong; the last one of a file that ends within a line."""
    lines = [(k, line) for k, line in enumerate(file.text.replace(",", " ").split("\n"), 1) if line.strip()]
    for number, line in lines:
        wrong = [word for word in line.split() if number_of(word) is None]
        if wrong:
            return Refused(
                "E1201", line_span(file, number), what="an entry", text=wrong[0][:40], expected="a finite number"
            )
        if len(line.split()) != width:
            what = f"a line of {width} numbers"
            return Refused("E1202", line_span(file, number), what=what)
    return Refused("E1202", end_span(file), what=f"a line of {width} numbers")


def _indices(file: SourceFile, places: Floats, size: int) -> Integers:
    wrong = (places < 1) | (places > size) | (places != np.round(places))
    if wrong.any():
        row = int(np.argmax(wrong.any(axis=1)))
        text = f"{places[row][wrong[row]][0]:g}"
        raise Refused("E1201", _line_of(file, row), what="a row or column", text=text, expected=f"one of 1 to {size}")
    return places.astype(np.int64) - 1


def _line_of(file: SourceFile, row: int) -> Any:
    """The line of an entry: the row-th that is not empty."""
    filled = [number for number, line in enumerate(file.text.split("\n"), 1) if line.strip()]
    return line_span(file, filled[row])


def _assembled(
    keys: Integers, read: list[tuple[SourceFile, Integers, Integers, Floats]], files: tuple[InputFile, ...]
) -> Matrices:
    """Matrices in the order of the nodes, three unknowns each."""
    nodes = np.unique(keys[:, 0])
    known = {(int(node), int(direction)) for node, direction in keys}
    rotations = sorted(key for key in known if key[1] > 3)
    if rotations:
        raise Refused("E1211", None, node=rotations[0][0], direction=rotations[0][1])
    for node in nodes:
        held = [direction for direction in (1, 2, 3) if (int(node), direction) not in known]
        if held:
            raise Refused("E1212", None, node=node, direction=held[0])
    if len(known) < len(keys):
        raise Refused("E1206", None, what="unknown", name="of a node")
    position = {int(node): k for k, node in enumerate(nodes)}
    place = np.array([3 * position[int(node)] + int(direction) - 1 for node, direction in keys])
    size = 3 * len(nodes)
    stiffness, mass = (
        _symmetric(file, place[rows], place[columns], values, size) for file, rows, columns, values in read
    )
    return Matrices(nodes=tuple(int(node) for node in nodes), stiffness=stiffness, mass=mass, files=files)


def _symmetric(file: SourceFile, rows: Integers, columns: Integers, values: Floats, size: int) -> Sparse:
    """A matrix from both of its triangles, or from one of them, whichever the file has."""
    given = sparse.csr_array((values, (rows, columns)), shape=(size, size))
    upper, lower = sparse.triu(given, 1), sparse.tril(given, -1)
    if upper.nnz and lower.nnz and sparse.csr_array(abs(upper)).multiply(abs(lower.T)).nnz:
        scale = abs(given).max()
        if abs(upper - lower.T).max() > _ASYMMETRY * scale:
            raise Refused("E1210", end_span(file), name=Path(file.name).name, reason="it is not symmetric")
        return sparse.csr_array(0.5 * (given + given.T))
    return sparse.csr_array(given + upper.T + lower.T)


_ASYMMETRY = 1e-6
"""Of the largest entry: files have seven digits at least."""
