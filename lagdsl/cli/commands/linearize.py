"""`lag linearize FILE`: the matrices of the linearized motion."""

from __future__ import annotations

from typing import Any

import click

from lagdsl.analysis.linearization import Linearization
from lagdsl.analysis.linearize import Named
from lagdsl.analysis.where import linearize
from lagdsl.cli.command import Command
from lagdsl.cli.small_motions import Options, finish, request, takes_state
from lagdsl.cli.state_text import point_text, steadiness_text
from lagdsl.cli.text_table import number, text_table
from lagdsl.numerics.rank import Floats


@click.command("linearize", cls=Command)
@takes_state
def command(options: Options) -> None:
    """Linearize FILE about its initial state: dx/dt = A x + B u, y = C x + D u on the minimal state, in SI units."""
    asked = request(options)
    found = asked.ask(linearize)
    text = "\n\n".join(_parts(found, point_text(asked.system, found.point)))
    finish(asked, text, _data(found), _table(found))


def _parts(found: Linearization, where: str) -> list[str]:
    names = {"x": found.states, "u": found.inputs, "y": found.outputs}
    parts = [f"{found.model}: {len(found.states)} states, linearized at", where, steadiness_text(found.steadiness)]
    parts += _left_out(found)
    for title, matrix, rows, columns in (
        ("A: rates of x by x", found.A, "x", "x"),
        ("B: rates of x by u", found.B, "x", "u"),
        ("C: y by x", found.C, "y", "x"),
        ("D: y by u", found.D, "y", "u"),
    ):
        if matrix.size:
            labels = [f"d/dt {n.name}" if rows == "x" else _label(n) for n in names[rows]]
            body = _matrix(matrix, labels, [_label(n) for n in names[columns]])
            parts.append(f"{title}\n{body}")
    return parts


def _left_out(found: Linearization) -> list[str]:
    names = ", ".join(f"`{each.name}`" for each in found.left_out)
    return [f"Left out: {names}; no other state and no output depends on these charges."] if names else []


def _label(named: Named) -> str:
    return named.name if named.unit in ("", "1") else f"{named.name} [{named.unit}]"


def _matrix(matrix: Floats, rows: list[str], columns: list[str]) -> str:
    cells = [[name, *(number(x) for x in row)] for name, row in zip(rows, matrix.tolist(), strict=True)]
    return text_table(["", *columns], cells)


def _data(found: Linearization) -> dict[str, Any]:
    point = found.point
    return {
        "model": found.model,
        "states": [n.name for n in found.states],
        "inputs": [n.name for n in found.inputs],
        "outputs": [n.name for n in found.outputs],
        "left_out": [n.name for n in found.left_out],
        "state_units": [n.unit for n in found.states],
        "input_units": [n.unit for n in found.inputs],
        "output_units": [n.unit for n in found.outputs],
        "A": found.A,
        "B": found.B,
        "C": found.C,
        "D": found.D,
        "rate": found.rate,
        "kind": found.steadiness.kind,
        "t": point.t,
        "q": point.q,
        "qd": point.qd,
        "z": point.z,
        "u": point.u,
    }


def _table(found: Linearization) -> list[list[Any]]:
    """[A B; C D] with the names of its rows and columns."""
    rows: list[list[Any]] = [["", *(n.name for n in (*found.states, *found.inputs))]]
    for named, a, b in zip(found.states, found.A.tolist(), found.B.tolist(), strict=True):
        rows.append([f"d/dt {named.name}", *a, *b])
    for named, c, d in zip(found.outputs, found.C.tolist(), found.D.tolist(), strict=True):
        rows.append([named.name, *c, *d])
    return rows
