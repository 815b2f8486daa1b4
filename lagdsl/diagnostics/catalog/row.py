"""The shape of a row of the catalog."""

from dataclasses import dataclass

from lagdsl.diagnostics.diagnostic import Severity


@dataclass(frozen=True, slots=True)
class Row:
    """Words of one diagnostic; `{name}` fields are filled with typed arguments by `Sink.report`.

    `message` is one sentence in the user's vocabulary, `label` stands at the caret, `help` is a way out.
    """

    severity: Severity
    message: str
    label: str | None = None
    help: str | None = None


def error(message: str, label: str | None = None, help: str | None = None) -> Row:
    return Row(Severity.ERROR, message, label, help)


def warning(message: str, label: str | None = None, help: str | None = None) -> Row:
    return Row(Severity.WARNING, message, label, help)


def note(message: str, label: str | None = None, help: str | None = None) -> Row:
    return Row(Severity.NOTE, message, label, help)
