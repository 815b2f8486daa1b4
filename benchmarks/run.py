"""Measure, keep the results of every part in results/, write the figures and README.md from all of them.

run.py                    everything: `make bench`
run.py --only arm,text    some parts; the others stay as they were measured last
run.py --only             nothing: README.md and figures anew from what is there
"""

import argparse
import json
import sys
import time
from collections.abc import Callable
from pathlib import Path

import accuracy
import arm
import auto
import bulk
import calls
import chains
import figures
import fits
import fmus
import growth
import iftomm
import living_page
import machine
import motion
import ours
import pages
import peers
import sizes
import start
import steps
import tangents
import tape
import text

HERE = Path(__file__).parent
RESULTS = HERE / "results"
PARTS: dict[str, Callable[[Callable[[str], None]], dict[str, object]]] = {
    "text": text.measure,
    "tape": tape.measure,
    "arm": arm.measure,
    "calls": calls.measure,
    "steps": steps.measure,
    "tangents": tangents.measure,
    "fits": fits.measure,
    "chains": chains.measure,
    "accuracy": accuracy.measure,
    "growth": growth.measure,
    "sizes": sizes.measure,
    "iftomm": iftomm.measure,
    "start": start.measure,
    "auto": auto.measure,
    "ensembles": bulk.ensembles,
    "drive": bulk.drive,
    "runtime": motion.measure,
    "fmus": fmus.measure,
    "living_page": living_page.measure,
}


def say(what: str) -> None:
    """To people who wait."""
    print(f"{time.strftime('%H:%M:%S')} {what}", file=sys.stderr, flush=True)


def keep(name: str) -> None:
    """Measure a part; it replaces what was there only when it is whole."""
    before = machine.describe()
    found = PARTS[name](say)
    answer = {**before, "load after": machine.load(), **found}
    RESULTS.mkdir(exist_ok=True)
    draft = RESULTS / f"{name}.json.new"
    draft.write_text(json.dumps(answer, indent=1, allow_nan=False) + "\n")
    draft.replace(RESULTS / f"{name}.json")


def write() -> tuple[str, str]:
    """README.md and the figures, from the results that are there; the whole page, and the table of targets."""
    found = {path.stem: json.loads(path.read_text()) for path in sorted(RESULTS.glob("*.json"))}
    figures.draw(found, HERE)
    content = pages.page(found)
    (HERE / "README.md").write_text(content, encoding="utf-8")
    return content, pages.summary(found)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", metavar="PARTS", nargs="?", const="", help=f"of {', '.join(PARTS)}, with commas")
    chosen = parser.parse_args().only
    names = list(PARTS) if chosen is None else [name for name in chosen.split(",") if name]
    for name in names:
        if name not in PARTS:
            parser.error(f"there is no part {name}; there are {', '.join(PARTS)}")
    if names and peers.missing():
        say(f"not installed, and left out: {', '.join(peers.missing())} (`make peers`, or PEERS=folder of a venv)")
    if names:
        ours.make("planar_chain", 2)  # compiles the runtime, which is not counted
    for name in names:
        keep(name)
    page, table = write()
    print(page if chosen is None else table)


if __name__ == "__main__":
    main()
