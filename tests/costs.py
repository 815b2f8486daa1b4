"""CPU seconds of tests, those of the processes that they start included: `pytest --cpu FOLDER` lists them by file, and
tests by name, all their cases together."""

from __future__ import annotations

import resource
from collections import Counter

import pytest

LEAST = 0.5  # seconds, of a file or a test that is listed


class Costs:
    """Each report carries what was spent since the one before it: all that is spent after collection is counted."""

    def __init__(self) -> None:
        self._of_files: Counter[str] = Counter()
        self._of_tests: Counter[str] = Counter()
        self._before = 0.0

    def pytest_collection_finish(self) -> None:
        self._before = _spent()

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_makereport(self) -> pytest.TestReport:
        report = yield
        now = _spent()
        report.user_properties.append(("cpu", now - self._before))
        self._before = now
        return report

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        seconds = sum(value for name, value in report.user_properties if name == "cpu")
        self._of_files[report.nodeid.partition("::")[0]] += seconds
        self._of_tests[report.nodeid.partition("[")[0]] += seconds

    def pytest_terminal_summary(self, terminalreporter: pytest.TerminalReporter) -> None:
        terminalreporter.section(f"CPU seconds: {self._of_files.total():.0f}")
        for kind in (self._of_files, self._of_tests):
            for name, seconds in kind.most_common():
                if seconds >= LEAST:
                    terminalreporter.write_line(f"{seconds:8.1f} {name}")


def _spent() -> float:
    """User and system time of this process and of its children that have ended [s]."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(each.ru_utime + each.ru_stime for each in used)
