"""The description of a model and its motion that a page reads, as JSON: the counterpart of web/src/head.ts."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import TypeAlias

from lagdsl.derivation.scene.forms import coil
from lagdsl.derivation.scene.living import START
from lagdsl.derivation.scene.shapes import Part, Scene
from lagdsl.derivation.scene.stage import Stage
from lagdsl.derivation.structure.names import contact_rows
from lagdsl.documents.page.packed import packed_form, packed_meshes
from lagdsl.documents.plot.picture.recording import Recording, staged
from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.engines.runtime.structures import WHAT
from lagdsl.engines.runtime.words import WORDS
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.foundation.version import __version__
from lagdsl.language.flat.display import Display, display, drawn_rate
from lagdsl.language.flat.event_flow import branches
from lagdsl.language.flat.events import Check, Contact, Friction, Reset, entries
from lagdsl.language.flat.model import FlatModel, Input, Parameter
from lagdsl.language.flat.quantity import Spans, is_angle
from lagdsl.language.settings.aliases import other_names
from lagdsl.motion.signals.inputs import signals
from lagdsl.motion.signals.trajectory import Trajectory
from lagdsl.motion.simulate.table import event_names

_NONE: Mapping[int, int] = {}
Json: TypeAlias = "Mapping[str, Json] | Sequence[Json] | str | float | bool | None"


def head_of(
    made: Recording, wishes: Wishes, source: SourceFile | None, motions: Sequence[Trajectory] = ()
) -> dict[str, Json]:
    """Of a page that begins with this motion. Sizes are chosen for all `motions`, without them for that one."""
    from lagdsl.derivation.textbook.provenance import sources

    prepared, motion, (start, stop) = made.prepared, made.motion, made.span
    model, living, engine = prepared.own, prepared.living, prepared.engine
    defaults = engine.evaluate("start", start, made.p)[3]
    given = signals(prepared.compilation.flat, defaults, wishes.inputs, made.span, Sink(), speeds=engine.layout.speeds)
    count = len(living.scene.columns)
    first = len(motion.columns) - count
    independent = [p for p in living.flat.parameters if not p.structural]
    own = {parameter.name for parameter in model.parameters}
    stage = staged(model, living.scene, motions or [motion])
    meshes, numbers, undrawn = packed_meshes(living.scene.shapes, stage.meshes)
    quantities = (*model.coordinates, *model.states, *model.events.discretes, *model.outputs)
    docs = {item.name: item.doc for item in quantities}
    named = event_names(living.flat, engine.layout)
    actions = [action for branch in branches(living.flat) for action in branch.actions]
    for name, others in other_names(model).items():
        docs[name] = "; ".join(filter(None, (docs.get(name), f"also {', '.join(others)}")))
    return {
        **fields(model, "name doc"),
        "version": __version__,
        "source": "" if source is None else source.text,
        "inks": "" if source is None else _inks(source.text),
        "planar": living.scene.planar,
        "stage": _stage(stage),
        "start": start,
        "stop": stop,
        "tolerance": made.tolerance,
        "columns": [
            fields(each, "name kind unit", display=_display(each.display, each.kind == "rate"), doc=docs.get(each.name))
            for each in motion.columns[:first]
        ],
        "scene": {"first": first, "count": count, "shapes": shapes_of(living.scene, source, numbers)},
        "meshes": [asdict(mesh) for mesh in meshes],
        "rows": len(motion),
        "events": occurrences(motion),
        "parameters": [
            _slider(item, value, "parameter" if item.name in own else "start")
            for item, value in zip(independent, made.p.tolist(), strict=True)
        ],
        "inputs": [_slider(i, u, "input") for i, u in zip(model.inputs, given.at(start).tolist(), strict=True)],
        "sliders": _sliders(model, living.flat),
        "curves": list(model.page.curves),
        "lasting": sorted(contact_rows(model)),
        "differentiable": not model.events.delays,
        "said": " ".join(filter(None, (made.ended, undrawn))),
        "sources": [_span(item.spans, source) for item in sources(model)],
        "words": {str(int(status)): words for status, words in WORDS.items()},
        "blamed": {
            "entries": [e.item.name if isinstance(e.item, _NAMED) else e.name for e in entries(living.flat.events)],
            "rows": [slot.name for slot in engine.layout.constraints],
            "coordinates": [coordinate.name for coordinate in model.coordinates],
            "conditions": [item.message for item in model.assertions] + [item.name for item in model.invariants],
            "resets": [action.name for action in actions if isinstance(action, Reset)],
            "checks": [action.message for action in actions if isinstance(action, Check)],
            "frictions": [", ".join(friction.name for friction in model.events.frictions)],
        },
        "event_names": [{"kind": kind, "names": list(named.get(kind, ()))} for kind in WHAT],
    }


def fields(item: object, names: str, **more: Json) -> dict[str, Json]:
    """Fields of an item by their names, and what is told besides."""
    return {**{name: getattr(item, name) for name in names.split()}, **more}


def _display(own: Display, is_rate: bool) -> Json:
    return asdict(drawn_rate(own) if is_rate else own)


def _inks(text: str) -> str:
    """Of each character, counted as JavaScript does, the first letter of its kind in the colours of the editors."""
    from lagdsl.language.highlight.pygments_lexer import TOKENS, LagLexer
    from lagdsl.language.highlight.rules import Kind

    plain = (Kind.NAME, Kind.MARK, Kind.OPERATOR)
    letters = {token: kind.value[0] for kind, token in TOKENS.items() if kind not in plain}
    found = LagLexer().get_tokens_unprocessed(text)
    return "".join(letters.get(token, " ") * (len(value.encode("utf-16-le")) // 2) for _, token, value in found)


def _sliders(model: FlatModel, living: FlatModel) -> list[str]:
    """The controls that the page begins with: those of the annotation, else inputs, own parameters, scalars of
    components, and starts that are fixed, else written. Vectors of components are axes and mass centres."""
    if model.page.sliders:
        known = {item.name for item in (*living.parameters, *living.inputs)}
        return [name if name in known else name + START for name in model.page.sliders]
    every = [(c.name + START, c.fixed, c.start_explicit) for c in model.coordinates]
    every += [(f"der({c.name}){START}", c.rate_fixed, c.rate_start_explicit) for c in model.coordinates]
    fixed, written = ([name for name, *flags in every if flags[k]] for k in (0, 1))
    own = [p.name for p in model.parameters if not p.structural and not ("." in p.name and p.name.endswith("]"))]
    return [*(fixed or written), *own, *(item.name for item in model.inputs)]


def _stage(stage: Stage) -> Json:
    """With unit bodies by name: those of the parts, and those that arrows need; points of a coil, if there is one."""
    parts = [part for shape in stage.scene.shapes for part in shape.parts]
    surfaces = {part.form for part in parts if part.primitive == "surface"}
    names = sorted({"arrow", "turning arrow", *surfaces} - {"file"})
    return fields(
        stage, "length scales",
        axes=[axis.tolist() for axis in stage.axes],
        center=stage.center.tolist(),
        boards=[board.T.ravel().tolist() for board in stage.boards],
        coil=coil().round(4).tolist() if any(part.form == "coil" for part in parts) else [],
        forms={name: asdict(packed_form(name, stage.around)) for name in names},
    )  # fmt: skip


def _slider(item: Parameter | Input, value: float, group: str) -> Json:
    """Its bounds are those between which the value has a meaning, or is expected."""
    minimum, maximum = item.minimum, item.maximum
    if item.base == "Boolean":
        minimum, maximum = 0.0, 1.0
    elif isinstance(item, Input) and item.literals:
        minimum, maximum = 1.0, float(len(item.literals))
    shown = _display(display(item), item.name.startswith("der("))
    limits: dict[str, Json] = {"minimum": finite(minimum), "maximum": finite(maximum)}
    more: dict[str, Json] = {"value": value, "kind": item.base, "group": group, "angle": is_angle(item)}
    return fields(item, "name doc", display=shown, **limits, **more)


def finite(value: float | None) -> float | None:
    return value if value is not None and math.isfinite(value) else None


def occurrences(motion: Trajectory) -> list[Json]:
    return [fields(event, "time name kind") for event in motion.events]


def shapes_of(scene: Scene, source: SourceFile | None, meshes: Mapping[int, int] = _NONE) -> list[Json]:
    """`meshes` has the numbers of meshes by those of shapes."""
    found: list[Json] = []
    for k, shape in enumerate(scene.shapes):
        own: dict[str, Json] = {"mesh": meshes[k]} if k in meshes else {}
        own["numbers"] = {role: scene.first(value) for role, value in shape.numbers.items() if role in _VALUES}
        own["parts"] = [_part(scene, part) for part in shape.parts]
        found.append(fields(shape, "kind name texts", span=_span(shape.spans, source), **own))
    return found


# A contact or a friction is blamed by its own name, anything else by its condition.
_NAMED = (Contact, Friction)
# Of these a page tells the values; places stand in the parts.
_VALUES = frozenset({"vector", "value", "mode"})
_USUAL = Part(numbers={})


def _part(scene: Scene, part: Part) -> Json:
    """Without what it shares with most others."""
    numbers = {role: scene.first(value) for role, value in part.numbers.items()}
    told = fields(part, "primitive color", numbers=numbers)
    if part.primitive in ("surface", "line"):
        columns = (-1 if size.value is None else scene.first(size.value) for size in part.sizes)
        sizes = [[size.factor, column, size.relative] for size, column in zip(part.sizes, columns, strict=True)]
        told |= {"form": part.form, "sizes": sizes}
    if part.points:
        told |= {"numbers": {"points": scene.first(part.points)}, "count": len(part.points)}
    own, usual = (fields(each, "shade opacity scale still offset board") for each in (part, _USUAL))
    return told | {name: value for name, value in own.items() if value != usual[name]}


def _span(spans: Spans, source: SourceFile | None) -> Json:
    """Of the statements behind an item, the innermost in the text that the page shows."""
    for span in spans:
        if source is not None and span.file.name == source.name:
            return {"first": [span.first.line, span.first.column], "last": [span.last.line, span.last.column]}
    return None
