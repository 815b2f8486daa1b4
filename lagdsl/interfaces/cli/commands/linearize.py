"""`lag linearize FILE`: the matrices of the linearized motion."""

from __future__ import annotations

from typing import Any

import click

from lagdsl.foundation.numerics.rank import Floats
from lagdsl.interfaces.cli.command import Command
from lagdsl.interfaces.cli.small_motions import Options, finish, period_or_leave, request, takes_every, takes_state
from lagdsl.interfaces.cli.state_text import point_text, steadiness_text
from lagdsl.interfaces.cli.text_table import number, text_table
from lagdsl.motion.analysis.linearization import Linearization
from lagdsl.motion.analysis.linearize import Named
from lagdsl.motion.analysis.sampled.schedule import time_text
from lagdsl.motion.analysis.sampled.verdict import names_text
from lagdsl.motion.analysis.where import linearize

_STAYS = 1e-9


@click.command("linearize", cls=Command)
@takes_state
@takes_every
def command(options: Options, every: str | None) -> None:
    """Linearize FILE about its initial state: dx/dt = A x + B u, y = C x + D u on the minimal state, in SI units; with
    --every x[k+1] = A x[k] + B u[k]."""
    period = period_or_leave(every)
    asked = request(options)
    found = asked.ask(lambda system, where, sink: linearize(system, where, sink, every=period))
    text = "\n\n".join(_parts(found, point_text(asked.system, found.point)))
    finish(asked, text, _data(found), _table(found))


def _parts(found: Linearization, where: str) -> list[str]:
    names = {"x": found.states, "u": found.inputs, "y": found.outputs}
    head = f"{found.model}: {len(found.states)} states, linearized at"
    what, of_rows = ("rates of x", "d/dt {}") if found.every is None else ("next x", "next {}")
    if found.every is not None:
        head = f"{found.model}: {len(found.states)} states, sampled every {time_text(found.every)}, linearized at"
    parts = [head, where, steadiness_text(found.steadiness) if found.every is None else _change(found)]
    parts += _left_out(found)
    for title, matrix, rows, columns in (
        (f"A: {what} by x", found.A, "x", "x"),
        (f"B: {what} by u", found.B, "x", "u"),
        ("C: y by x", found.C, "y", "x"),
        ("D: y by u", found.D, "y", "u"),
    ):
        if matrix.size:
            labels = [of_rows.format(n.name) if rows == "x" else _label(n) for n in names[rows]]
            body = _matrix(matrix, labels, [_label(n) for n in names[columns]])
            parts.append(f"{title}\n{body}")
    return parts


def _left_out(found: Linearization) -> list[str]:
    names = ", ".join(f"`{each.name}`" for each in found.left_out)
    why = "no other state and no output depends on these charges"
    if found.every is not None:
        why = "nothing at the next instant depends on these"
    told = [f"Left out: {names}; {why}."] if names else []
    return told + ([f"Without {names_text(found.without)}, which small motions do not see."] if found.without else [])


def _change(found: Linearization) -> str:
    """Of a sampled system: does it stay at the point?"""
    moving = [n.name for n, change in zip(found.states, found.rate.tolist(), strict=True) if abs(change) > _STAYS]
    if not moving:
        return "This is a fixed point."
    return f"In one period {', '.join(f'`{name}`' for name in moving)} would change at this point."


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
        "every": found.every,
        "without": list(found.without),
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
        rows.append([f"d/dt {named.name}" if found.every is None else f"next {named.name}", *a, *b])
    for named, c, d in zip(found.outputs, found.C.tolist(), found.D.tolist(), strict=True):
        rows.append([named.name, *c, *d])
    return rows
