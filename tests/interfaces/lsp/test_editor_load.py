"""Latency and memory of the server while a text of 200 lines is typed."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from time import monotonic

import pytest
from choice import ALL
from lsp_editor import Editor

REST = 0.15
"""Seconds of rest before the server looks at a text; they are no part of the latency."""
EDITS = 1_000, 2_000, 5_000, 10_000
LOOKED_AT = 100
"""Edits between two looks at the text: keys come faster than the server rests."""
KEYS = 100
WHY = "takes minutes; what is typed is the same as in the other tests"


def machine(legs: int) -> str:
    """A walking machine of `legs` legs, each of eleven lines, of parts of the library."""
    lines = ["model Machine", "  import Lag.Planar.*;", "  gravity = -g_n*world.y;"]
    for k in range(1, legs + 1):
        lines += [
            f"  // leg {k}",
            f"  parameter Length a{k} = 0.{k:02d} m, b{k} = 0.3 m;",
            f"  parameter Mass m{k} = {k} kg;",
            f"  Revolute hip{k}(q(start = {k} deg)), knee{k}(q(start = -{k} deg));",
            f"  Link thigh{k}(l = a{k}, m = m{k}), shank{k}(l = b{k}, m = m{k}/2);",
            f"  Fixed base{k}(r = {{{k} m, 0}});",
            f"  TorsionSpring spring{k}(q = knee{k}.q, k = {k} N.m/rad);",
            f"  connect(base{k}, hip{k}, thigh{k}, knee{k}, shank{k});",
            f"  input Torque tau{k};",
            f"  torque tau{k} - 0.1 N.m.s*der(hip{k}.q) on hip{k}.q;",
            f"  output Angle angle{k} = hip{k}.q + knee{k}.q;",
        ]
    return "\n".join([*lines, "end Machine;", ""])


def typed(text: str, k: int) -> str:
    """The text while a statement is typed in its middle, the k-th key."""
    at = text.index("torque tau9")
    return text[:at] + "torque tau9 on hip9.q;"[: k % 22] + "\n  " + text[at:]


def changed(text: str, k: int) -> str:
    """The text with another value: a text without faults, whose whole model is looked at."""
    return text.replace("0.3 m", f"0.{k:04d}1 m", 1)


@pytest.fixture
def editor() -> Iterator[Editor]:
    made = Editor()
    yield made
    made.close()


@pytest.mark.skipif(not ALL, reason=WHY)
def test_latency_of_a_key(editor: Editor, tmp_path: Path) -> None:
    """`LAGDSL_ALL=1 pytest -n 0 -s tests/interfaces/lsp/test_editor_load.py` prints the figures: those of a machine
    that does nothing else count."""
    uri, text = _opened(editor, tmp_path)
    assert text.count("\n") >= 200
    assert _keys(editor, uri, "a statement typed", [typed(text, k) for k in range(KEYS)]) < 0.15
    assert _keys(editor, uri, "a value changed", [changed(text, k) for k in range(KEYS)]) < 0.3


@pytest.mark.skipif(not ALL, reason=WHY)
def test_memory_stays_the_same_over_many_edits(editor: Editor, tmp_path: Path) -> None:
    uri, text = _opened(editor, tmp_path)
    memory = {}
    for k in range(1, EDITS[-1] + 1):
        editor.change(uri, changed(text, k))
        if k % LOOKED_AT == 0:
            editor.diagnostics_of(uri)
        if k in EDITS:
            memory[k] = _memory(editor.process)
    print(", ".join(f"{size / 2**20:.1f} MiB after {k} edits" for k, size in memory.items()))
    assert max(memory.values()) < 1.05 * memory[EDITS[0]]


def _opened(editor: Editor, folder: Path) -> tuple[str, str]:
    text = machine(18)
    uri = editor.open((folder / "machine.lag").as_uri(), text)
    assert editor.diagnostics_of(uri) == [], editor.found
    return uri, text


def _keys(editor: Editor, uri: str, what: str, texts: list[str]) -> float:
    """Seconds of the processor for one key, after which the diagnostics are waited for."""
    before = _processor_time(editor.process)
    latencies = sorted(_latency(editor, uri, text) for text in texts)
    spent = (_processor_time(editor.process) - before) / len(texts)
    middle, late = latencies[len(texts) // 2], latencies[len(texts) * 99 // 100]
    print(f"{what}: median {middle:.3f} s, 99 % {late:.3f} s after {REST} s of rest; processor {spent:.3f} s for a key")
    return spent


def _latency(editor: Editor, uri: str, text: str) -> float:
    """Seconds from the end of the rest after a key to the diagnostics."""
    version = editor.change(uri, text)
    begun = monotonic()
    editor.diagnostics_of(uri)
    return editor.times[uri, version] - begun - REST


def _processor_time(process: int) -> float:
    """Seconds that a process has computed; the time on the wall is that of whatever else the computer does, too."""
    fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def _memory(process: int) -> int:
    """Resident bytes of a process."""
    pages = int(Path(f"/proc/{process}/statm").read_text().split()[1])
    return pages * 4096
