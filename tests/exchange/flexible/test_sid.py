"""Standard Input Data of point masses: the imported body and the masses themselves have the same accelerations."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

import lagdsl
from flexible.point_masses import MASSES, direct_model, sid_text
from lagdsl.exchange.flexible.read import Reading, body_text
from lagdsl.foundation.diagnostics import Sink

RUN = """model Run
  import Frame;
  Lag.Spatial.FreeMotion base;
  Frame body;
  gravity = {1 m/s2, 2 m/s2, -3 m/s2};
  connect(world, base, body);
  output Length tip[3] = {body.frame_b.origin*world.x, body.frame_b.origin*world.y, body.frame_b.origin*world.z};
end Run;
"""


def imported(folder: Path, text: str, unit: str = "m", interfaces: tuple[str, ...] = ("1", "4")) -> lagdsl.Model:
    """The model that carries the body of a file."""
    (folder / "frame.SID_FEM").write_text(text)
    (folder / "Frame.lag").write_text(lagdsl.import_body(folder / "frame.SID_FEM", interfaces, length_unit=unit))
    (folder / "Run.lag").write_text(RUN)
    return lagdsl.compile(folder / "Run.lag")


def test_accelerations_are_those_of_the_masses(tmp_path: Path) -> None:
    """All terms up to the second order are exact where displacements are linear in the modes."""
    body, masses = imported(tmp_path, sid_text()), lagdsl.compile(direct_model())
    assert body.coordinates[6:] == ["body.eta[1]", "body.eta[2]"] and masses.coordinates[6:] == ["eta[1]", "eta[2]"]
    rng = np.random.default_rng(1)
    for _ in range(5):
        q, qd = rng.uniform(-0.5, 0.5, 8), rng.uniform(-1, 1, 8)
        expected = masses.forward_dynamics(0.0, q, qd)
        assert np.allclose(body.forward_dynamics(0.0, q, qd), expected, atol=1e-8 * np.abs(expected).max(), rtol=0)
        assert np.allclose(body.mass_matrix(0.0, q), masses.mass_matrix(0.0, q), atol=1e-8)


def test_a_file_in_other_units_is_the_same_body(tmp_path: Path) -> None:
    """With all masses per 1000 and all lengths times 1000 in N and s, mm are m."""
    text = sid_text()
    (tmp_path / "frame.SID_FEM").write_text(text)
    metres = lagdsl.import_body(tmp_path / "frame.SID_FEM", ["1", "4"], length_unit="m")
    millimetres = lagdsl.import_body(tmp_path / "frame.SID_FEM", ["1", "4"], length_unit="mm")
    assert f"m = {MASSES.sum():g}," in metres and f"m = {1000 * MASSES.sum():g}," in millimetres


def test_a_file_may_be_written_as_programs_do(tmp_path: Path) -> None:
    """As in the examples of PyMbs, github.com/sevoigt/pymbs, which FEMBS wrote: a comment in the first line, a title of
    the part, and the inertia as a column."""
    text = sid_text()
    plain = imported(tmp_path, text)
    head, matrix = text.split("\nJ\n")
    matrix, tail = matrix.split("end J\n")
    element = re.compile(r" m([01])\( (\d), (?:(\d), )?(\d)\) = (\S+)")
    rows = {("1", "1"): 1, ("2", "2"): 2, ("3", "3"): 3, ("1", "2"): 4, ("1", "3"): 5, ("2", "3"): 6}
    found = [each for each in element.findall(matrix) if (each[1], each[3]) in rows]
    lines = [" order = 1", " nrow = 6", " ncol = 1", " nq = 2", " nqn = 0", " structure = 3"]
    lines += [f" m{m}( {rows[i, j]}, {f'{k}, ' if k else ''}1) = {value}" for m, i, k, j, value in found]
    column = head.replace("new modal", "new modal = frame of masses").replace("5 2", "5 2 :No. nodes, No. modes:FEMBS")
    other = imported(tmp_path, "\n".join([column, "J", *lines, "end J", tail]))
    q, qd = np.linspace(-0.4, 0.5, 8), np.linspace(1, -1, 8)
    assert len(found) == 18 and np.array_equal(other.forward_dynamics(0, q, qd), plain.forward_dynamics(0, q, qd))


def test_a_negative_kinetic_energy_is_told(tmp_path: Path) -> None:
    """W1221: some published files have it, as an inertia that was typed in; what stands still does not need it."""
    path, text = tmp_path / "frame.SID_FEM", sid_text()
    head, tail = text.split("\nJ\n")
    path.write_text(head + "\nJ\n" + re.sub(r"m0\( 1, 2\) = \S+", "m0( 1, 2) = 9", tail, count=1))
    for name, code in ((path, ["W1221", "N1218"]), (tmp_path / "sound.SID_FEM", ["N1218"])):
        (tmp_path / "sound.SID_FEM").write_text(text)
        sink = Sink()
        assert body_text(name, Reading(interfaces=("1", "4"), length_unit="m"), sink) is not None
        assert [each.code for each in sink.diagnostics] == code


@pytest.mark.parametrize(
    ("old", "new", "code", "words"),
    [
        ("end part\n", "", "E1202", "end part"),
        (" mass = 2.0\n", " mass = two\n", "E1201", "two"),
        (" mass = 2.0\n", "", "E1203", "mass"),
        (" nelastq = 2\n", " nelastq = 900\n", "E1204", "200"),
        ("new node = 2\n", "new node = 1\n", "E1206", "occurs twice"),
        ("new node = 4\n", "new node = 9\n", "E1209", "`4`"),
        ("\nMe\n", "\nMx\n", "E1209", "Mx"),
        ("\nend frame\n", "\nend node\n", "E1201", "end frame"),
        ("\nOe\n order = 1\n nrow = 2", "\nOe\n order = 1\n nrow = 3", "E1201", "3 x 6"),
        (" m0( 1, 1) = ", " m0( 7, 1) = ", "E1201", "inside of"),
        (" m0( 1, 1) = ", " m0( 1, 1, 1) = ", "E1201", "m1(i, k, j)"),
        ("AP\n order = 0", "AP\n m7 = 2\n order = 0", "E1201", "an element of a matrix"),
        ("end part\n", "end part\nmore", "E1201", "the end of the file"),
        ("\npart\n", "\nport\n", "E1201", "a block"),
    ],
)
def test_a_faulty_file_is_told_at_its_place(tmp_path: Path, old: str, new: str, code: str, words: str) -> None:
    text = sid_text()
    assert old in text
    with pytest.raises(lagdsl.CompilationFailed) as caught:
        imported(tmp_path, text.replace(old, new, 1))
    assert code in str(caught.value) and words in str(caught.value)


def test_matrices_that_no_body_has_are_told(tmp_path: Path) -> None:
    for name, code in (("Ke", "E1213"), ("Me", "E1215")):
        head, tail = sid_text().split(f"\n{name}\n")
        with pytest.raises(lagdsl.CompilationFailed, match=code):
            imported(tmp_path, head + f"\n{name}\n" + tail.replace(" m0( 1, 1) = ", " m0( 1, 1) = -", 1))
    head, tail = sid_text().split("\nOe\n")
    with pytest.raises(lagdsl.CompilationFailed, match="E1210"):
        imported(tmp_path, head + "\nOe\n" + re.sub(r"m0\( 1, 1\) = \S+", "m0( 1, 1) = 9", tail, count=1))
