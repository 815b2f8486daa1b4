"""The progress bar: only on a terminal, only for what takes long."""

import sys

import pytest

from lagdsl.cli import progress as module
from lagdsl.cli.progress import progress


def test_nobody_watches(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys.stderr, "isatty", lambda: False, raising=False)
    with progress("Pendulum") as report:
        assert report is None


def test_what_is_quick_shows_nothing(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    with progress("Pendulum") as report:
        assert report is not None
        report(0.5)
    assert capsys.readouterr().err == ""


def test_what_takes_long_shows_a_bar(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(module, "_PATIENCE", 0.0)
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    monkeypatch.setenv("TTY_COMPATIBLE", "1")
    monkeypatch.setenv("TERM", "xterm")  # Rich draws no bar on a terminal that calls itself dumb
    with progress("Pendulum") as report:
        assert report is not None
        report(0.25)
        report(0.5)
    assert "Pendulum" in capsys.readouterr().err
