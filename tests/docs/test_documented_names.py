"""Commands, options, extras, components and targets of make that the documents name exist; classes have doc strings."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from pathlib import Path

import click
import pytest

import lagdsl
from lagdsl.foundation.diagnostics.catalog import ROWS
from lagdsl.foundation.resources import library_folder
from lagdsl.interfaces.cli.main import lag
from lagdsl.language.manual.library import class_names

ROOT = Path(__file__).parents[2]
CODE = re.compile(r"^```[a-z]*[^\n]*\n(.*?)^```|`([^`\n]+)`", re.DOTALL | re.MULTILINE)
COMMAND = re.compile(r"(?:^|[\s$/(&])lag ([a-z]+)((?:[^\n&|]|\\\n)*)", re.MULTILINE)
# Lists of components: a page and the packages that it presents.
LISTS = {
    "networks.md": ("Lag.Rotational", "Lag.Translational", "Lag.Electrical"),
    "mechanical_library.md": ("Lag.Planar", "Lag.Spatial", "Lag.Forces"),
    "flexible_library.md": ("Lag.Flexible",),
    "library.md": ("Lag.Blocks",),
}
# Classes to extend and aliases of packages nearby, which the generated list of docs/reference/library.md has.
IN_THE_GENERATED_LIST = {"TwoPort", "AxisJoint"}


def pages() -> list[Path]:
    """Pages that a person wrote; decisions speak of their time."""
    own = [ROOT / name for name in ("README.md", "ARCHITECTURE.md", "CONTRIBUTING.md")]
    lines = (ROOT / ".gitignore").read_text(encoding="utf-8").splitlines()
    generated = tuple(line[1:] for line in lines if line.startswith("/docs/"))
    written = [p for p in sorted((ROOT / "docs").rglob("*.md")) if p.parent.name != "adr"]
    return own + [page for page in written if not page.relative_to(ROOT).as_posix().startswith(generated)]


def commands() -> dict[str, click.Command]:
    """Every command, loaded."""
    context = click.Context(lag)
    found = {name: lag.get_command(context, name) for name in lag.list_commands(context)}
    return {name: command for name, command in found.items() if command is not None}


def code(page: Path) -> Iterator[str]:
    for block, span in CODE.findall(page.read_text(encoding="utf-8")):
        yield block or span


def test_commands_and_their_options_exist() -> None:
    options = {
        name: {word for parameter in command.params for word in (*parameter.opts, *parameter.secondary_opts)}
        for name, command in commands().items()
    }
    found = [(page.name, *call) for page in pages() for text in code(page) for call in COMMAND.findall(text)]
    assert len(found) > 100
    assert {name for _, name, _ in found} >= set(options), "a command stands in no document"
    unknown = [(page, name) for page, name, _ in found if name not in options]
    assert unknown == []
    wrong = [
        (page, name, option)
        for page, name, rest in found
        for option in re.findall(r"(?<![\w-])--[a-z][a-z-]*", re.sub(r"'[^']*'|#.*", "", rest))
        if option not in options[name] | {"--help"}
    ]
    assert wrong == []


def test_the_example_of_the_readme_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "models").symlink_to(ROOT / "models")
    monkeypatch.chdir(tmp_path)
    [text] = re.findall(r"^```python\n(.*?)^```", (ROOT / "README.md").read_text("utf-8"), re.DOTALL | re.MULTILINE)
    exec(compile(text, "README.md", "exec"), {})


def test_extras_exist_and_are_installed_from_the_sources() -> None:
    """No index has a package lagdsl: documents and messages install the folder, or the packages that are missing."""
    known = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    texts = [page.read_text(encoding="utf-8") for page in pages()]
    texts += [path.read_text(encoding="utf-8") for path in (ROOT / "lagdsl").rglob("*.py")]
    installed = [
        found for text in texts for found in re.findall(r"pip install ((?:--?[a-z-]+ )*)'?([\w.\[\],-]+)", text)
    ]
    assert [what for _, what in installed if what.startswith("lagdsl")] == []
    extras = {extra for _, what in installed for extra in re.findall(r"\w+", what) if what.startswith(".[")}
    assert extras
    assert extras <= set(known)


@pytest.mark.parametrize("page", LISTS)
def test_pages_name_all_components_of_their_packages(page: str) -> None:
    text = (ROOT / "docs" / "reference" / page).read_text(encoding="utf-8")
    short = {name.rpartition(".")[2] for name in class_names() if name.rpartition(".")[0] in LISTS[page]}
    assert sorted(name for name in short - IN_THE_GENERATED_LIST if not re.search(rf"`{name}\b", text)) == []


def test_listed_components_exist() -> None:
    """Names of the lists at the end of the page on networks, and of the tables of joints and bodies."""
    networks, mechanical = (
        (ROOT / "docs" / "reference" / name).read_text(encoding="utf-8")
        for name in ("networks.md", "mechanical_library.md")
    )
    lists = networks.partition("\n## All components")[2]
    tables = re.findall(r"^\| (`[^|]*) \|", mechanical, re.MULTILINE)
    named = set(re.findall(r"`([A-Z]\w+)`", "\n".join((lists, *tables))))
    assert len(named) > 50
    assert sorted(named - {name.rpartition(".")[2] for name in class_names()}) == []


def test_targets_of_make_exist() -> None:
    c = ROOT / "lagdsl/engines/runtime/c"
    makefiles = [ROOT / "Makefile", c / "Makefile", c / "example/Makefile"]
    texts = [path.read_text(encoding="utf-8") for path in makefiles if path.exists()]
    targets = {name for text in texts for name in re.findall(r"^([\w.-]+):", text, re.MULTILINE)}
    named = {
        found for page in pages() for text in code(page) for found in re.findall(r"^make ([a-z][a-z-]+)$", text.strip())
    }
    assert named
    assert sorted(named - targets) == []


def test_floors_of_the_architecture_are_the_packages() -> None:
    rows = re.findall(r"^\|([^|]*\|[^|]*)\|", (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8"), re.MULTILINE)
    named = {name for row in rows for name in re.findall(r"`(\w+)`", row)}
    wings = [path for path in (ROOT / "lagdsl").iterdir() if path.is_dir() and path.name[0] not in "_."]
    floors = {path.stem for wing in wings for path in wing.iterdir() if path.suffix in ("", ".py")}
    rooms = {
        p.name
        for folder in ("language/semantics", "engines/runtime/c/lag")
        for p in (ROOT / "lagdsl" / folder).iterdir()
        if p.is_dir()
    }
    assert sorted(({wing.name for wing in wings} | floors | rooms) - named - {"__pycache__", "__init__"}) == []


def test_codes_of_diagnostics_exist() -> None:
    named = {found for page in pages() for found in re.findall(r"\b[ENW]0\d{3}\b", page.read_text(encoding="utf-8"))}
    assert sorted(named - set(ROWS)) == []


@pytest.mark.parametrize("folder", [ROOT / "models", library_folder()], ids=["models", "library"])
def test_every_class_has_a_doc_string(folder: Path) -> None:
    """Read from the text: a class of a file begins in the first column."""
    heads = [
        (path.name, head)
        for path in sorted(folder.rglob("*.lag"))
        for head in re.findall(
            r"^(?:partial )?(?:model|joint|block|connector|package) .*", path.read_text("utf-8"), re.MULTILINE
        )
    ]
    assert len(heads) >= len(list(folder.rglob("*.lag")))
    assert [found for found in heads if not re.search(r' "[^"]+"', found[1])] == []


def directives(folder: str, pattern: str) -> list[str]:
    """Names that the pages of a folder of the reference take from the code."""
    texts = [page.read_text(encoding="utf-8") for page in sorted((ROOT / "docs" / "reference" / folder).glob("*.md"))]
    return sorted(name for text in texts for name in re.findall(pattern, text, re.MULTILINE))


def test_every_command_stands_on_one_page() -> None:
    assert directives("command_line", r"^   :prog: lag (\w+)$") == sorted(commands())
    modules = directives("command_line", r"^\.\. click:: lagdsl\.interfaces\.cli\.commands\.(\w+?)_?:command$")
    assert modules == sorted(commands())


def test_every_public_name_stands_on_one_page_with_a_doc_string() -> None:
    members = sorted(name for name in dir(lagdsl.Model) if not name.startswith("_"))
    assert directives("python", r"^\.\. auto(?:method|property):: lagdsl\.Model\.(\w+)$") == members
    assert [name for name in members if not getattr(lagdsl.Model, name).__doc__] == []
    own = directives("python", r"^\.\. auto(?:class|exception|function):: lagdsl\.(\w+)$")
    assert own == sorted(lagdsl.__all__)


def test_every_command_says_what_it_does() -> None:
    assert [name for name, command in commands().items() if not command.help] == []
    options = [(name, p) for name, command in commands().items() for p in command.params if isinstance(p, click.Option)]
    assert [(name, option.opts) for name, option in options if not option.help] == []
