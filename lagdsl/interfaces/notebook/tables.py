"""Results of analyses as tables with units, in HTML."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from html import escape
from typing import Any

import numpy as np

from lagdsl.exchange.verify.certificate import Certificate
from lagdsl.motion.analysis.linearization import Linearization
from lagdsl.motion.analysis.variation import Variation

_MOST_ROWS = 60


def variation_table(found: Variation) -> str:
    """Thresholds, and the largest real part over the values."""
    unit = _unit(found.varied.unit)
    head = [f"{found.varied.name}{unit}", "threshold", "frequency [Hz]", "unstable"]
    rows = [
        [_number(each.value), each.kind, _number(each.frequency), "above" if each.unstable_above else "below"]
        for each in found.thresholds
    ]
    spectrum_head = [f"{found.varied.name}{unit}", "growing modes", "largest real part [1/s]"]
    spectrum = [
        [_number(value), "-" if count < 0 else str(count), _number(float(np.max(branch.real)))]
        for value, count, branch in zip(found.values, found.unstable, found.eigenvalues, strict=True)
    ]
    thresholds = table("Thresholds", head, rows) if rows else "<p>No threshold between the values.</p>"
    return f"<b>{escape(found.model)}</b>{thresholds}{table('Values', spectrum_head, spectrum)}"


def linearization_table(found: Linearization) -> str:
    """The matrices with the names and units of their rows and columns."""
    states = [f"{each.name}{_unit(each.unit)}" for each in found.states]
    inputs = [f"{each.name}{_unit(each.unit)}" for each in found.inputs]
    outputs = [f"{each.name}{_unit(each.unit)}" for each in found.outputs]
    parts = [("A", found.A, states, states), ("B", found.B, states, inputs)]
    parts += [("C", found.C, outputs, states), ("D", found.D, outputs, inputs)]
    made = [_matrix(name, matrix, rows, columns) for name, matrix, rows, columns in parts if rows and columns]
    names = ", ".join(each.name for each in found.left_out)
    told = f"<p>Left out: {escape(names)}; no other state and no output depends on these charges.</p>"
    return f"<b>{escape(found.model)}</b>{told if names else ''}{''.join(made)}"


def certificate_table(found: Certificate) -> str:
    """A row for each comparison."""
    rows = [[line.verdict, line.name, line.figures, line.says] for line in found.lines]
    return table(f"{found.model}: {found.summary}", ["", "comparison", "figures", "meaning"], rows)


def table(title: str, head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """An HTML table; of many rows the first and the last ones."""
    listed = list(rows)
    if len(listed) > _MOST_ROWS:
        half = _MOST_ROWS // 2
        listed = [*listed[:half], ["..."] * len(head), *listed[-half:]]
    cells = "".join(f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>" for row in listed)
    names = "".join(f"<th>{escape(name)}</th>" for name in head)
    return f"<table><caption>{escape(title)}</caption><thead><tr>{names}</tr></thead><tbody>{cells}</tbody></table>"


def _matrix(name: str, matrix: Any, rows: list[str], columns: list[str]) -> str:
    entries = [[row, *(_number(float(value)) for value in line)] for row, line in zip(rows, matrix, strict=True)]
    return table(name, ["", *columns], entries)


def _unit(unit: str) -> str:
    return "" if unit == "1" else f" [{unit}]"


def _number(value: float) -> str:
    return f"{value:.6g}"


FORMS: dict[tuple[str, str], Callable[[Any], str]] = {
    (Variation.__module__, Variation.__name__): variation_table,
    (Linearization.__module__, Linearization.__name__): linearization_table,
    (Certificate.__module__, Certificate.__name__): certificate_table,
}
