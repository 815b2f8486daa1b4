"""Findings that take long: equations, degrees of freedom, the first instant, the page.

They are computed in a process of its own, which reads requests and writes answers, a JSON object a line. The server
ends the process when it waits no longer for an answer.
"""

from __future__ import annotations

import json
import os
import sys
from dataclasses import field
from pathlib import Path
from typing import Any, BinaryIO

from lagdsl.foundation.diagnostics import Diagnostic
from lagdsl.foundation.record import record
from lagdsl.foundation.source import SourceFile

_MOST_ACCELERATIONS = 6  # coordinates, beyond which nobody reads the equations beside a name


_NICENESS = 5  # the process gives way to what answers a key


@record(kw_only=True)
class Request:
    """A text to look at; with `page` the living page of its model is written there. `held` are the texts of other files
    that the editor holds, by their paths."""

    name: str
    text: str
    page: str | None = None
    held: dict[str, str] = field(default_factory=dict)


@record(kw_only=True)
class Depth:
    """`found` are diagnostics as (code, severity, message, help, notes, start, end), places in the text itself;
    `freedom` one line about the degrees of freedom of `model`; `redundant` numbers of redundant rows by the places of
    their `connect`; `equations` of motion by coordinate; `page`: True if the page was written."""

    model: str | None = None
    found: list[list[Any]] = field(default_factory=list)
    freedom: str | None = None
    redundant: list[tuple[int, int]] = field(default_factory=list)
    equations: dict[str, str] = field(default_factory=dict)
    page: bool = False


def examine(request: Request) -> Depth:
    """All of `lag check`, and what hovers and hints show of its products."""
    from lagdsl.language.semantics.classes.library import hold
    from lagdsl.motion.pipeline import check

    hold(request.held)
    file = SourceFile(request.name, request.text)
    diagnostics, compilation = check(file)
    found = [_told(each, file) for each in diagnostics]
    if compilation is None:
        return Depth(found=found)
    from lagdsl.derivation.structure.structure import structure_text

    flat, flags = compilation.flat, compilation.structure.redundant
    names = [slot.name for slot in compilation.program.layout.constraints]
    redundant = {name for name, flag in zip(names, flags, strict=True) if flag}
    rows: dict[int, int] = {}
    for constraint in flat.constraints:
        if constraint.closure is not None and constraint.closure.span.file is file:
            start = constraint.closure.span.start
            rows[start] = rows.get(start, 0) + len(redundant.intersection(constraint.rows))
    return Depth(
        model=flat.name,
        found=found,
        freedom=structure_text(compilation.structure),
        redundant=[(start, count) for start, count in rows.items() if count],
        equations=_equations(flat) if len(flat.coordinates) <= _MOST_ACCELERATIONS else {},
        page=_write_page(flat, request, file),
    )


def _told(found: Diagnostic, file: SourceFile) -> list[Any]:
    span = found.labels[0].span if found.labels and found.labels[0].span.file is file else None
    place = (span.start, span.end) if span is not None else (None, None)
    return [found.code, str(found.severity), found.message, found.help, list(found.notes), *place]


def _equations(flat: Any) -> dict[str, str]:
    """Left and right side of each equation as one line."""
    from lagdsl.derivation.textbook.recipe import recipe
    from lagdsl.documents.report.listing import listing

    listed = json.loads(listing(recipe(flat)))
    sides: dict[tuple[int, str], list[str]] = {}
    for term in listed.get("terms", ()):
        sides.setdefault((term["equation"], term["side"]), []).append(term["text"])
    return {
        name: f"{_sum(sides.get((k, 'left'), []))} = {_sum(sides.get((k, 'right'), []))}"
        for k, name in enumerate(listed["coordinates"])
        if (k, "left") in sides
    }


def _sum(terms: list[str]) -> str:
    return " + ".join(terms).replace("+ −", "− ").replace("+ -", "- ") or "0"


def _write_page(flat: Any, request: Request, file: SourceFile) -> bool:
    if request.page is None:
        return False
    from lagdsl.documents.page.page import page
    from lagdsl.documents.plot.picture.wishes import Wishes
    from lagdsl.foundation.source.whole_file import whole_file

    with whole_file(Path(request.page)) as draft:
        draft.write_text(page(flat, Wishes(), source=file), encoding="utf-8")
    return True


def serve(requests: BinaryIO, answers: BinaryIO) -> None:
    """Answers requests until there are no more; a text that makes the compiler fail has no findings."""
    for line in requests:
        given: dict[str, Any] = json.loads(line)
        try:
            depth = examine(Request(**given))
        except Exception as failure:  # the editor must not lose its process by one text
            print(f"lag lsp: {type(failure).__name__}: {failure}", file=sys.stderr)
            depth = Depth()
        answers.write(json.dumps({name: getattr(depth, name) for name in Depth.__annotations__}).encode() + b"\n")
        answers.flush()


def main() -> None:
    """Requests from standard input, answers to what standard output was; nothing else is written there."""
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    if hasattr(os, "nice"):
        os.nice(_NICENESS)
    serve(sys.stdin.buffer, answers)


if __name__ == "__main__":
    main()
