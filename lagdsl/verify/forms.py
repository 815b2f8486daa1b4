"""A certificate as text, JSON or HTML."""

from __future__ import annotations

import json
from collections.abc import Callable
from html import escape

from lagdsl.verify.certificate import Certificate, Line

_MARKS = {"held": "ok", "failed": "FAILED", "measured": "..", "left out": "--"}
_STYLE = """body { font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
table { border-collapse: collapse; width: 100%; }
td, th { padding: 0.3rem 0.6rem; text-align: left; vertical-align: top; font-variant-numeric: tabular-nums; }
tr { border-bottom: 1px solid #cbd5e1; }
.failed { color: #b91c1c; font-weight: 600; }
:root { color-scheme: light dark; }"""


def text(certificate: Certificate) -> str:
    """A line for each comparison: mark, name, figure, limit; what it shows below."""
    width = max(len(line.name) for line in certificate.lines)
    pieces = [f"{certificate.model}: {_summary(certificate)}", ""]
    for line in certificate.lines:
        pieces.append(f"{_MARKS[line.verdict]:>6}  {line.name:<{width}}  {_figures(line)}".rstrip())
        pieces.append(f"        {line.says}" + (f" ({line.note})" if line.note else ""))
    pieces += ["", f"text {certificate.digest[:16]}; " + ", ".join(" ".join(pair) for pair in certificate.versions)]
    return "\n".join(pieces) + "\n"


def as_json(certificate: Certificate) -> str:
    """For other tools; figures that are not finite are texts."""
    lines = [
        {
            "name": line.name,
            "says": line.says,
            "verdict": line.verdict,
            "figure": _number(line.figure),
            "limit": _number(line.limit),
            "note": line.note,
        }
        for line in certificate.lines
    ]
    head = {"model": certificate.model, "holds": certificate.holds, "sha256": certificate.digest}
    told = {**head, "versions": dict(certificate.versions), "lines": lines}
    return json.dumps(told, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def html(certificate: Certificate) -> str:
    """One page without a script."""
    rows = "\n".join(_row(line) for line in certificate.lines)
    versions = escape(", ".join(" ".join(pair) for pair in certificate.versions))
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<title>{escape(certificate.model)}: certificate</title>
<style>{_STYLE}</style>
</head>
<body>
<h1>{escape(certificate.model)}</h1>
<p>{escape(_summary(certificate))}</p>
<table>
<tr><th>verdict</th><th>line</th><th>figure, limit</th><th>shows</th></tr>
{rows}
</table>
<p>SHA-256 of the text {certificate.digest}; {versions}</p>
</body>
</html>
"""


def _row(line: Line) -> str:
    cells = (line.verdict, line.name, _figures(line), line.says + (f" ({line.note})" if line.note else ""))
    return f'<tr class="{line.verdict.replace(" ", "-")}">' + "".join(f"<td>{escape(c)}</td>" for c in cells) + "</tr>"


FORMS: dict[str, Callable[[Certificate], str]] = {"text": text, "json": as_json, "html": html}


def _summary(certificate: Certificate) -> str:
    failed = sum(line.verdict == "failed" for line in certificate.lines)
    held = sum(line.verdict == "held" for line in certificate.lines)
    return f"{failed} of {failed + held} lines failed" if failed else f"all {held} lines held"


def _figures(line: Line) -> str:
    if line.figure is None:
        return ""
    return f"{line.figure:.1e}" + (f"  (at most {line.limit:.0e})" if line.limit is not None else "")


def _number(value: float | None) -> float | str | None:
    return value if value is None or abs(value) < float("inf") else str(value)
