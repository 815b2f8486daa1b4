"""The picture of each problem: `python docs/figures/problems.py` writes docs/images/problems.

The model and the times of a picture stand in the page of the problem, in its command `lag run ... --png ... --at ...`.
"""

from __future__ import annotations

import re
from pathlib import Path

from lagdsl.documents.plot.picture.film import write_picture
from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import flatten_file

PAGES = Path(__file__).parents[1] / "problems"
FOLDER = Path(__file__).parents[1] / "images" / "problems"
PIXELS = 480
MODEL = re.compile(r"^```modelica file=(\S+)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
COMMAND = re.compile(r"`lag run (\S+) --png (\S+) --at ([\d.,]+)`")


def main() -> None:
    FOLDER.mkdir(exist_ok=True)
    for page in sorted(set(PAGES.glob("*.md")) - {PAGES / "index.md"}):
        text = page.read_text(encoding="utf-8")
        models = dict(MODEL.findall(text))
        [(name, picture, times)] = COMMAND.findall(text)
        sink = Sink()
        flat = flatten_file(SourceFile(name, models[name]), sink)
        if flat is None:
            raise SystemExit("\n".join(f"{name}: {d.code} {d.message}" for d in sink.diagnostics))
        write_picture(flat, Wishes(), FOLDER / picture, [float(t) for t in times.split(",")], pixels=PIXELS)


if __name__ == "__main__":
    main()
