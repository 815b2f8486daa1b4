"""Tables in files."""

from __future__ import annotations

import csv
import os
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from simulate.hand import Pendulum, coordinate, flat_model

from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.signals.table_io import Table, csv_text, parse_inputs, read_inputs, write_events, write_table
from lagdsl.motion.signals.trajectory import Event, Trajectory
from lagdsl.motion.simulate.simulate import simulate


@pytest.fixture(scope="module")
def motion() -> Trajectory:
    engine = Pendulum(flat_model([coordinate("arm.q[1]", 1.0)]))
    return simulate(engine, engine.flat)


def test_csv_reads_back_to_the_same_floats(motion: Trajectory, tmp_path: Path) -> None:
    path = tmp_path / "out.csv"
    write_table(motion, path)
    rows = list(csv.reader(path.read_text().splitlines()))
    assert rows[0] == ["time", "arm.q[1]", "der(arm.q[1])"]
    table = np.array(rows[1:], dtype=float)
    assert np.array_equal(table, np.column_stack([c.values for c in motion.columns]))
    assert [p.name for p in tmp_path.iterdir()] == ["out.csv"]


def test_parquet_has_names_and_units(motion: Trajectory, tmp_path: Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    path = tmp_path / "out.parquet"
    write_table(motion, path)
    table = parquet.read_table(path)
    assert tuple(table.column_names) == motion.names
    assert np.array_equal(table["arm.q[1]"].to_numpy(), motion["arm.q[1]"])
    assert table.schema.field("time").metadata == {b"unit": b"s"}


def test_parquet_without_its_package(motion: Trajectory, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    with pytest.raises(CompilationFailed, match="needs the package"):
        write_table(motion, tmp_path / "out.parquet")
    assert list(tmp_path.iterdir()) == []


def test_a_form_that_is_none_is_refused(motion: Trajectory, tmp_path: Path) -> None:
    sink = Sink()
    write_table(motion, tmp_path / "out.xlsx", sink)
    assert [d.code for d in sink.diagnostics] == ["E0828"]
    write_table(motion, tmp_path / "OUT.CSV")
    assert [p.name for p in tmp_path.iterdir()] == ["OUT.CSV"]


def test_the_form_does_not_depend_on_capitals(motion: Trajectory, tmp_path: Path) -> None:
    pytest.importorskip("pyarrow")
    write_table(motion, tmp_path / "out.PARQUET")
    assert (tmp_path / "out.PARQUET").read_bytes().startswith(b"PAR1")


@pytest.mark.skipif(os.name != "posix", reason="links and permissions of Unix")
def test_a_link_stays_a_link_and_permissions_stay(motion: Trajectory, tmp_path: Path) -> None:
    real, link = tmp_path / "real.csv", tmp_path / "link.csv"
    real.touch(mode=0o640)
    real.chmod(0o640)
    link.symlink_to(real)
    write_table(motion, link)
    assert link.is_symlink()
    assert real.read_text() == csv_text(motion)
    assert real.stat().st_mode & 0o777 == 0o640


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device of Linux")
def test_a_device_that_is_full(motion: Trajectory) -> None:
    sink = Sink()
    write_table(motion, Path("/dev/full"), sink)
    assert [d.code for d in sink.diagnostics] == ["E0826"]


def test_unwritable_place(motion: Trajectory, tmp_path: Path) -> None:
    sink = Sink()
    write_table(motion, tmp_path / "missing" / "out.csv", sink)
    assert [d.code for d in sink.diagnostics] == ["E0826"]


def test_events_are_a_table_of_their_own(motion: Trajectory, tmp_path: Path) -> None:
    happened = (Event(time=0.1, name="h < 0.5 m", kind="true"), Event(time=1 / 3, name='say "a", b', kind="terminate"))
    sink = Sink()
    write_events(replace(motion, events=happened), tmp_path / "events.csv", sink)
    with (tmp_path / "events.csv").open(newline="") as file:
        assert list(csv.reader(file)) == [
            ["time", "kind", "name"],
            ["0.1", "true", "h < 0.5 m"],
            ["0.3333333333333333", "terminate", 'say "a", b'],
        ]
    write_events(motion, tmp_path / "missing" / "events.csv", sink)
    assert [d.code for d in sink.diagnostics] == ["E0826"]


def test_an_old_file_survives_a_failed_write(
    motion: Trajectory, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "out.csv"
    path.write_text("old")

    def full(trajectory: Trajectory, **_: object) -> str:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("lagdsl.motion.signals.table_io.csv_text", full)
    with pytest.raises(CompilationFailed, match="No space left"):
        write_table(motion, path)
    assert path.read_text() == "old" and len(list(tmp_path.iterdir())) == 1


def test_text_is_deterministic(motion: Trajectory) -> None:
    assert csv_text(motion) == csv_text(motion)


# ---- inputs ----------------------------------------------------------------------------------------------------------


def test_inputs_in_any_column_order(tmp_path: Path) -> None:
    path = tmp_path / "in.csv"
    path.write_bytes(b'\xef\xbb\xbfu, time ,"der(u)"\r\n1,0,3\r\n\r\n2,0.5,-4e-1\r\n')
    assert read_inputs(path, Sink()) == {"u": Table([0.0, 0.5], [1.0, 2.0]), "der(u)": Table([0.0, 0.5], [3.0, -0.4])}


@pytest.mark.parametrize(
    ("text", "code", "place"),
    [
        ("t,u\n0,1\n1,2\n", "E0821", (1, 1, 1, 4)),
        ("", "E0821", None),
        ("time\n0\n1\n", "E0821", (1, 1, 1, 5)),
        ("time,u\n0,1\n2,1\n1,1\n", "E0822", (4, 1, 4, 4)),
        ("time,u\n0,1\n1,one\n", "E0823", (3, 3, 3, 6)),
        ("time,u\n0,1\n1,\n", "E0823", (3, 2, 3, 3)),
        ("time,u\n0,1\n1,nan\n", "E0823", (3, 3, 3, 6)),
        ("time,u\n0,1\n1,2,3\n", "E0824", (3, 1, 3, 6)),
        ("time,u\n0,1\n", "E0827", None),
        ("time,u,u\n0,1,2\n1,1,2\n", "E0829", (1, 1, 1, 9)),
        ("time,u\n0,1\n1,1_000\n", "E0823", (3, 3, 3, 8)),
        ('time,u\n0,1\n"1","x"\n', "E0823", (3, 1, 3, 8)),
    ],
)
def test_faults_of_a_table_have_their_place(text: str, code: str, place: tuple[int, ...] | None) -> None:
    sink = Sink()
    assert parse_inputs(SourceFile("in.csv", text), sink) is None
    (error,) = sink.diagnostics
    assert error.code == code
    if place is None:
        assert error.labels == ()
    else:
        span = error.labels[0].span
        assert (*span.first, *span.last) == place


def test_a_quoted_name_may_hold_a_comma() -> None:
    table = parse_inputs(SourceFile("in.csv", 'time, "u[1,2]"\n0,1\n"1", "2"\n'), Sink())
    assert table == {"u[1,2]": Table([0.0, 1.0], [1.0, 2.0])}


@pytest.mark.skipif(os.name != "posix", reason="devices of Unix")
def test_a_device_without_end_is_read_no_further_than_allowed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("lagdsl.foundation.columns.csv_file._MOST_BYTES", 1_000_000)
    sink = Sink()
    assert read_inputs(Path("/dev/zero"), sink) is None
    assert "larger than 1 MB" in sink.diagnostics[0].message


def test_all_bad_cells_are_told_at_once() -> None:
    sink = Sink()
    parse_inputs(SourceFile("in.csv", "time,u\na,1\nb,2\n"), sink)
    assert [d.code for d in sink.diagnostics] == ["E0823", "E0823"]


def test_a_jump_is_two_equal_times() -> None:
    table = parse_inputs(SourceFile("in.csv", "time,u\n0,0\n1,0\n1,5\n2,5\n"), Sink())
    assert table == {"u": Table([0.0, 1.0, 1.0, 2.0], [0.0, 0.0, 5.0, 5.0])}


def test_unreadable_tables(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    latin = tmp_path / "latin.csv"
    latin.write_bytes(b"time,\xe9\n0,1\n")
    sink = Sink()
    assert read_inputs(latin, sink) is None
    assert read_inputs(tmp_path / "none.csv", sink) is None
    assert read_inputs(tmp_path, sink) is None
    monkeypatch.setattr("lagdsl.foundation.columns.csv_file._MOST_BYTES", 3)
    assert read_inputs(latin, sink) is None
    assert [d.code for d in sink.diagnostics] == ["E0820"] * 4
    assert "not UTF-8" in sink.diagnostics[0].message and "larger than" in sink.diagnostics[3].message
