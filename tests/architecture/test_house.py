"""The house rules that no other tool holds."""

from __future__ import annotations

import json
import re
import statistics
import subprocess
import sys
from pathlib import Path

import pytest

import lagdsl
from lagdsl.interfaces.cli.main import lag

HEAVY = {"scipy", "sympy", "rich", "matplotlib", "pandas", "pyarrow", "pint", "mpmath"}
GENERATED = {"vocabulary.py"}
# Floors that `lag check` loads: it finds a start, on the tape; and those that `lag run` loads besides.
CHECKED = {
    *("source", "diagnostics", "units", "syntax", "semantics", "flat", "settings", "graph", "numerics", "structure"),
    *("mechanics", "eliminate", "program", "backends", "runtime", "signals", "simulate", "pipeline", "cli"),
    *("collection", "record", "resources", "version"),
}
RUN = {"columns", "api", "plot"}


def _sources(root: Path) -> list[Path]:
    return sorted(p for p in (root / "lagdsl").rglob("*.py") if p.name not in GENERATED)


def _texts(root: Path) -> list[Path]:
    """Every text of the project: what git tracks, or in an unpacked archive what lies there."""
    found = subprocess.run(["git", "ls-files", "-z"], cwd=root, capture_output=True, text=True, check=False)
    if found.returncode == 0:
        paths = [root / name for name in found.stdout.split("\0") if name]
    else:
        paths = [p for folder in ("lagdsl", "tests", "docs", "models") for p in (root / folder).rglob("*")]
    return [p for p in paths if p.is_file() and p.suffix not in (".png", ".pyc")]


def test_modules_of_tests_have_names_of_their_own(root: Path) -> None:
    """Outside packages the name of the file is the name of the module."""
    packages = {p.parent for p in (root / "tests").rglob("__init__.py")}
    names = [p.name for p in (root / "tests").rglob("*.py") if p.name != "conftest.py" and p.parent not in packages]
    assert sorted(names) == sorted(set(names))


def test_files_are_short(root: Path) -> None:
    sizes = [len(p.read_text(encoding="utf-8").splitlines()) for p in _sources(root)]
    assert statistics.median(size for size in sizes if size > 10) <= 170


def test_every_file_says_what_it_is_for(root: Path) -> None:
    for path in _sources(root):
        text = path.read_text(encoding="utf-8")
        assert not text.strip() or text.lstrip().startswith(('"""', "#")), path


def test_every_public_function_of_the_api_is_documented(root: Path) -> None:
    for name in lagdsl.__all__:
        home = getattr(lagdsl, name)
        assert home.__doc__, name
        if isinstance(home, type):
            for attribute, value in vars(home).items():
                if not attribute.startswith("_") and callable(value):
                    assert value.__doc__ or attribute == "of", (name, attribute)


def test_no_path_of_a_machine_in_any_text(root: Path) -> None:
    pattern = re.compile(r"/(?:home|root|Users|work|opt)/[a-z]", re.IGNORECASE)
    ours = [p for p in _texts(root) if "tests" not in p.relative_to(root).parts]
    assert [str(p) for p in ours if pattern.search(p.read_text(encoding="utf-8", errors="replace"))] == []


