"""A message of a stage about a model: product of the diagnostics floor."""

from enum import StrEnum

from lagdsl.foundation.record import record
from lagdsl.foundation.source import Span


class Severity(StrEnum):
    """Importance of a diagnostic; an error stops the compiler after its stage."""

    ERROR = "error"
    WARNING = "warning"
    NOTE = "note"


@record()
class Label:
    """A place and what it has to do with the matter."""

    span: Span
    text: str = ""


@record()
class Edit:
    """`text` in place of what stands at `span`; an empty span is a place between two characters."""

    span: Span
    text: str


@record(kw_only=True)
class Diagnostic:
    """One fact about a model text.

    The words come from the row of `code` in the catalog; `labels[0]` is the primary place (caret `^`), the others
    explain it. `edit` is the change that `help` proposes, where it proposes one change only.
    """

    code: str
    severity: Severity
    message: str
    labels: tuple[Label, ...] = ()
    notes: tuple[str, ...] = ()
    help: str | None = None
    edit: Edit | None = None
