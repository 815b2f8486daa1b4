"""The model text of a flexible body."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Literal

from lagdsl.foundation.diagnostics import Sink


def import_body(
    path: Path | str,
    interfaces: Sequence[str],
    *,
    length_unit: Literal["m", "cm", "mm"],
    modes: int = 6,
    matrices: Path | str | None = None,
    name: str | None = None,
    sink: Sink | None = None,
) -> str:
    """The text of a class that extends `Lag.Flexible.ModalBody`, from an input deck of CalculiX or Abaqus with the
    matrices of the free body beside it, or from Standard Input Data (`.SID_FEM`).

    `interfaces` are sets of nodes of the deck, or numbers of nodes of the data: the first is frame_a, at which the body
    is held, the second frame_b, others have frames of their names. `modes` is the number of modes with all interfaces
    held, beside six static shapes for each interface but the first. `length_unit` is that of the file; forces are in N,
    times in s. `matrices` is the common name of the files of matrices, where it is not that of the deck. The class has
    the name `name`, or that of the file. Notes go to `sink`. Raises CompilationFailed with the place in the file.
    """
    from lagdsl.exchange.flexible.read import Reading, body_text

    own = Sink() if sink is None else sink
    stem = None if matrices is None else Path(matrices)
    reading = Reading(interfaces=tuple(interfaces), modes=modes, length_unit=length_unit, matrices=stem)
    text = body_text(Path(path), reading, own, name)
    own.raise_if_errors()
    assert text is not None, "internal error: the import gave up without saying why"
    return text
