"""`lag trim FILE`: an equilibrium, with inputs free where asked for."""

from __future__ import annotations

from typing import Any

import click

from lagdsl.interfaces.cli.command import Command
from lagdsl.interfaces.cli.small_motions import Options, finish, request, takes_state
from lagdsl.interfaces.cli.state_text import steadiness_text
from lagdsl.interfaces.cli.text_table import number, text_table
from lagdsl.language.flat.display import display, display_rate
from lagdsl.motion.analysis.friction import FrictionForce
from lagdsl.motion.analysis.point import System
from lagdsl.motion.analysis.trim import Equilibrium, all_names
from lagdsl.motion.analysis.where import trim


@click.command("trim", cls=Command)
@takes_state
def command(options: Options) -> None:
    """Find the equilibrium of FILE near its start, or from afar the one that the model at rest falls to: coordinates
    and states at which nothing accelerates. An unstable one is told.

    The option --trim of the other commands is always on here.
    """
    asked = request(options, trim=True)
    found = asked.ask(trim)
    rows = _rows(asked.system, found)
    shown = [
        [name, number(scaled), unit, "unknown" if name in found.unknowns else ""] for name, _, scaled, unit in rows
    ]
    title = f"{found.model}: equilibrium to within {found.residual:.1e} of a natural displacement"
    text = f"{title}\n{text_table(['', 'value', 'unit', ''], shown)}\n{steadiness_text(found.steadiness)}"
    if found.frictions:
        header = ["", "", "force", "limit", "unit", "margin", ""]
        text += f"\nDry friction:\n{text_table(header, [_friction(each) for each in found.frictions])}"
    data = {"model": found.model, "kind": found.steadiness.kind, "residual": found.residual}
    data |= {"growth": list(found.growth)}
    data |= {"names": [row[0] for row in rows], "values": [row[1] for row in rows], "unknowns": list(found.unknowns)}
    data |= {"frictions": [each.name for each in found.frictions], "modes": [each.mode for each in found.frictions]}
    data |= {
        "forces": [each.size for each in found.frictions],
        "limits": [each.limit for each in found.frictions],
        "margins": [each.margin for each in found.frictions],
        "shared": [each.shared for each in found.frictions],
    }
    table: list[list[Any]] = [["name", "value"], *([name, value] for name, value, _, _ in rows)]
    finish(asked, text, data, table)


def _friction(found: FrictionForce) -> list[str]:
    margin = round(found.margin, 9) + 0.0  # no sign of a zero
    shared = "shared" if found.shared else ""
    return [found.name, found.mode, number(found.size), number(found.limit), found.unit, number(margin), shared]


def _rows(system: System, found: Equilibrium) -> list[tuple[str, float, float, str]]:
    """Name, value in SI units, value and unit as shown; rates that are zero are left out."""
    point, flat = found.point, system.flat
    values = [*point.q.tolist(), *point.qd.tolist(), *point.z.tolist(), *point.u.tolist()]
    units = [*map(display, flat.coordinates), *map(display_rate, flat.coordinates)]
    units += [*map(display, flat.states), *map(display, flat.inputs)]
    n = len(point.q)
    return [
        (name, value, unit(value), unit.unit)
        for i, (name, value, unit) in enumerate(zip(all_names(system), values, units, strict=True))
        if not n <= i < 2 * n or abs(value) > 1e-12
    ]
