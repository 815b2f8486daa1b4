"""A certificate as text, JSON or HTML."""

from __future__ import annotations

import json
from collections.abc import Callable
from html import escape

from lagdsl.exchange.verify.certificate import Certificate, Line

_STYLE = """body { font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
table { border-collapse: collapse; width: 100%; }
td, th { padding: 0.3rem 0.6rem; text-align: left; vertical-align: top; font-variant-numeric: tabular-nums; }
tr { border-bottom: 1px solid #cbd5e1; }
.failed { color: #b91c1c; font-weight: 600; }
:root { color-scheme: light dark; }"""


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
<p>{escape(certificate.summary)}</p>
<table>
<tr><th>verdict</th><th>line</th><th>figure, limit</th><th>shows</th></tr>
{rows}
</table>
<p>SHA-256 of the text {certificate.digest}; {versions}</p>
</body>
</html>
"""


def _row(line: Line) -> str:
    cells = (line.verdict, line.name, line.figures, line.says + (f" ({line.note})" if line.note else ""))
    return f'<tr class="{line.verdict.replace(" ", "-")}">' + "".join(f"<td>{escape(c)}</td>" for c in cells) + "</tr>"


FORMS: dict[str, Callable[[Certificate], str]] = {"text": str, "json": as_json, "html": html}


def _number(value: float | None) -> float | str | None:
    return value if value is None or abs(value) < float("inf") else str(value)
