"""Fixtures for every test."""

import fcntl
import gc
import os
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from _pytest.runner import runtestprotocol
from choice import ALL, EXPLORE, examples, leave_out
from costs import Costs
from hypothesis import settings
from shared_folder import make_shared_folder

from lagdsl.exchange.fmi.package import toolchain

# The same examples in every run, so that a failure belongs to the change at hand; LAGDSL_EXPLORE=1 looks for new ones.
settings.register_profile("same", deadline=None, derandomize=True, max_examples=examples(100))
settings.register_profile("explore", deadline=None)
settings.load_profile("explore" if EXPLORE else "same")

ROOT = Path(__file__).parents[1]
OBJECTS_PER_COLLECTION = 1_000_000
# Whole motions and random models execute what the tests of the floors execute, too: untraced, in a third of the time.
UNTRACED = ("attack", "benchmarks", "fuzz", "models", "oracle", "packaging", "physics", "properties")


if not ALL:
    # ziglang compiles the models of FMUs in half of the time. Without optimization it looks for undefined behavior of
    # C, which needs a library, unless it is told not to.
    toolchain.COMPILE = (*toolchain.COMPILE, "-O0", "-fno-sanitize=undefined", "-fno-stack-protector")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--cpu", action="store_true", help="list the CPU seconds of test files")


def pytest_configure(config: pytest.Config) -> None:
    folder = make_shared_folder()
    if folder is not None:
        config.add_cleanup(folder.cleanup)
    if config.getoption("cpu"):
        config.pluginmanager.register(Costs())


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_protocol(item: pytest.Item, nextitem: pytest.Item | None) -> bool | None:
    """Processes of pytest-xdist send five messages for each test, which take as long as many a test does. One is enough
    where nothing fails: how it ended."""
    if "PYTEST_XDIST_WORKER" not in os.environ:
        return None
    for report in runtestprotocol(item, nextitem=nextitem, log=False):
        if report.when == "call" or not report.passed or report.user_properties:
            item.ihook.pytest_runtest_logreport(report=report)
    return True


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if not ALL and "LAGDSL_UPDATE" not in os.environ:
        config.hook.pytest_deselected(items=leave_out(items))
    folders = tuple(f"tests/{name}/" for name in UNTRACED)
    for item in items:
        if item.nodeid.startswith(folders):
            item.add_marker(pytest.mark.no_cover)


@pytest.hookimpl(wrapper=True)
def pytest_collection(session: pytest.Session) -> Iterator[None]:
    """In a fresh checkout one process imports everything first: several would all compile the same bytecode.
    The others begin together when it is done."""
    run = os.environ.get("PYTEST_XDIST_TESTRUNUID")
    # With bytecode of an earlier run nobody waits.
    if run is None or (ROOT / "tests" / "exchange" / "verify" / "__pycache__").exists():
        return (yield)
    with Path(tempfile.gettempdir(), f"lagdsl-tests-{run}").open("w", encoding="utf-8") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            fcntl.flock(lock, fcntl.LOCK_SH)
        try:
            return (yield)
        finally:
            Path(lock.name).unlink(missing_ok=True)


def pytest_collection_finish() -> None:
    """The collector of cycles leaves alone the objects that tests and packages are: they stay until the end. Children
    that tests fork share their pages."""
    gc.set_threshold(OBJECTS_PER_COLLECTION, 50, 1000)
    gc.collect()
    gc.freeze()


def pytest_runtest_teardown(item: pytest.Item, nextitem: pytest.Item | None) -> None:
    """Objects that a file of tests leaves behind stay, too, in a few hundred megabytes: to look which of them could go
    takes a tenth of the time."""
    if nextitem is None or nextitem.path != item.path:
        gc.freeze()


@pytest.fixture(scope="session")
def root() -> Path:
    """The checkout."""
    return ROOT
