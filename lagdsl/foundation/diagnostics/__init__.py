"""Diagnostics: what is wrong, where, and the way out. All words live in the catalog."""

from lagdsl.foundation.diagnostics.diagnostic import Diagnostic, Edit, Label, Severity
from lagdsl.foundation.diagnostics.refused import CallRefused, refused
from lagdsl.foundation.diagnostics.sink import CompilationFailed, Sink, UnknownName, failed

__all__ = [
    "CallRefused",
    "CompilationFailed",
    "Diagnostic",
    "Edit",
    "Label",
    "Severity",
    "Sink",
    "UnknownName",
    "failed",
    "refused",
]