def _loaded(*arguments: str) -> set[str]:
    """Modules that a process has imported at its end."""
    code = (
        "import sys, json, atexit; "
        "atexit.register(lambda: print(json.dumps(sorted(sys.modules)), file=sys.stderr)); "
        f"sys.argv = {['lag', *arguments]!r}; "
        + ("from lagdsl.interfaces.cli.main import main; main()" if arguments else "import lagdsl")
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return set(json.loads(done.stderr.splitlines()[-1]))


def _packages(modules: set[str]) -> set[str]:
    return {name.partition(".")[0] for name in modules}


def _floors(modules: set[str]) -> set[str]:
    return {name.split(".")[2] for name in modules if name.startswith("lagdsl.") and name.count(".") > 1}


def test_importing_the_package_costs_nothing() -> None:
    assert not _packages(_loaded()) & (HEAVY | {"numpy", "click"})


@pytest.mark.parametrize("model", ["pendulum", "rolling_coin"])
def test_check_loads_its_floors_only(root: Path, model: str) -> None:
    """A module more in every start is a decision: its floor is written here."""
    loaded = _loaded("check", str(root / "models" / f"{model}.lag"))
    assert not _packages(loaded) & HEAVY
    assert _floors(loaded) == CHECKED


def test_a_run_loads_neither_scenes_nor_searches(root: Path) -> None:
    loaded = _loaded("run", str(root / "models" / "double_pendulum.lag"))
    assert not _packages(loaded) & HEAVY
    assert _floors(loaded) == CHECKED | RUN
    assert not loaded & {"lagdsl.documents.plot.picture.recording", "lagdsl.derivation.structure.contradictions"}


def test_formatting_does_not_even_load_numpy(root: Path) -> None:
    assert not _packages(_loaded("fmt", "--check", str(root / "models" / "pendulum.lag"))) & (HEAVY | {"numpy"})


def test_the_readme_tells_what_continuous_integration_runs(root: Path) -> None:
    readme = (root / "README.md").read_text(encoding="utf-8")
    commands = re.findall(r"```sh\n(.*?)```", readme, re.DOTALL)
    assert len(commands) == 2
    script = (root / ".ci" / "run").read_text(encoding="utf-8")
    assert script.splitlines()[-1] == commands[1].strip() == "make check"


def test_the_front_page_begins_with_a_machine_that_runs(root: Path) -> None:
    """After the title: the command that installs, as in the README; a model; the command that runs it; its picture."""
    page = (root / "docs" / "index.md").read_text(encoding="utf-8")
    readme = (root / "README.md").read_text(encoding="utf-8")
    install, model, run = re.findall(r"^```[^\n{]+\n(.*?)^```$", page, re.DOTALL | re.MULTILINE)
    assert page.startswith(f"# lagdsl\n\n```sh\n{install}```\n")
    assert f"```sh\n{install.strip()} && lag run " in readme
    assert len(model.splitlines()) == 8
    assert run.startswith("$ lag run four_bar.lag --png four_bar.png ")
    assert page.index(run) < page.index("(images/four_bar.png)") < page.index("](tutorial/index.md)")


def test_the_readme_shows_the_model_it_ships(root: Path) -> None:
    readme = (root / "README.md").read_text(encoding="utf-8")
    shown = re.search(r"```modelica\n(.*?)```", readme, re.DOTALL)
    assert shown is not None
    assert shown[1] == (root / "models" / "pendulum.lag").read_text(encoding="utf-8")
    assert len(shown[1].splitlines()) == 7


def test_the_readme_names_every_command(root: Path) -> None:
    readme = (root / "README.md").read_text(encoding="utf-8")
    assert isinstance(lag, __import__("click").Group)
    for name in lag.list_commands(None):  # type: ignore[arg-type]
        assert f"`lag {name} " in readme


def test_the_language_reference_speaks_of_every_keyword(root: Path) -> None:
    pages = ("language", "classes", "assembly", "library", "networks")
    reference = "".join((root / "docs" / "reference" / f"{page}.md").read_text(encoding="utf-8") for page in pages)
    grammar = (root / "grammar" / "lagdsl.lark").read_text(encoding="utf-8")
    words = set(re.findall(r'"([a-z]{4,})"', re.sub(r"//.*", "", grammar).split("UNIT:")[0]))
    for group in re.findall(r"/\(\?:([a-z|]+)\)\(", grammar):
        words |= set(group.split("|"))
    missing = sorted(word for word in words if not re.search(rf"\b{word}\b", reference))
    assert missing == []


def test_the_index_lists_every_model(root: Path) -> None:
    index = (root / "models" / "README.md").read_text(encoding="utf-8")
    listed = set(re.findall(r"\]\((\w+\.lag)\)", index))
    assert listed == {p.name for p in (root / "models").glob("*.lag")}
