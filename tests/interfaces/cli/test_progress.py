"""Progress: a bar on a terminal, lines in a pipe, only for what takes long."""

import sys
from collections.abc import Callable
from time import sleep

import pytest

from lagdsl.interfaces.cli import progress as module
from lagdsl.interfaces.cli.progress import progress


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
    monkeypatch.setattr(module, "_PATIENCE", 1000.0)
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    with progress("Pendulum") as report:
        report(0.5)
    assert capsys.readouterr().err == ""


def _on_a_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_PATIENCE", 0.0)
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    monkeypatch.setenv("TTY_COMPATIBLE", "1")
    monkeypatch.setenv("TERM", "xterm")  # Rich draws no bar on a terminal that calls itself dumb


def _wait_for(shown: Callable[[], bool]) -> None:
    for _ in range(1000):
        if shown():
            return
        sleep(0.01)
    raise AssertionError("no bar in ten seconds")


def test_what_takes_long_shows_a_bar(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    _on_a_terminal(monkeypatch)
    said = ""

    def shown(text: str) -> bool:
        nonlocal said
        report(0.25)
        said += capsys.readouterr().err
        return text in said

    with progress("Pendulum") as report:
        _wait_for(lambda: shown("25%"))
    assert "Pendulum" in said


def test_work_that_reports_nothing_shows_a_bar_too(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    _on_a_terminal(monkeypatch)
    with progress("compile"):
        _wait_for(lambda: "compile" in capsys.readouterr().err)


def test_nothing_is_shown_after_the_work(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    _on_a_terminal(monkeypatch)
    monkeypatch.setattr(module, "_PATIENCE", 0.2)
    with pytest.raises(ValueError, match="no model"), progress("compile"):
        raise ValueError("no model")
    sleep(0.5)
    assert capsys.readouterr().err == ""
