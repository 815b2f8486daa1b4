"""Models of the site move: a frame below the first model of a page, and its living page among the files of the site."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

pytest.importorskip("sphinx", reason="sphinx is not installed: make docs")
sys.path.append(str(Path(__file__).parents[2] / "docs" / "_extensions"))
from living_pages import embedded

TEXT = """# Title

```lag file=a.lag
model A
  coordinate Length x(start = 1 m);
  kinetic 1/2*(1 kg)*der(x)^2;
end A;
```

More.
"""


def test_a_frame_stands_below_the_first_model(tmp_path: Path) -> None:
    found = embedded("tutorial/a", TEXT, tmp_path)
    frame = '<iframe class="living" loading="lazy" src="../living/tutorial-a.html" title="A, moving"></iframe>'
    assert found == TEXT.replace("```\n\nMore", f"```\n\n{frame}\n\nMore")
    assert "<title>A</title>" in (tmp_path / "tutorial-a.html").read_text(encoding="utf-8")
    assert embedded("reference/a", TEXT, tmp_path) == TEXT
