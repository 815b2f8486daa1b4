"""The product of `lag verify`: what was compared, by how much it differs, how much it may."""

from __future__ import annotations

from typing import Literal, TypeAlias

from lagdsl.record import record

Verdict: TypeAlias = Literal["held", "failed", "measured", "left out"]


@record(kw_only=True)
class Line:
    """One comparison. `figure` is what was measured, at most `limit` where it holds; None where nothing was measured.

    `says` tells what the line shows, `note` where the figure is largest, or why the line was left out.
    """

    name: str
    says: str
    figure: float | None = None
    limit: float | None = None
    note: str = ""

    @property
    def verdict(self) -> Verdict:
        if self.figure is None:
            return "left out"
        if self.limit is None:
            return "measured"
        return "held" if self.figure <= self.limit else "failed"


@record(kw_only=True)
class Certificate:
    """All lines of one model, with versions and the digest of its text, so that it can be repeated."""

    model: str
    digest: str
    versions: tuple[tuple[str, str], ...]
    lines: tuple[Line, ...]

    @property
    def holds(self) -> bool:
        return all(line.verdict != "failed" for line in self.lines)

    def __str__(self) -> str:
        from lagdsl.verify.forms import text

        return text(self)
