"""Pages that the build writes from the code: components of the library, models, diagnostics.

They lie beside the written pages, are not kept in the repository, and change only where their text changes. Hundreds of
entries in the sidebar of every page would make the build ten times as long, so indexes link to them.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import Path

from sphinx.application import Sphinx

from lagdsl.foundation.diagnostics.catalog import ROWS
from lagdsl.language.manual.component_page import component_page
from lagdsl.language.manual.library import class_names, library_class, package_names, package_title
from lagdsl.language.manual.models import model_names, model_title

FAMILIES = {
    "1": "Syntax",
    "2": "Names, classes, components",
    "3": "Values and equations",
    "4": "Dimensions",
    "5": "Physics",
    "6": "Constraints",
    "7": "Connections, joints, loops",
    "8": "Start values, simulation, analysis",
    "9": "Export",
}


def generate(app: Sphinx) -> None:
    """Write all pages into the source folder."""
    folder = Path(app.srcdir)
    components(folder / "reference" / "components")
    write(folder / "reference" / "models.md", models())
    write(folder / "diagnostics" / "index.md", diagnostics(folder / "diagnostics"))


def components(folder: Path) -> None:
    """A page for each class, one for each package, and their index."""
    for name in class_names():
        write(folder / f"{name}.md", linked(escaped(component_page(name))))
    for package in package_names():
        names = [name for name in class_names() if library_class(name).package == package]
        rows = [f"| [{n.rpartition('.')[2]}]({n}.md) | {escaped(title(n))} |" for n in names]
        lines = [f"# {package}", "", f"{escaped(package_title(package))}.", "", "| class | |", "|---|---|", *rows]
        write(folder / f"{package}.md", page([*lines]))
    lines = ["# Components of the library", "", "`lag explain NAME` shows the page of a component in the terminal.", ""]
    lines += [f"- [{package}]({package}.md): {escaped(package_title(package))}" for package in package_names()]
    lines += [
        "",
        "[Packages and imports](../library.md) lists the constants of `Lag.Constants` and the types of `Lag.Units`.",
    ]
    write(folder / "index.md", page(lines))


def linked(text: str) -> str:
    """The names of ancestors become links."""
    return re.sub(r"(?<=[ ,])`(Lag\.\w+\.\w+)`", r"[`\1`](\1.md)", text)


def title(name: str) -> str:
    """The first sentence of the page of a class."""
    return component_page(name).splitlines()[2].removesuffix(".")


def models() -> str:
    """The models that come with the compiler."""
    lines = ["# Models to start from", "", "`lag new --from NAME` copies one of them.", "", "| name | |", "|---|---|"]
    return page([*lines, *(f"| `{name}` | {escaped(model_title(name))} |" for name in model_names())])


def diagnostics(folder: Path) -> str:
    """All diagnostics by family."""
    lines = [
        "# Diagnostics",
        "",
        "`lag explain CODE` shows a page in the terminal. E is an error, W a warning, N a note.",
    ]
    for digit, family in FAMILIES.items():
        codes = sorted((code for code in ROWS if code[2] == digit), key=lambda code: code[1:])
        lines += ["", f"## {family}", "", "| code | |", "|---|---|"]
        lines += [f"| [{code}]({code}.md) | {heading(folder / f'{code}.md')} |" for code in codes]
    return page(lines)


def heading(path: Path) -> str:
    """The first heading of a page, without the code of a diagnostic."""
    return re.sub(r"^# (?:[EWN]\d{4} )?", "", path.read_text(encoding="utf-8").partition("\n")[0])


def page(lines: Iterable[str]) -> str:
    """The text of a page."""
    return "\n".join(lines) + "\n"


def escaped(text: str) -> str:
    """Formulas in doc strings are no emphasis: signs of Markdown count as themselves outside of code."""
    pieces = re.split(r"(^```.*?^```$|`[^`\n]*`)", text, flags=re.DOTALL | re.MULTILINE)
    return "".join(p if k % 2 else re.sub(r"([*_<$\[\]])", r"\\\1", p) for k, p in enumerate(pieces))


def write(path: Path, text: str) -> None:
    """Replace a page where its text is another one, so that the next build reads only what changed."""
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.is_file() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def setup(app: Sphinx) -> dict[str, bool]:
    """Write the pages before Sphinx looks for sources."""
    app.connect("builder-inited", generate)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
