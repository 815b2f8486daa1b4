"""Diagnostics: what is wrong, where, and the way out. All words live in the catalog."""

from lagdsl.diagnostics.diagnostic import Diagnostic, Edit, Label, Severity
from lagdsl.diagnostics.sink import CompilationFailed, Sink, UnknownName, failed

__all__ = ["CompilationFailed", "Diagnostic", "Edit", "Label", "Severity", "Sink", "UnknownName", "failed"]
