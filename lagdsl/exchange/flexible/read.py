"""From a file to the text of a body: the one way that the command line and Python share."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from lagdsl.exchange.flexible.body import Body, arrays
from lagdsl.exchange.flexible.deck import read_deck
from lagdsl.exchange.flexible.endings import is_data
from lagdsl.exchange.flexible.files import InputFile, read_file
from lagdsl.exchange.flexible.geometric_stiffness import no_stiffening
from lagdsl.exchange.flexible.matrices import read_matrices
from lagdsl.exchange.flexible.refusal import Refused
from lagdsl.exchange.flexible.sid import read_sid
from lagdsl.exchange.flexible.sid_body import has_negative_energy, no_second_order, sid_body
from lagdsl.exchange.flexible.solid import solid_body
from lagdsl.exchange.flexible.text import Provenance, body_model
from lagdsl.exchange.model_text.identifiers import TAKEN, model_name
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile
from lagdsl.foundation.version import __version__
from lagdsl.language.syntax.printer import format_text

METRES = {"m": 1.0, "cm": 0.01, "mm": 0.001}
"""Units of length of files; forces are in N and times in s, so that the unit of mass is N.s2 per this length."""
DEFAULT_MODES = 6


@record(kw_only=True)
class Reading:
    """Choices of whoever imports: interfaces, the first of which is frame_a and the second frame_b; modes beside their
    static shapes; the unit of length of the file; the common name of the files of matrices, if it is not that of the
    deck."""

    interfaces: tuple[str, ...] = ()
    modes: int = DEFAULT_MODES
    length_unit: str | None = None
    matrices: Path | None = None


def body_text(path: Path, reading: Reading, sink: Sink, name: str | None = None) -> str | None:
    """The text of the body in a file, formatted; None after errors. The class has the name `name`, or that of the
    file."""
    try:
        with np.errstate(all="ignore"):  # numbers that overflow are told below
            body, files = _body(path, reading, sink)
        if not all(np.isfinite(values).all() for values in arrays(body)):
            raise Refused("E1220", None, name=path.name)
    except Refused as refusal:
        sink.report(refusal.code, refusal.span, help=refusal.help, **refusal.arguments)
        return None
    model = model_name(path.stem if name is None else name, "body")
    model = f"{model}Body" if model in TAKEN else model
    text = body_model(model, body, Provenance(origin=path.name, lines=_lines(path, reading, files)))
    written = format_text(SourceFile(str(path), text), sink)
    assert written is not None, sink.diagnostics
    return written


def _body(path: Path, reading: Reading, sink: Sink) -> tuple[Body, tuple[InputFile, ...]]:
    file = read_file(path)
    if reading.length_unit is None:
        raise Refused("E1217", None, name=path.name)
    metre = METRES[reading.length_unit]
    if is_data(path):
        sid = read_sid(file.source)
        names = _interfaces(reading, path, [str(node) for node in sid.nodes])
        body = sid_body(sid, names, metre)
        if has_negative_energy(body):
            sink.report("W1221", None, name=path.name)
        _tell(no_second_order(sid), sink)
        return body, (file,)
    deck = read_deck(file.source)
    names = _interfaces(reading, path, sorted(deck.node_sets))
    matrices = read_matrices(path, reading.matrices)
    body = solid_body(deck, matrices, names, reading.modes, metre)
    _tell(no_stiffening(deck), sink)
    return body, (file, *matrices.files)


def _tell(reason: str | None, sink: Sink) -> None:
    """N1218 for a body that does not stiffen."""
    if reason is not None:
        sink.report("N1218", None, reason=reason)


def _interfaces(reading: Reading, path: Path, known: list[str]) -> tuple[str, ...]:
    if len(reading.interfaces) < 2:
        raise Refused("E1219", None, name=path.name, known=", ".join(known[:12]) or "none")
    return reading.interfaces


def _lines(path: Path, reading: Reading, files: tuple[InputFile, ...]) -> tuple[str, ...]:
    """The version, the options and the digests: the same input gives the same text."""
    deck = [] if is_data(path) else [f"--modes {reading.modes}"]
    interfaces = [f"--interface {name}" for name in reading.interfaces]
    options = " ".join([*interfaces, *deck, f"--length-unit {reading.length_unit}"])
    digests = tuple(f"SHA-256 of {file.path.name}: {file.digest}" for file in files)
    return (f"Written by lagdsl {__version__}: lag import {path.name} {options}", *digests)
