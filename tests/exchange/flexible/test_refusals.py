"""Files that cannot be imported: each is told with its code, its place and a way out; no file is a traceback."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from choice import examples
from click.testing import CliRunner
from hypothesis import given, settings
from hypothesis import strategies as st

from flexible.bar import FILES
from flexible.point_masses import sid_text
from lagdsl.exchange.flexible.read import Reading, body_text
from lagdsl.foundation.diagnostics import Sink
from lagdsl.interfaces.cli.main import lag

BLOCK = Reading(interfaces=("LEFT", "EDGE"), modes=1, length_unit="mm")
ENDINGS = (".inp", ".dof", ".sti", ".mas")


@pytest.fixture
def block(tmp_path: Path) -> Path:
    """A copy of the block, to damage."""
    for ending in ENDINGS:
        shutil.copy(FILES / f"block{ending}", tmp_path)
    return tmp_path / "block.inp"


def told(path: Path, reading: Reading = BLOCK) -> str:
    """Codes and words of the refusal."""
    sink = Sink()
    assert body_text(path, reading, sink) is None
    (found,) = [each for each in sink.diagnostics if each.code != "N1218"]
    assert found.help
    return f"{found.code} {found.message} {[label.span.first.line for label in found.labels]}"


@pytest.mark.parametrize(
    ("ending", "old", "new", "code", "words"),
    [
        (".inp", "4, 0, 100, 0", "4, 0, x, 0", "E1201", "`x`, not a finite number [7]"),
        (".inp", "1, 1, 2, 3, 4, 5, 6, 7, 8", "1, 1, 2, 3, 4,\n5, 6", "E1202", "element 1"),
        (".inp", "*ELEMENT, TYPE=C3D8, ELSET=BLOCK\n1, 1, 2, 3, 4, 5, 6, 7, 8\n", "", "E1203", "*ELEMENT"),
        (".inp", "8, 0, 100, 100", "7, 0, 100, 100", "E1206", "`7` occurs twice [11]"),
        (".inp", "*NSET, NSET=LEFT", "*NGEN\n1, 4\n*NSET, NSET=LEFT", "E1207", "*NGEN"),
        (".inp", "*NODE", "*NODDE", "E1222", "`*NODDE` is a keyword of neither"),
        (".inp", "*ELEMENT", "*ELEMNT", "E1222", "`*ELEMNT`"),
        (".inp", "*NSET, NSET=LEFT", "*MATERAIL, NAME=STEEL\n*NSET, NSET=LEFT", "E1222", "`*MATERAIL`"),
        (".inp", "TYPE=C3D8", "TYPE=B32", "E1208", "`B32`"),
        (".inp", "NSET=LEFT", "NSET=LEFTT", "E1209", "`LEFT`"),
        (".inp", "2, 100, 0, 0", "2, 100, 10, 0", "E1210", "a rigid motion takes forces"),
        (".inp", "2, 3, 6", "2, 3", "E1216", "no three nodes beside one line"),
        (".inp", "2, 3, 6", "4, 3, 6", "E1216", "shares node 4"),
        (".dof", "8.3", "8.4", "E1211", "node 8"),
        (".dof", "8.3", "9.3", "E1212", "node 8"),
        (".dof", "8.3", "8,3", "E1201", "node.direction"),
        (".sti", "1 1 ", "2 1 7\n1 1 ", "E1210", "not symmetric"),
        (".sti", "1 1 ", "1 99 ", "E1201", "one of 1 to 24"),
        (".sti", "1 1 ", "1 one ", "E1201", "`one`"),
        (".sti", "1 1 ", "1 ", "E1202", "3 numbers"),
    ],
)
def test_a_damaged_file_is_told(block: Path, ending: str, old: str, new: str, code: str, words: str) -> None:
    path = block.with_suffix(ending)
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new, 1))
    message = told(block)
    assert message.startswith(code) and words in message


def test_a_keyword_beside_the_body_is_left_out(block: Path) -> None:
    block.write_text(block.read_text() + "*PLASTIC\n2e8, 0\n")
    assert body_text(block, BLOCK, Sink()) is not None


def test_what_is_missing_is_told(block: Path, tmp_path: Path) -> None:
    assert told(tmp_path / "other.inp").startswith("E1200")
    assert told(block, Reading(interfaces=("LEFT", "EDGE"))).startswith("E1217")
    assert "E1219" in told(block, Reading(interfaces=("LEFT",), length_unit="mm"))
    assert told(block, Reading(interfaces=("LEFT", "EDGE"), length_unit="mm", modes=99)).startswith("E1214")
    assert told(block, Reading(interfaces=("LEFT", "EDGE"), length_unit="mm", matrices=tmp_path / "no")).startswith(
        "E1205"
    )
    block.with_suffix(".sti").unlink()
    assert "`block.sti`" in told(block)


def test_a_body_without_stiffness_or_mass_is_told(block: Path) -> None:
    for ending, code in ((".sti", "E1213"), (".mas", "E1215")):
        path = block.with_suffix(ending)
        kept = path.read_text()
        path.write_text("1 1 0\n")
        assert told(block).startswith(code)
        path.write_text(kept)
    block.with_suffix(".mas").write_text("1 1 1\n5 5 1\n")
    assert told(block).startswith("E1215")


def test_bounds_are_told(block: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("lagdsl.exchange.flexible.files.MAX_BYTES", 100)
    assert told(block).startswith("E1204")


def test_numbers_beyond_floats_are_told(tmp_path: Path) -> None:
    path = tmp_path / "frame.SID_FEM"
    path.write_text(sid_text().replace(" mass = 2.0\n", " mass = 1D-300\n"))
    assert told(path, Reading(interfaces=("1", "2"), length_unit="m")).startswith("E1220")


def test_a_deck_without_a_material_has_no_stiffening(block: Path) -> None:
    """A note tells it."""
    text = block.read_text()
    block.write_text(text.replace("*ELASTIC\n210000, 0.3\n", ""))
    sink = Sink()
    written = body_text(block, BLOCK, sink)
    assert [each.code for each in sink.diagnostics] == ["N1218"] and written is not None and "S2" not in written


def test_abaqus_matrices_are_those_of_calculix(block: Path, tmp_path: Path) -> None:
    """Lines of `node, direction, node, direction, value`, the lower triangle."""
    expected = body_text(block, BLOCK, Sink())
    rows = block.with_suffix(".dof").read_text().split()
    for ending, name in ((".sti", "STIF2"), (".mas", "MASS2")):
        lines = []
        for line in block.with_suffix(ending).read_text().splitlines():
            i, j, value = line.split()
            ends = [rows[int(k) - 1].replace(".", ",") for k in (j, i)]
            lines.append(f"{ends[0]}, {ends[1]}, {value}")
        (tmp_path / f"block_{name}.mtx").write_text("\n".join(lines) + "\n")
        block.with_suffix(ending).unlink()
    block.with_suffix(".dof").unlink()
    found = body_text(block, BLOCK, Sink())
    assert expected is not None and found is not None and expected.split("\nmodel ")[1] == found.split("\nmodel ")[1]
    shutil.copy(tmp_path / "block_STIF2.mtx", tmp_path / "block_STIF3.mtx")
    assert "block_STIF3" in told(block)


def test_more_interfaces_have_frames_of_their_names(block: Path) -> None:
    text = block.read_text().replace(
        "*NSET, NSET=EDGE\n2, 3, 6", "*NSET, NSET=EDGE\n2, 3, 6\n*NSET, NSET=LEFT 2\n1, 4, 5"
    )
    block.write_text(text.replace("1, 4, 5, 8\n", "1, 4\n").replace("\n1, 4\n", "\n1, 5, 8\n", 1))
    assert told(block, Reading(interfaces=("LEFT", "EDGE", "LEFT 2"), length_unit="mm")).startswith("E1216")


def test_options_are_of_one_kind_of_file(block: Path) -> None:
    done = CliRunner().invoke(lag, ["import", str(block), "--floating"])
    assert done.exit_code == 2 and "--floating is for a robot" in done.stderr
    done = CliRunner().invoke(lag, ["import", "robot.urdf", "--interface", "LEFT"])
    assert done.exit_code == 2 and "--interface is for a flexible body" in done.stderr
    arguments = [
        "import",
        str(block),
        "--interface",
        "LEFT",
        "--interface",
        "EDGE",
        "--length-unit",
        "mm",
        "--modes",
        "1",
    ]
    done = CliRunner().invoke(lag, [*arguments, "-o", str(block.with_name("Cube.lag"))])
    assert done.exit_code == 0, done.output
    assert "model Cube " in block.with_name("Cube.lag").read_text()


def damaged(text: str, cuts: list[tuple[int, int, str]]) -> str:
    for start, length, new in cuts:
        place = start % (len(text) + 1)
        text = text[:place] + new + text[place + length :]
    return text


CUTS = st.lists(
    st.tuples(
        st.integers(0, 20_000),
        st.integers(0, 40),
        st.sampled_from(["", "0", "-1", "1e308", "nan", "*", "\n", ",", "9" * 30, "²", "x"]),
    ),
    min_size=1,
    max_size=4,
)


@given(st.sampled_from(ENDINGS), CUTS)
@settings(max_examples=examples(300), deadline=None)
def test_no_damage_of_a_deck_is_a_traceback(
    tmp_path_factory: pytest.TempPathFactory, ending: str, cuts: list[tuple[int, int, str]]
) -> None:
    folder = tmp_path_factory.mktemp("deck", numbered=True)
    for each in ENDINGS:
        text = (FILES / f"block{each}").read_text()
        (folder / f"block{each}").write_text(damaged(text, cuts) if each == ending else text)
    sink = Sink()
    assert (body_text(folder / "block.inp", BLOCK, sink) is None) == sink.has_errors


@given(CUTS)
@settings(max_examples=examples(300), deadline=None)
def test_no_damage_of_standard_input_data_is_a_traceback(
    tmp_path_factory: pytest.TempPathFactory, cuts: list[tuple[int, int, str]]
) -> None:
    path = tmp_path_factory.mktemp("sid", numbered=True) / "frame.SID_FEM"
    path.write_text(damaged(sid_text(), cuts))
    sink = Sink()
    assert (body_text(path, Reading(interfaces=("1", "4"), length_unit="m"), sink) is None) == sink.has_errors
