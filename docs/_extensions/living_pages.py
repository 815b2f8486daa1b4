"""Living pages on the front page, in the tutorial and in the problems: a frame below the first model of a page.

The pages of `lag show` lie in `living` of the site. On GitHub the texts are as they are written.
"""

from __future__ import annotations

import re
from pathlib import Path

from sphinx.application import Sphinx

from lagdsl.documents.page.page import page
from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import flatten_file

FOLDER = "living"
_PAGES = re.compile(r"index|(tutorial|problems)/.*")
_MODEL = re.compile(r"^```(?:lag|modelica) file=(\S+\.lag)\n(.*?)^```$\n", re.MULTILINE | re.DOTALL)


def embedded(name: str, text: str, folder: Path) -> str:
    """The text of the page `name` with a frame below its first model, whose living page is written into `folder`."""
    found = _MODEL.search(text) if _PAGES.fullmatch(name) else None
    if found is None:
        return text
    file = SourceFile(found[1], found[2])
    flat = flatten_file(file, Sink())
    assert flat is not None, f"{name}: {found[1]} is no model"
    folder.mkdir(parents=True, exist_ok=True)
    target = folder / f"{name.replace('/', '-')}.html"
    target.write_text(page(flat, Wishes(), source=file), encoding="utf-8")
    way = "../" * name.count("/")
    source = f"{way}{FOLDER}/{target.name}"
    frame = f'<iframe class="living" loading="lazy" src="{source}" title="{flat.name}, moving"></iframe>'
    return f"{text[: found.end()]}\n{frame}\n{text[found.end() :]}"


def embed(app: Sphinx, name: str, source: list[str]) -> None:
    source[0] = embedded(name, source[0], Path(app.outdir) / FOLDER)


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("source-read", embed)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
