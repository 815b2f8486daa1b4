"""The description of a model and its motion that a page reads, as JSON: the counterpart of web/src/head.ts."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TypeAlias

from lagdsl.derivation.scene.living import Living
from lagdsl.derivation.scene.shapes import Scene, Shape
from lagdsl.derivation.structure.names import contact_rows
from lagdsl.documents.page.meshes import PackedMesh, packed_meshes
from lagdsl.documents.page.words import WORDS
from lagdsl.documents.plot.picture.recording import up_of
from lagdsl.foundation.source import SourceFile
from lagdsl.foundation.version import __version__
from lagdsl.language.flat.display import Display, display
from lagdsl.language.flat.model import FlatModel, Input, Parameter
from lagdsl.language.flat.quantity import Spans, is_angle
from lagdsl.language.settings.aliases import other_names
from lagdsl.motion.signals.trajectory import Trajectory

Json: TypeAlias = "Mapping[str, Json] | Sequence[Json] | str | float | bool | None"


def head_of(
    model: FlatModel,
    living: Living,
    motion: Trajectory,
    *,
    p: Sequence[float],
    u: Sequence[float],
    source: SourceFile | None,
    span: tuple[float, float],
    tolerance: float,
    said: str,
) -> dict[str, Json]:
    """`motion` is that of `living` over the time `span`, for parameters `p` and, where it begins, inputs `u`. `said` is
    what there is to say of it."""
    from lagdsl.derivation.textbook.provenance import sources

    count = len(living.scene.columns)
    first = len(motion.columns) - count
    independent = [p for p in living.flat.parameters if not p.structural]
    own = {parameter.name for parameter in model.parameters}
    meshes, numbers, undrawn = packed_meshes(living.scene.shapes)
    quantities = (*model.coordinates, *model.states, *model.events.discretes, *model.outputs)
    docs = {item.name: item.doc for item in quantities}
    for name, others in other_names(model).items():
        docs[name] = "; ".join(filter(None, (docs.get(name), f"also {', '.join(others)}")))
    return {
        "name": model.name,
        "doc": model.doc,
        "version": __version__,
        "source": "" if source is None else source.text,
        "planar": living.scene.planar,
        "up": up_of(model, living.scene),
        "start": span[0],
        "stop": span[1],
        "tolerance": tolerance,
        "columns": [
            {
                "name": column.name,
                "kind": column.kind,
                "unit": column.unit,
                "display": _display(column.display),
                "doc": docs.get(column.name),
            }
            for column in motion.columns[:first]
        ],
        "scene": {"first": first, "count": count, "shapes": shapes_of(living.scene, source, numbers)},
        "meshes": [_mesh(mesh) for mesh in meshes],
        "rows": len(motion),
        "events": [{"time": e.time, "name": e.name, "kind": e.kind} for e in motion.events],
        "parameters": [
            _slider(item, value, "parameter" if item.name in own else "start")
            for item, value in zip(independent, p, strict=True)
        ],
        "inputs": [_slider(i, value, "input") for i, value in zip(model.inputs, u, strict=True)],
        "lasting": sorted(contact_rows(model)),
        "differentiable": not model.events.delays,
        "said": " ".join(filter(None, (said, undrawn))),
        "sources": [_span(item.spans, source) for item in sources(model)],
        "words": {str(int(status)): words for status, words in WORDS.items()},
    }


def _slider(item: Parameter | Input, value: float, group: str) -> Json:
    minimum, maximum = _bounds(item)
    return {
        "name": item.name,
        "doc": item.doc,
        "display": _display(display(item)),
        "value": value,
        "minimum": _finite(minimum),
        "maximum": _finite(maximum),
        "kind": item.base,
        "group": group,
        "angle": is_angle(item),
    }


def _bounds(item: Parameter | Input) -> tuple[float | None, float | None]:
    """Between which a value has a meaning, or is expected."""
    if item.base == "Boolean":
        return 0.0, 1.0
    if isinstance(item, Input) and item.literals:
        return 1.0, float(len(item.literals))
    return item.minimum, item.maximum


def _finite(value: float | None) -> float | None:
    return value if value is not None and math.isfinite(value) else None


def _display(shown: Display) -> Json:
    return {"unit": shown.unit, "scale": shown.scale, "shift": shown.shift}


def shapes_of(scene: Scene, source: SourceFile | None, meshes: Mapping[int, int] | None = None) -> list[Json]:
    """`meshes` has the numbers of meshes by those of shapes."""
    known = meshes or {}
    return [
        {**_shape(shape, source), **({"mesh": known[k]} if k in known else {})} for k, shape in enumerate(scene.shapes)
    ]


def _mesh(mesh: PackedMesh) -> Json:
    return {
        "points": mesh.points,
        "triangles": mesh.triangles,
        "low": mesh.low,
        "step": mesh.step,
        "data": mesh.data,
    }


def _shape(shape: Shape, source: SourceFile | None) -> dict[str, Json]:
    return {
        "kind": shape.kind,
        "name": shape.name,
        "numbers": dict(shape.numbers),
        "vectors": list(shape.vectors),
        "texts": dict(shape.texts),
        "span": _span(shape.spans, source),
    }


def _span(spans: Spans, source: SourceFile | None) -> Json:
    """Of the statements behind an item, the innermost in the text that the page shows."""
    for span in spans:
        if source is not None and span.file.name == source.name:
            return {"first": [span.first.line, span.first.column], "last": [span.last.line, span.last.column]}
    return None
