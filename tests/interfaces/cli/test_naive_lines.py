"""Command lines as people type them for the first time: helpful words, the right status, no traceback."""

from __future__ import annotations

import shlex
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import Result

Invoke = Callable[..., Result]

LINES = [
    ("pendulum.lag", 2, "the command comes first: lag run pendulum.lag"),
    ("pendulum.lag run", 2, "the command comes first"),
    ("rnu pendulum.lag", 2, "did you mean `run`?"),
    ("simulate pendulum.lag", 2, "write `lag run`"),
    ("plot pendulum.lag", 2, "write `lag run --plot motion.png`"),
    ("solve pendulum.lag", 2, "write `lag run`"),
    ("animate pendulum.lag", 2, "write `lag show`"),
    ("run", 2, "Missing argument 'FILE'"),
    ("run pendulum", 2, "did you mean `pendulum.lag`?"),
    ("run folder", 2, "is a directory"),
    ("run binary.lag", 2, "not a text"),
    ("run pendulum.lag broken.lag", 2, "there is one FILE"),
    ("run broken.lag", 1, "thta"),
    ("run pendulum.lag -m pendulum", 1, "did you mean `Pendulum`?"),
    ("run pendulum.lag -set l=1", 2, "write `--set`"),
    ("run pendulum.lag --set l=1 m", 2, "a value with blanks stands in quotes"),
    ("run pendulum.lag --set l = 1", 2, "a value with blanks stands in quotes"),
    ("run pendulum.lag --set l:1", 2, "expected name=value"),
    ("run pendulum.lag --set length=1", 2, "what can be set: m, l, theta.start"),
    ("run pendulum.lag --set theta=30", 2, "set its start value with --set 'theta.start=...'"),
    ("run pendulum.lag --set theta.start=30grad", 2, "unknown unit `grad`"),
    ("run pendulum.lag --stop ten", 2, "10 or 500 ms"),
    ("run pendulum.lag --stop 5,5", 2, "a number has a decimal point: `5.5`"),
    ("run pendulum.lag --set 'l=0,7 m'", 2, "a number has a decimal point: `0.7 m`"),
    ("run pendulum.lag --set l=1,2,3", 2, "`lag sweep --set` takes ranges and lists"),
    ("run pendulum.lag --set theta.start=30°", 2, "write the unit `deg`: `30 deg`"),
    ("run pendulum.lag --set l==3", 2, "expected a number with or without a unit"),
    ("run pendulum.lag --tstop 5", 2, "no option `--tstop`; write `--stop`"),
    ("run pendulum.lag --dt 0.1", 2, "no option `--dt`; write `--step`"),
    ("run pendulum.lag --rel_tol 1e-3", 2, "No such option"),
    ("run pendulum.lag --tol 1e-3", 2, "no option `--tol`; write `--tolerance`"),
    ("run pendulum.lag --method rk4", 2, "no option `--method`; write `--solver`"),
    ("run pendulum.lag -p l=1", 2, "no option `-p`; write `--set`"),
    ("check pendulum.lag --dt 0.1", 2, "No such option"),
    ("run pendulum.lag --stop 1 m", 2, "there is one FILE"),
    ("run pendulum.lag --intervall 1", 2, "'--interval'"),
    ("run pendulum.lag --solver RK4", 2, "rk4"),
    ("run pendulum.lag --input tau", 2, "written NAME=VALUE"),
    ("run pendulum.lag --input tau=1", 2, "has no input `tau`; inputs: none"),
    ("run pendulum.lag -o nowhere/x.csv", 2, "there is no such directory"),
    ("run pendulum.lag -o folder", 2, "it is a directory"),
    ("run pendulum.lag --stop 1 --stop 2", 2, "`--stop` is given twice"),
    ("run pendulum.lag -o a.csv --output b.csv", 2, "`--output` is given twice"),
    ("run pendulum.lag --solver rk4 --step 1e-12", 2, "is too short"),
    ("show pendulum.lag --from missing.csv", 2, "check the name of the file"),
    ("import missing.urdf", 2, "cannot read"),
    ("sweep pendulum.lag --set l=0.1..1", 2, "a range is first:step:last"),
    ("sweep pendulum.lag --set 'l=0.1 to 1 m'", 2, "a range is first:step:last"),
    ("modes pendulum.lag --vary l", 2, "expected name=value"),
    ("modes pendulum.lag --free l", 2, "give --trim"),
    ("derive pendulum.lag -o x.docx", 2, ".txt, .md, .tex, .html"),
    ("explain pendulum", 2, "function, type or class `pendulum`"),
]


@pytest.mark.parametrize(("line", "status", "words"), LINES, ids=[line for line, _, _ in LINES])
def test_naive_lines(
    invoke: Invoke, pendulum: Path, broken: Path, monkeypatch: pytest.MonkeyPatch, line: str, status: int, words: str
) -> None:
    folder = pendulum.parent
    (folder / "folder").mkdir()
    (folder / "binary.lag").write_bytes(bytes(range(256)))
    monkeypatch.chdir(folder)
    before = sorted(folder.iterdir())
    result = invoke(*shlex.split(line))
    shown = " ".join(result.stderr.replace("│", " ").split())
    assert (result.exit_code, words in shown) == (status, True), shown
    assert isinstance(result.exception, SystemExit)
    assert sorted(folder.iterdir()) == before
