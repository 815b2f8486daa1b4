"""Source text and places in it: the ground floor that every later stage points back to."""

from lagdsl.foundation.source.file import SourceFile
from lagdsl.foundation.source.span import Position, Span

__all__ = ["Position", "SourceFile", "Span"]
