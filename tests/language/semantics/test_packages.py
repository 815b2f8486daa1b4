"""Names from elsewhere: where they are looked for, which wins, and that files are read only when a name is needed."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from choice import together

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.resources import library_folder
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat.model import FlatModel
from lagdsl.language.semantics.classes import library
from lagdsl.language.semantics.flatten import flatten
from lagdsl.language.syntax import nodes
from lagdsl.language.syntax.parser import parse

BODY = """
  coordinate Angle q(start = 1);
  gravity = -g_n*world.y;
  mass 1 kg at (1 m)*{sin(q), -cos(q)};
"""


def write(folder: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


@pytest.fixture
def robots(tmp_path: Path) -> Path:
    """A package that is a folder, with a package and a class in it."""
    write(
        tmp_path,
        {
            "Robots/package.lag": 'package Robots "Robots"\n  constant Length reach = 2 m;\nend Robots;\n',
            "Robots/Grips/package.lag": "within Robots;\npackage Grips\n  constant Length jaw = reach/4;\nend Grips;\n",
            "Robots/Arm.lag": f"within Robots;\nmodel Arm\n  parameter Length l = reach + Grips.jaw;{BODY}"
            "  output Length o = l;\nend Arm;\n",
            "Robots/Faulty.lag": "within Robots;\nmodel Faulty\n  Mass m = ;\nend Faulty;\n",
        },
    )
    return tmp_path


def flattened(text: str, name: str = "<text>") -> tuple[FlatModel | None, list[str]]:
    sink = Sink()
    unit = parse(SourceFile(name, text), sink)
    assert unit is not None, sink.diagnostics
    flat = flatten(unit, sink)
    return flat, [diagnostic.code for diagnostic in sink.diagnostics]


def value(expression: str, before: str = "", name: str = "<text>", inside: str = "") -> float:
    """The value of a length in a model with imports before and inside it."""
    text = f"{before}\nmodel M\n  {inside}\n  structural parameter Length found = {expression};{BODY}\n"
    flat, codes = flattened(text + "  output Length o = found;\nend M;\n", name)
    assert flat is not None, codes
    assert codes == []
    return next(each.value for each in flat.parameters if each.name == "found")


@pytest.mark.parametrize(
    ("clause", "expression"),
    [
        ("import Robots;", "Robots.reach"),
        ("import Robots.reach;", "reach"),
        ("import R = Robots;", "R.Grips.jaw*4"),
        ("import Robots.*;", "reach"),
        ("import Robots.*;", "Grips.jaw*4"),
        ("import Robots.{Grips, reach};", "Grips.jaw*2 + reach/2"),
        ("import Robots.Grips.*;", "4*jaw"),
    ],
)
def test_forms_of_import(robots: Path, clause: str, expression: str) -> None:
    beside = str(robots / "model.lag")
    assert value(expression, clause, beside) == 2
    assert value(expression, name=beside, inside=clause) == 2


def test_a_text_has_no_folder(robots: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(robots)
    _, codes = flattened(f"import Robots;\nmodel M{BODY}end M;")
    assert codes == ["E0250"]


def test_folders_of_lagpath_come_in_their_order_before_the_library(
    robots: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    own = "package Lag\n  constant Length reach = 7 m;\nend Lag;\n"
    write(tmp_path, {"first/Robots.lag": "package Robots\n  constant Length reach = 5 m;\nend Robots;\n"})
    write(tmp_path, {"first/Lag.lag": own})
    monkeypatch.setenv("LAGPATH", os.pathsep.join([str(tmp_path / "first"), str(robots)]))
    assert value("Robots.reach") == 5  # installed packages need no import
    assert value("Lag.reach") == 7
    assert value("Robots.reach", "import Robots;", str(robots / "model.lag")) == 2
    monkeypatch.setenv("LAGPATH", str(robots))
    assert value("Robots.reach") == 2
    monkeypatch.delenv("LAGPATH")
    assert value("Lag.Constants.R_earth") == 6378100


def test_order_of_lookup(robots: Path) -> None:
    beside = str(robots / "model.lag")
    outer = "package P\n  constant Length reach = 3 m;\nend P;\npackage Q\n  constant Length jaw = 4 m;\nend Q;\n"
    assert value("reach", f"{outer}import Robots.*;", beside, "import P.reach;") == 3  # named before wildcards
    assert value("reach", f"{outer}import P.reach;", beside) == 3
    assert value("jaw", f"{outer}import Robots.Grips.*;", beside, "import Q.*;") == 4  # inner before outer
    sink_codes = flattened(f"{outer}model M\n  import P.*; parameter Length reach = 1; {BODY} end M;")[1]
    assert "E0203" not in sink_codes  # what the class declares goes before all imports


def test_two_names_of_one_class_are_not_ambiguous(robots: Path) -> None:
    second = "package Hall\n  model Arm = Robots.Arm{};\n  import Robots;\nend Hall;\n"
    text = f"import Robots.*;\nimport Hall.*;\nmodel M\n  Arm arm;{BODY}end M;"
    beside = str(robots / "model.lag")
    assert "E0203" not in flattened(second.replace("{}", "") + text, beside)[1]
    assert "E0203" in flattened(second.replace("{}", "(l = 1 m)") + text, beside)[1]


def test_imports_are_not_seen_from_outside(robots: Path) -> None:
    package = "package P\n  import Robots.reach;\n  constant Length a = reach;\nend P;\n"
    beside = str(robots / "model.lag")
    assert value("P.a", package, beside) == 2
    _, codes = flattened(f"{package}model M\n  import P.reach;{BODY}end M;", beside)
    assert codes == ["E0210"]


def test_packages_may_import_one_another(tmp_path: Path) -> None:
    write(
        tmp_path,
        {
            "A.lag": "package A\n  import B.*;\n  constant Length a = 1 m;\n  constant Length c = b;\nend A;\n",
            "B.lag": "package B\n  import A.*;\n  constant Length b = 2*a;\nend B;\n",
        },
    )
    assert value("A.c", "import A;", str(tmp_path / "m.lag")) == 2
    write(tmp_path, {"A.lag": "package A\n  import B.*;\n  constant Length a = b;\nend A;\n"})
    _, codes = flattened(f"import A;\nmodel M\n parameter Length l = A.a;{BODY}end M;", str(tmp_path / "m.lag"))
    assert codes == ["E0305"]


def test_files_are_read_when_a_name_is_needed(robots: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    read: list[str] = []
    monkeypatch.setattr(library, "_TREES", {})
    original = library.parse

    def parsed(file: SourceFile, sink: Sink) -> object:
        read.append(Path(file.name).stem)
        return original(file, sink)

    monkeypatch.setattr(library, "parse", parsed)
    beside = str(robots / "model.lag")
    assert value("reach", "import Robots.*;", beside) == 2
    assert read == ["package"]  # not Faulty, not Arm, not Grips
    assert value("reach", "import Robots.*;", beside) == 2
    assert read == ["package"]
    package = robots / "Robots" / "package.lag"
    package.write_text("package Robots\n  constant Length reach = 30 m;\nend Robots;\n")
    assert value("reach", "import Robots.*;", beside) == 30
    assert read == ["package", "package"]
    _, codes = flattened(f"import Robots.Faulty;\nmodel M\n  Faulty f;{BODY}end M;", beside)
    assert codes == ["E0108"] or codes[0].startswith("E01")


def test_a_file_of_a_package_is_a_model_too(robots: Path) -> None:
    path = robots / "Robots" / "Arm.lag"
    flat, codes = flattened(path.read_text(), str(path))
    assert flat is not None and codes == []
    assert next(each.value for each in flat.parameters if each.name == "l") == 2.5
    _, codes = flattened((robots / "Robots" / "package.lag").read_text(), str(robots / "Robots" / "package.lag"))
    assert codes == ["E0218"]


@together("path", sorted(library_folder().rglob("*.lag")))
def test_the_library_holds_what_its_files_say(path: Path) -> None:
    parts = path.relative_to(library_folder()).with_suffix("").parts
    name = parts[:-1] if path.name == "package.lag" else parts
    sink = Sink()
    found = library.item_of(sink, path, path.name, name, path.name == "package.lag", None)
    assert found is not None, sink.diagnostics
    assert sink.diagnostics == ()
    assert isinstance(found[1], nodes.ShortClass) or getattr(found[1], "doc", None), "it says what it is"


def test_constants_of_the_library() -> None:
    text = (library_folder() / "Lag" / "Constants" / "package.lag").read_text()
    names = [line.split("(")[0].split("=")[0].split()[-1] for line in text.splitlines() if "constant " in line]
    lines = "".join(f"  Real o_{name} = Lag.Constants.{name};\n" for name in names)
    flat, codes = flattened(f"model M{BODY}{lines}end M;")
    assert flat is not None, codes
    assert set(codes) == {"W0206"}
    assert len(names) > 20
