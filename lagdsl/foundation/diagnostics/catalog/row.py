"""The shape of a row of the catalog."""

from lagdsl.foundation.diagnostics.diagnostic import Severity
from lagdsl.foundation.record import record


@record()
class Row:
    """Words of one diagnostic; `{name}` fields are filled with typed arguments by `Sink.report`.

    `message` is one sentence in the user's vocabulary, `label` stands at the caret, `secondary` at other places that
    come without words of their own, `help` is a way out. `fix` is the text that `help` proposes in place of what stands
    at the caret.
    """

    severity: Severity
    message: str
    label: str | None = None
    help: str | None = None
    secondary: str | None = None
    fix: str | None = None


def error(
    message: str,
    label: str | None = None,
    help: str | None = None,
    secondary: str | None = None,
    fix: str | None = None,
) -> Row:
    return Row(Severity.ERROR, message, label, help, secondary, fix)


def warning(message: str, label: str | None = None, help: str | None = None, secondary: str | None = None) -> Row:
    return Row(Severity.WARNING, message, label, help, secondary)


def note(message: str, label: str | None = None, help: str | None = None, secondary: str | None = None) -> Row:
    return Row(Severity.NOTE, message, label, help, secondary)
