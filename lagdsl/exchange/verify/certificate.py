"""The product of `lag verify`: what was compared, by how much it differs, how much it may."""

from __future__ import annotations

from typing import Literal, TypeAlias

from lagdsl.foundation.record import record

_MARKS = {"held": "ok", "failed": "FAILED", "measured": "..", "left out": "--"}
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

    @property
    def figures(self) -> str:
        """Figure and limit as people read them."""
        if self.figure is None:
            return ""
        return f"{self.figure:.1e}" + (f"  (at most {self.limit:.0e})" if self.limit is not None else "")


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

    @property
    def summary(self) -> str:
        failed = sum(line.verdict == "failed" for line in self.lines)
        held = sum(line.verdict == "held" for line in self.lines)
        return f"{failed} of {failed + held} lines failed" if failed else f"all {held} lines held"

    def __str__(self) -> str:
        """A line for each comparison: mark, name, figure, limit; its meaning below."""
        width = max(len(line.name) for line in self.lines)
        pieces = [f"{self.model}: {self.summary}", ""]
        for line in self.lines:
            pieces.append(f"{_MARKS[line.verdict]:>6}  {line.name:<{width}}  {line.figures}".rstrip())
            pieces.append(f"        {line.says}" + (f" ({line.note})" if line.note else ""))
        pieces += ["", f"text {self.digest[:16]}; " + ", ".join(" ".join(pair) for pair in self.versions)]
        return "\n".join(pieces) + "\n"
