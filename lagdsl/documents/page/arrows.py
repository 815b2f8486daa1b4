"""Arrows that one can switch on: their part of the head of a page, and the tape that computes them."""

from __future__ import annotations

import zlib
from collections.abc import Collection, Sequence

from lagdsl.derivation.scene.vectors import with_vectors
from lagdsl.documents.page.head import Json, shapes_of
from lagdsl.engines.backends.start import start_of
from lagdsl.engines.backends.tape.emit import tape
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import Compilation, compile_observed

_LARGEST = 250_000  # bytes of the tape, deflated: budgets of pages


def arrows(
    flat: FlatModel,
    compilation: Compilation,
    starts: Collection[str],
    state: tuple[float, Sequence[float]],
    first: int,
    source: SourceFile | None,
) -> tuple[Json, bytes]:
    """For a motion of `compilation`, the model with its scene, that begins in `state` (time; coordinates, rates and
    states): `first` is the column after those that every tape of the model has. None and no bytes where there is
    nothing to show, or where it costs more than a page may."""
    pointed = with_vectors(flat, starts)
    if not pointed.scene.shapes:
        return None, b""
    made = compile_observed(compilation, pointed.flat)
    found = tape(made.program, start_of(made.flat, *state))
    if len(zlib.compress(found)) > _LARGEST:
        return None, b""
    return {"first": first, "shapes": shapes_of(pointed.scene, source)}, found
