"""The folder `extra`: a motion to compare with and, if wanted, the text of the model, by the layered standard
fmi-ls-ref, version 1.0.0-beta.1, so that tools know what each file is."""

from __future__ import annotations

from collections.abc import Mapping
from xml.sax.saxutils import quoteattr

from lagdsl.exchange.fmi.reference import Reference
from lagdsl.foundation.record import record

_FOLDER = "extra/org.fmi-standard.fmi-ls-ref"
_NAME = "org.fmi-standard.fmi-ls-ref"
_DESCRIPTION = "Layered Standard providing information on related files included in an FMU."
_VERSION = "1.0.0-beta.1"

_ROLES = {
    "reference.csv": ("text/csv", "result", "Motion of the default experiment, by lagdsl, in SI units"),
    "reference_events.csv": ("text/csv", "result", "What happened in this motion"),
    "reference.opt": ("text/plain", "configuration", "Times and tolerance of this motion"),
}


@record()
class _Related:
    path: str
    type: str
    role: str
    description: str
    text: str


def extra_files(known: Reference | None, texts: Mapping[str, str]) -> dict[str, bytes]:
    """`texts` are those of the model; without both there is nothing."""
    related = [_Related(name, *_ROLES[name], text) for name, text in (known.files() if known else {}).items()]
    related += [
        _Related(f"model/{name}", "text/x-lag", "model", "The model as it was written", text)
        for name, text in texts.items()
    ]
    if not related:
        return {}
    files = {f"{_FOLDER}/{each.path}": each.text.encode() for each in related}
    return {**files, f"{_FOLDER}/fmi-ls-manifest.xml": _manifest(related).encode()}


def _manifest(related: list[_Related]) -> str:
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        '<fmiReferences xmlns:fmi-ls="http://fmi-standard.org/fmi-ls-manifest"',
        f'    fmi-ls:fmi-ls-name="{_NAME}" fmi-ls:fmi-ls-version="{_VERSION}"',
        f'    fmi-ls:fmi-ls-description="{_DESCRIPTION}">',
    ]
    for each in related:
        names = {"type": each.type, "source": each.path, "role": each.role, "description": each.description}
        lines.append(f"  <Related {' '.join(f'{name}={quoteattr(text)}' for name, text in names.items())}/>")
    return "\n".join([*lines, "</fmiReferences>", ""])
