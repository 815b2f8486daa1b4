"""Documentation in an FMU: its ports, parameters and statements, the derivation of its equations, a picture of its
motion, licenses."""

from __future__ import annotations

from dataclasses import replace
from importlib.util import find_spec

from lagdsl.derivation.textbook.recipe import recipe
from lagdsl.documents.report.derivation import document
from lagdsl.documents.report.document import Block, Bullets, Code, Heading, Inline, Text
from lagdsl.documents.report.html import html
from lagdsl.exchange.fmi.export_model import ExportModel
from lagdsl.exchange.fmi.page_tables import tables
from lagdsl.exchange.fmi.reference import Reference
from lagdsl.foundation.resources import license_file
from lagdsl.foundation.version import __version__

_INDEX = "documentation/index.html"
_LICENSE = "documentation/licenses/license.txt"
_ICON = {2: "model.png", 3: "terminalsAndIcons/icon.png"}
_KINDS = {"me": "Model Exchange", "cs": "Co-Simulation"}


def documentation_files(export_model: ExportModel, known: Reference | None, headers: str) -> dict[str, bytes]:
    """`headers` is the text of a header of the standard, which begins with its license. Pictures need Matplotlib."""
    drawn = known is not None and find_spec("matplotlib") is not None
    files = {_LICENSE: _licenses(headers).encode()}
    picture = None
    if known is not None and drawn:
        from lagdsl.documents.plot.figure import plot
        from lagdsl.documents.plot.sheet import icon, png

        picture = png(plot(known.motion))
        files[_ICON[export_model.table.version]] = icon(known.motion)
    whole = document(recipe(export_model.compilation.flat), compilation=export_model.compilation)
    page = replace(whole, blocks=(*tables(export_model.table), *whole.blocks, *_about(export_model, known)))
    return {**files, _INDEX: html(page, picture).encode()}


def _about(export_model: ExportModel, known: Reference | None) -> tuple[Block, ...]:
    table = export_model.table
    kinds = " and ".join(_KINDS[kind] for kind in table.kinds)
    by = f"made by lagdsl {__version__}"
    items: list[Inline] = [
        (Text(f"FMI {table.version}.0, {kinds}, {len(table.variables)} variables; {by}."),),
        (
            Code("sources"),
            Text(" holds all sources of the libraries; for their compilation see "),
            Code("buildDescription.xml"),
            Text("."),
        ),
        (Code("documentation/licenses"), Text(" holds the licenses of what is not the model's own.")),
    ]
    if known is not None:
        why = "" if known.ended is None else f" It ends early: {known.ended}"
        times = f"from {known.motion.time[0]:g} s to {known.motion.time[-1]:g} s"
        words = f" is the motion {times} by lagdsl itself, at the tolerance {known.tolerance:g}, in SI units.{why}"
        items.append((Code("extra/org.fmi-standard.fmi-ls-ref/reference.csv"), Text(words)))
    return (Heading("This file"), Bullets(tuple(items)))


def _licenses(header: str) -> str:
    """The license of lagdsl, then that of the standard's headers as it stands in them."""
    comment = header[header.index("Copyright") : header.index("----*/" if "----*/" in header else "*/")]
    standard = "\n".join(line.strip() for line in comment.rstrip("- \n").splitlines())
    return (
        "The files of the folder sources/lag are parts of lagdsl, under this license:\n\n"
        f"{license_file().read_text(encoding='utf-8').strip()}\n\n"
        "The other C files were generated from the model, which is its author's; the libraries in the folder binaries "
        "are compiled from all of them.\n\n"
        "They were compiled with the headers of the Functional Mock-up Interface, which are under this license:\n\n"
        f"{standard}\n"
    )
