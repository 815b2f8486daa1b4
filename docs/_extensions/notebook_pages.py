"""Pages that the build writes from the executed notebooks: text, cells, outputs."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from execute import names, read
from generated_pages import write
from sphinx.application import Sphinx

_PREFERRED = ("image/png", "text/latex", "text/html", "text/plain")


def generate(app: Sphinx) -> None:
    """Write a page for each notebook beside it."""
    folder = Path(app.srcdir) / "notebooks"
    for name in names():
        write(folder / f"{name}.md", page(name))


def page(name: str) -> str:
    """The text of a page."""
    parts = [f"% The notebook {name}.ipynb"]
    for cell in read(name)["cells"]:
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            parts.append(source)
            continue
        parts.append(f"```{'lag' if source.startswith('%%lag') else 'python'}\n{source}\n```")
        parts += [part for output in cell["outputs"] if (part := shown(output))]
    parts.append(f"This page is `docs/notebooks/{name}.ipynb` of the project.")
    return "\n\n".join(parts) + "\n"


def shown(output: dict[str, Any]) -> str:
    """An output in its richest form that a page can show."""
    data = output.get("data", {"text/plain": output.get("text", [])})
    form = next((form for form in _PREFERRED if form in data), None)
    text = "".join(data.get(form, []))
    match form:
        case "image/png":
            return raw(f'<img alt="figure" src="data:image/png;base64,{text}">')
        case "text/latex":
            return "$$\n" + text.strip().removeprefix("$\\displaystyle ").removesuffix("$") + "\n$$"
        case "text/html":
            return raw(f'<div class="output">{text}</div>')
        case "text/plain" if text.strip():
            return f"```text\n{text.rstrip()}\n```"
        case _:
            return ""


def raw(text: str) -> str:
    """HTML that is shown as it is: it comes from a notebook of this project, run here."""
    return f"````{{raw}} html\n{text}\n````"


def setup(app: Sphinx) -> dict[str, bool]:
    """Write the pages before Sphinx looks for sources."""
    app.connect("builder-inited", generate)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
