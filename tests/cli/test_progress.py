"""Progress: a bar on a terminal, lines in a pipe, only for what takes long."""

import sys

import pytest

from lagdsl.cli import progress as module
from lagdsl.cli.progress import progress


def test_a_pipe_gets_a_line_for_each_tenth(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(module, "_PATIENCE_OF_LOGS", 0.0)
    monkeypatch.setattr(sys.stderr, "isatty", lambda: False, raising=False)
    with progress("100 runs") as report:
        for done in range(1, 101):
            report(done / 100)
    assert capsys.readouterr().err.splitlines() == [f"100 runs: {tens} %" for tens in range(10, 100, 10)]


def test_a_pipe_gets_one_line_for_several_tenths(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(module, "_PATIENCE_OF_LOGS", 0.0)
    monkeypatch.setattr(sys.stderr, "isatty", lambda: False, raising=False)
    with progress("Pendulum") as report:
        for done in (0.05, 0.42, 0.44, 1.0):
            report(done)
    assert capsys.readouterr().err == "Pendulum: 40 %\n"


def test_what_is_quick_says_nothing_in_a_pipe(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys.stderr, "isatty", lambda: False, raising=False)
    with progress("Pendulum") as report:
        report(0.5)
    assert capsys.readouterr().err == ""


def test_what_is_quick_shows_nothing(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    with progress("Pendulum") as report:
        report(0.5)
    assert capsys.readouterr().err == ""


def test_what_takes_long_shows_a_bar(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(module, "_PATIENCE", 0.0)
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    monkeypatch.setenv("TTY_COMPATIBLE", "1")
    monkeypatch.setenv("TERM", "xterm")  # Rich draws no bar on a terminal that calls itself dumb
    with progress("Pendulum") as report:
        report(0.25)
        report(0.5)
    assert "Pendulum" in capsys.readouterr().err
