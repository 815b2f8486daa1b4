"""Source text and places in it: the ground floor that every later stage points back to."""

from lagdsl.source.file import SourceFile
from lagdsl.source.span import Position, Span

__all__ = ["Position", "SourceFile", "Span"]
