"""A body as a model text: a class that extends `Lag.Flexible.ModalBody`, with its provenance."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from lagdsl.exchange.flexible.body import Body, Floats, Station, Wire
from lagdsl.exchange.model_text.identifiers import TAKEN, identifier
from lagdsl.exchange.model_text.numbers import array, number
from lagdsl.foundation.record import record
from lagdsl.language.syntax.print_expressions import quoted

DIGITS = 10
"""Of a number in the text; matrices of CalculiX have fourteen, sums over a body lose some."""
NOISE = 1e-9
"""Of the largest element of an array: a smaller one is a rounding error of the solvers, and is written as zero."""
_OWN = (
    "n m com I M K D S H I1 I2 S2 H2 r shape turn shape2 r_a shape_a turn_a shape2_a beta eta floating frame_a frame_b "
    "a b c J h w element change wire wire_r wire_shape Lag"
)


@record(kw_only=True)
class Provenance:
    """The origin of a body: lines of words, and the name of the file that the class names."""

    origin: str
    lines: tuple[str, ...]


def body_model(name: str, body: Body, provenance: Provenance) -> str:
    """The text of the class, a statement a line; the printer of the language breaks and indents the lines."""
    frames = list(zip(_names(body.stations[2:]), body.stations[2:], strict=True))
    parts = [
        *(f"// {_on_one_line(line)}" for line in provenance.lines),
        f"model {name} {quoted(f'Imported from {_on_one_line(provenance.origin)}')}",
        f"extends Lag.Flexible.ModalBody({', '.join(_data(body))});",
        *(f"frame {frame} {quoted(_on_one_line(f'interface {station.name}'))};" for frame, station in frames),
        "protected" if frames or body.wire is not None else "",
        *(f"Lag.Flexible.Node {frame}_node({', '.join(_node(station))}, eta = eta);" for frame, station in frames),
        *([] if body.wire is None else _wire(body.wire)),
        "kinematics" if frames else "",
        *(_placed(frame) for frame, _ in frames),
        f"end {name};",
    ]
    return "\n".join(part for part in parts if part) + "\n"


def _on_one_line(text: str) -> str:
    return "".join(letter if letter.isprintable() else "?" for letter in text)


def _names(stations: Sequence[Station]) -> Iterator[str]:
    used = {*TAKEN, *_OWN.split()}
    for station in stations:
        plain = identifier(station.name.lower() if station.name.isupper() else station.name, "node")
        proposals = [plain, *(f"{plain}_{k}" for k in range(2, len(stations) + 3))]
        free = next(each for each in proposals if each not in used and f"{each}_node" not in used)
        used.update((free, f"{free}_node"))
        yield free


def _data(body: Body) -> Iterator[str]:
    a, b = body.stations[:2]
    yield f"n = {len(body.M)}"
    yield f"m = {number(_rounded(body.mass))}"
    yield from _arrays(com=body.com, I=body.inertia, M=body.M, K=body.K)
    yield from _unless_zero(D=body.D)
    yield from _arrays(S=body.S, H=body.H)
    yield from _unless_zero(I1=body.inertia1, I2=body.inertia2, S2=body.S2, H2=body.H2)
    yield from _arrays(r=b.place, shape=b.shape, turn=b.turn)
    yield from _unless_zero(shape2=b.shape2, r_a=a.place, shape_a=a.shape, turn_a=a.turn)
    if a.shape.any():
        yield from _unless_zero(shape2_a=a.shape2)


def _node(station: Station) -> Iterator[str]:
    yield "n = n"
    yield from _unless_zero(r=station.place, shape=station.shape, turn=station.turn, shape2=station.shape2)


def _placed(frame: str) -> str:
    half = ", ".join(f"{frame}_node.half[{k}]" for k in (1, 2, 3))
    return f"{frame} = floating.move({frame}_node.at).quat({{1, {half}}});"


def _wire(wire: Wire) -> Iterator[str]:
    """The lines are as thick as a hundredth of the smallest box around the body."""
    spread = wire.points.max(axis=0) - wire.points.min(axis=0)
    radius = _rounded(float(np.linalg.norm(spread)) / 400, 2)
    count = len(wire.points)
    yield f"structural parameter Length wire_r[{count}, 3] = {_nested(_clean(wire.points))};"
    yield f"structural parameter Real wire_shape[{count}, 3, n] = {_nested(_clean(wire.shapes))};"
    yield f"Length wire[{count}, 3] = {{{{wire_r[i, j] + wire_shape[i, j, :]*eta for j in 1:3}} for i in 1:{count}}};"
    yield "equation"
    for edge in wire.edges:
        start, end = (f"floating.point(wire[{k + 1}])" for k in edge)
        yield f"draw rod(radius = {number(radius)}) from {start} to {end};"


def _arrays(**values: Floats) -> Iterator[str]:
    for name, value in values.items():
        yield f"{name} = {_nested(_clean(value))}"


def _unless_zero(**values: Floats) -> Iterator[str]:
    yield from _arrays(**{name: value for name, value in values.items() if value.any()})


def _clean(values: Floats) -> Floats:
    return np.where(np.abs(values) > NOISE * np.abs(values).max(), values, 0.0)


def _nested(values: Floats) -> str:
    rows: Iterable[str] = map(_nested, values) if values.ndim > 1 else (number(_rounded(float(v))) for v in values)
    return array(rows)


def _rounded(value: float, digits: int = DIGITS) -> float:
    return float(f"{value:.{digits}g}")
