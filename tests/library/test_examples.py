"""Every component of the library is used by a model that is compared with a known motion."""

from __future__ import annotations

import re
from pathlib import Path

from choice import together

ROOT = Path(__file__).parents[2]
MODELS = [
    path.read_text(encoding="utf-8") for folder in ("", "library") for path in (ROOT / "models" / folder).glob("*.lag")
]
COMPONENTS = sorted(
    path.relative_to(ROOT / "stdlib").with_suffix("").as_posix().replace("/", ".")
    for path in (ROOT / "stdlib").glob("*/*/*.lag")
    if re.search(r"^(model|joint) ", path.read_text(encoding="utf-8"), re.MULTILINE)
)


@together("name", COMPONENTS)
def test_component_has_an_example(name: str) -> None:
    package, _, short = name.rpartition(".")
    qualified = rf"\b{re.escape(name)}\b"
    imported = rf"import {re.escape(package)}\.(\*|{{[^}}]*\b{short}\b[^}}]*}});"
    declared = rf"^ *{short} \w+(\[\w+\])?( *\(|[,;]| \")"
    assert any(
        re.search(qualified, text) or (re.search(imported, text) and re.search(declared, text, re.MULTILINE))
        for text in MODELS
    )


def test_the_library_is_found() -> None:
    assert {"Lag.Planar.Revolute", "Lag.Spatial.Revolute", "Lag.Forces.Spring"} <= set(COMPONENTS)
    assert not any("TwoPort" in name for name in COMPONENTS)
