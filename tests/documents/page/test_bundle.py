"""The bundle of pages was built from the sources that are here: `make page`."""

from __future__ import annotations

import hashlib
import re

from lagdsl.engines.runtime.build_wasm import sources_digest
from lagdsl.foundation.resources import page_folder

DIST = page_folder() / "dist"


def test_the_bundle_is_that_of_the_sources() -> None:
    folder = page_folder()
    names = ["build.mjs", "package-lock.json", "package.json", "tsconfig.json"]
    names += [f"src/{path.name}" for path in (folder / "src").iterdir()]
    digest = hashlib.sha256()
    for name in sorted(names):
        digest.update(name.encode() + b"\0" + (folder / name).read_bytes() + b"\0")
    assert (DIST / "sources.sha256").read_text().strip() == digest.hexdigest(), "run `make page`"


def test_the_runtime_is_that_of_the_c_sources() -> None:
    assert (DIST / "lag.wasm.sha256").read_text().strip() == sources_digest(), "run `make page`"


def test_the_notices_of_others_are_there() -> None:
    """The MIT license wants its text in all copies."""
    notices = (DIST / "licenses.txt").read_text()
    assert re.findall(r"^(gifenc|three|uplot) \d+\.\d+\.\d+$", notices, re.MULTILINE) == ["gifenc", "three", "uplot"]
    assert len(re.findall(r"^Copyright .* \S+$", notices, re.MULTILINE)) == 3
    assert notices.count("Permission is hereby granted") == 1  # the same terms


def test_dots_over_letters_are_no_dots_of_curves() -> None:
    """Formulas of the derivation have a class of that name."""
    styles = (DIST / "page.css").read_text(encoding="utf-8")
    assert "mo[class=dot]" in styles and not re.search(r"\.dot\b", styles)
