"""Files of strangers as texts: bounded, decoded, with the digest that the provenance names."""

from __future__ import annotations

import hashlib
from pathlib import Path

from lagdsl.exchange.flexible.refusal import Refused
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile

MAX_BYTES = 400_000_000


@record(kw_only=True)
class InputFile:
    """Text of a file and its SHA-256."""

    path: Path
    source: SourceFile
    digest: str


def read_file(path: Path) -> InputFile:
    """The text of a file. Raises Refused, E1200 or E1204."""
    try:
        with path.open("rb") as file:
            content = file.read(MAX_BYTES + 1)
    except (OSError, ValueError) as fault:  # ValueError: a name that no file can have
        reason = fault.strerror if isinstance(fault, OSError) and fault.strerror else str(fault)
        raise Refused("E1200", None, name=path, reason=reason) from None
    if len(content) > MAX_BYTES:
        raise Refused("E1204", None, what=f"`{path}`", limit=MAX_BYTES, unit="bytes")
    text = content.decode("utf-8-sig", errors="replace").replace("\r\n", "\n").replace("\r", "\n")
    return InputFile(path=path, source=SourceFile(str(path), text), digest=hashlib.sha256(content).hexdigest())
