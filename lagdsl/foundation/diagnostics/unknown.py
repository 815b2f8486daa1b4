"""A name that nothing has."""

from __future__ import annotations

from collections.abc import Sequence

from lagdsl.foundation.diagnostics.sink import CompilationFailed, Sink, failed
from lagdsl.foundation.diagnostics.suggest import did_you_mean, listing


def unknown_among(what: str, name: str, names: Sequence[str]) -> CompilationFailed:
    """UnknownName (E0874) for a name that is none of `names`, with the nearest of them, or with all."""
    listed = f"there are {listing(str(name), names)}"
    hint = did_you_mean(name, names, listed) if isinstance(name, str) else listed
    return unknown(what, name, hint or listed)


def unknown(what: str, name: str, hint: str) -> CompilationFailed:
    """The same with a hint of one's own."""
    sink = Sink()
    sink.report("E0874", None, what=what, name=name, hint=hint)
    return failed(sink.diagnostics)
