"""Chapters of a machine that is too large to be written out: how its frames follow each other, the energy of each body,
and the equations of motion in numbers where the motion starts. Like links of a chain are one row with an index."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import fields, replace
from typing import assert_never

import numpy as np

from lagdsl.derivation.textbook.familiar import Familiar
from lagdsl.documents.report.boxes import Box, Column, Matrix, Name, Operator, Row, Subscript, Sum, Upright, bold
from lagdsl.documents.report.boxes import Number as Digits
from lagdsl.documents.report.document import (
    Block,
    Equation,
    Equations,
    Heading,
    Paragraph,
    text,
    with_code,
    with_formulas,
)
from lagdsl.documents.report.notation import dotted
from lagdsl.documents.report.sections.beginnings import with_beginnings
from lagdsl.documents.report.sections.condensed import condensed, condensed_place, condensed_vector
from lagdsl.documents.report.sections.own_words import Words
from lagdsl.documents.report.sections.vectors import by_vectors
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.language.flat.expression import ZERO, FlatExpression, Number, Variable
from lagdsl.language.flat.model import (
    Definition,
    FlatModel,
    Frame,
    FrameStep,
    Move,
    Place,
    Rotate,
    RotateAbout,
    RotateQuaternion,
    SetAxes,
)
from lagdsl.language.flat.traversal import postorder, records, step_expressions
from lagdsl.motion.pipeline import Compilation, compile_flat

_LARGEST_MATRIX = 8
_KINEMATICS = (
    "Turns are about the axes of the frame itself, displacements along them. Rates follow from frame to frame, with "
    "the turn q about n and the way s along n:"
)
_ENERGIES = "Of masses and bodies, each with its own velocity and its own axes, and those that are declared:"
_LEFT_OUT = " Frames that carry nothing are in `lag flat` alone."
_DEFINED = "In these words:"
_DECLARED_ENERGIES = "The energies that are declared:"
_NUMBERS = "Where the motion starts, in SI units and in the order of the coordinates, with the declared start values:"


def kinematics(familiar: Familiar, letter: Callable[[str], Box], words: Words) -> list[Block]:
    """Each frame that turns or moves, as it follows from the one that carries it."""
    zeros = frozenset(familiar.zeros)
    frames = [item for item in familiar.flat.named if isinstance(item, Frame)]
    carrying = _carrying(familiar.flat)
    moved = {"world": "world"}
    rows = []
    for frame in frames:
        parent = moved.get(frame.parent, frame.parent)
        moved[frame.name] = frame.name if frame.steps else parent
        if frame.steps and frame.name in carrying:
            rows.append((frame.name, parent, ", ".join(_step(step, zeros) for step in frame.steps)))
    if not rows:
        return []
    left_out = with_code(_LEFT_OUT) if any(frame.name not in carrying for frame in frames) else ()
    spin, speed, turn, way = bold(letter("ω")), bold(letter("v")), Name("q"), Name("s")
    a, b, n = Upright("a"), Upright("b"), Name("n")
    arm = Row((Subscript(bold(letter("r")), Row((a, b))),))
    carried = Sum(
        (
            ("+", Subscript(speed, a)),
            ("+", Row((Subscript(spin, a), Operator("×"), arm))),
            ("+", Row((dotted(way, 1), n))),
        )
    )
    turned = Sum((("+", Subscript(spin, a)), ("+", Row((dotted(turn, 1), n)))))
    rates = [(Subscript(spin, b), turned), (Subscript(speed, b), carried)]
    return [
        Heading("Kinematics"),
        Paragraph((*with_formulas(_KINEMATICS, rates), *left_out)),
        *words.table(("frame b", "carried by a", "steps"), rows),
    ]


def _carrying(flat: FlatModel) -> set[str]:
    """Frames on which something stands that the equations have, and those that carry them."""
    rest = replace(flat, named=(), drawings=(), outputs=(), observed=(), aliases=(), joints=(), measurements=())
    parts = (rest, *(item for item in flat.named if not isinstance(item, Frame)))
    words = {value for each in records(parts) for value in _words(each)}
    for item in reversed(flat.named):
        if isinstance(item, Frame) and item.name in words:
            words.add(item.parent)
    return words


def _words(part: object) -> Iterator[str]:
    return (value for each in fields(part) if isinstance(value := getattr(part, each.name), str))  # type: ignore[arg-type]


def energies(familiar: Familiar, letter: Callable[[str], Box], words: Words) -> list[Block]:
    """T and V as sums over masses and bodies, with what each of them has."""
    flat, zeros = familiar.flat, frozenset(familiar.zeros)
    rows = [("mass of…", _text(item.mass, zeros), condensed_place(item.position), "") for item in flat.masses]
    for body in flat.bodies:
        inertia = [_text(each, zeros) for each in body.inertia]
        shown = inertia if any(each != "0" for each in inertia[3:]) else inertia[:3]
        center = _vector(body.com, zeros)
        place = body.frame if set(center) <= set("{0, }") else f"{body.frame}.point({center})"
        rows.append((body.label or body.frame, _text(body.mass, zeros), place, ", ".join(shown)))
    if not rows and not flat.energies:
        return []
    declared = [(f"{term.kind} of…", _text(term.value, zeros)) for term in flat.energies]
    return [
        Heading("Energies"),
        Paragraph(with_formulas(_ENERGIES, _forms(flat, letter)) if rows else text(_DECLARED_ENERGIES)),
        *words.table(("T of", "mass", "center", "moments of inertia"), rows),
        *words.sums(declared),
        *_defined(flat, zeros, words),
    ]


def _defined(flat: FlatModel, zeros: frozenset[str], words: Words) -> list[Block]:
    """The definitions that stand in the declared energies and in the places of what has mass, and those in these."""
    values = {item.name: item.value for item in flat.named if isinstance(item, Definition)}
    waiting = [*(term.value for term in flat.energies), *_places(flat)]
    met: set[str] = set()
    idle: set[str] = set()
    while waiting:
        names = {node.name for node in postorder(waiting.pop(), {}) if isinstance(node, Variable)}
        idle |= names & zeros
        new = {name for name in names - met if name in values}
        met |= new
        waiting += [values[name] for name in new]
    rows = by_vectors({name: value for name, value in values.items() if name in met}, lambda each: _text(each, zeros))
    rows += [(parameter, "0") for parameter in sorted(idle)]
    runs = words.runs(with_beginnings(rows))
    return [Paragraph(text(_DEFINED)), *runs] if runs else []


def _places(flat: FlatModel) -> Iterator[FlatExpression]:
    """Expressions that say where masses and bodies are."""
    frames = {item.name: item for item in flat.named if isinstance(item, Frame)}
    carrying = {body.frame for body in flat.bodies}
    for mass in flat.masses:
        yield mass.position
    for name, frame in reversed(frames.items()):
        if name in carrying:
            carrying.add(frame.parent)
            yield from (expression for step in frame.steps for expression in step_expressions(step))


def _forms(flat: FlatModel, letter: Callable[[str], Box]) -> list[tuple[Box, Box]]:
    """T of each carrier, and the sums over all."""
    i, half = Upright("i"), Digits("½")
    v, w = (Subscript(bold(letter(each)), i) for each in ("v", "ω"))
    m, tensor = (Subscript(Name(each), i) for each in ("m", "I"))
    sigma, dot = Upright("Σ"), Operator("·")
    own = Sum((("+", Row((half, m, v, dot, v))), ("+", Row((half, w, dot, tensor, w)))))
    lines: list[tuple[Box, Box]] = [
        (Subscript(letter("T"), i), own),
        (letter("T"), Row((sigma, Subscript(letter("T"), i)))),
    ]
    if flat.gravity is not None:
        fall = Row((sigma, m, Name("𝐠"), dot, Subscript(bold(letter("r")), i)))
        lines.append((letter("V"), Sum((("-", fall),))))
    return lines


def at_the_start(
    familiar: Familiar, letter: Callable[[str], Box], compilation: Compilation | None = None
) -> list[Block]:
    """M and f in numbers, where they fit a page; nothing where the model does not compile."""
    from lagdsl.engines.runtime.engines.selection import engine_of

    count = len(familiar.flat.coordinates)
    if count > _LARGEST_MATRIX:
        return []
    try:
        made = compilation or compile_flat(familiar.flat, Sink())
    except CompilationFailed:
        return []
    if made is None:
        return []
    engine = engine_of(made.program)
    t, p = familiar.flat.experiment.start_time, np.array(engine.layout.defaults, dtype=np.float64)
    q, qd, z, u = engine.evaluate("start", t, p)[:4]
    w = np.zeros(len(engine.layout.discretes))
    mass, forcing = engine.evaluate("dynamics", t, q, qd, z, u, w, p)[:2]
    entries = tuple(tuple(_number(value) for value in row) for row in mass.reshape(count, count).tolist())
    column = Column(tuple(_number(value) for value in forcing.tolist()))
    return [
        Paragraph(text(_NUMBERS)),
        Equations((Equation(letter("M"), Matrix(entries)), Equation(letter("f"), column))),
    ]


def _number(value: float) -> Box:
    shown = f"{abs(value):.4g}" if abs(value) > 1e-12 else "0"
    return Sum((("-", Digits(shown)),)) if value < 0 and shown != "0" else Digits(shown)


def _step(step: FrameStep, zeros: frozenset[str]) -> str:
    """In the words of the language."""
    match step:
        case Rotate(axis, angle):
            return f"rot{'xyz'[axis]}({_text(angle, zeros)})"
        case RotateAbout(axis, angle):
            return f"rotate({_vector(axis, zeros)}, {_text(angle, zeros)})"
        case RotateQuaternion(e):
            return f"rotate({_vector(e, zeros)})"
        case SetAxes():
            return "axes that are given"
        case Move(offset):
            return f"move({_vector(offset, zeros)})"
        case Place(position):
            return f"at({_text(position, zeros)})"
        case _:
            assert_never(step)


def _vector(components: Iterable[FlatExpression], zeros: frozenset[str]) -> str:
    parts = [ZERO if isinstance(each, Variable) and each.name in zeros else each for each in components]
    return condensed_vector(parts)


def _text(expression: FlatExpression, zeros: frozenset[str]) -> str:
    if isinstance(expression, Variable) and expression.name in zeros:
        return "0"
    if isinstance(expression, Number):
        return f"{expression.value:.6g}"
    return condensed(expression)
