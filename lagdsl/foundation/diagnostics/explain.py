"""The manual page of a diagnostic: `lag explain E0401`."""

from __future__ import annotations

from lagdsl.foundation.diagnostics.catalog import ROWS
from lagdsl.foundation.diagnostics.suggest import nearest
from lagdsl.foundation.resources import diagnostics_folder


class UnknownCode(LookupError):  # noqa: N818 named after what it says
    """No diagnostic has this code; `suggestion` is the nearest one or None."""

    def __init__(self, code: str) -> None:
        super().__init__(code)
        self.code = code
        self.suggestion = _similar(code)

    def __str__(self) -> str:
        text = f"there is no diagnostic `{self.code}`"
        return text if self.suggestion is None else f"{text}; did you mean `{self.suggestion}`?"


def explain(code: str) -> str:
    """The page of `code` as Markdown; `e0401` and `error[E0401]` are understood. Raises UnknownCode."""
    name = code.strip().rpartition("[")[2].rstrip("]").upper()
    if name not in ROWS:
        raise UnknownCode(code)
    return (diagnostics_folder() / f"{name}.md").read_text(encoding="utf-8")


def _similar(code: str) -> str | None:
    """A code with the same number and another letter, else the nearest one."""
    digits = "".join(character for character in code if character.isdigit())
    same_number = [known for known in sorted(ROWS) if digits and known[1:] == digits]
    return same_number[0] if same_number else nearest(code.upper(), ROWS)
