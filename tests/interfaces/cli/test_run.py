"""`lag run`."""

import csv
import os
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from click.testing import Result

Invoke = Callable[..., Result]


def _read(path: Path) -> dict[str, np.ndarray]:
    with path.open(newline="") as file:
        header, *rows = csv.reader(file)
    return dict(zip(header, np.array(rows, dtype=float).T, strict=True))


def test_a_summary_without_an_output(invoke: Invoke, pendulum: Path) -> None:
    result = invoke("run", pendulum, "--stop", "1")
    assert result.exit_code == 0, result.stderr
    assert "Pendulum: 501 rows from 0 s to 1 s" in result.stdout
    assert "theta" in result.stdout
    assert "60" in result.stdout  # degrees, for people


def test_columns_are_written_in_full_precision(invoke: Invoke, pendulum: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.csv"
    result = invoke("run", pendulum, "--stop", "1", "--interval", "100 ms", "-o", out)
    assert result.exit_code == 0, result.stderr
    assert result.stdout == ""
    columns = _read(out)
    assert list(columns) == ["time", "theta", "der(theta)"]
    np.testing.assert_allclose(columns["time"], np.arange(11) / 10, rtol=1e-15)
    assert columns["theta"][0] == np.pi / 3
    assert sorted(p.name for p in tmp_path.iterdir()) == ["out.csv", "pendulum.lag"]


def test_parquet(invoke: Invoke, pendulum: Path, tmp_path: Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    out = tmp_path / "out.parquet"
    assert invoke("run", pendulum, "--stop", "1", "-o", out).exit_code == 0
    table = parquet.read_table(out)
    assert table.column_names == ["time", "theta", "der(theta)"]
    assert table.schema.field("theta").metadata == {b"unit": b"rad"}


def test_a_figure(invoke: Invoke, pendulum: Path, tmp_path: Path) -> None:
    out = tmp_path / "motion.png"
    result = invoke("run", pendulum, "--stop", "1", "--plot", out)
    assert result.exit_code == 0, result.stderr
    assert out.read_bytes().startswith(b"\x89PNG")


BALL = """model Ball
  coordinate Length h(start = 1 m);
  gravity = {0, -9.81 m/s2, 0};
  mass 1 kg at {0, h};
  contact floor: h >= 0 with restitution = 0.5;
equation
  when sample(0, 0.5 s) then
    assert(h < 2 m, "too high");
  end when;
  annotation(experiment(StopTime = 1));
end Ball;
"""


def test_what_happened_is_shown_and_written(invoke: Invoke, tmp_path: Path) -> None:
    model, out, happened = tmp_path / "ball.lag", tmp_path / "out.csv", tmp_path / "events.csv"
    model.write_text(BALL)
    result = invoke("run", model, "--events", happened)
    assert result.exit_code == 0, result.stderr
    impact = np.sqrt(2 / 9.81)
    table = result.stdout[result.stdout.index("events ") :].split("\n\n")[0].splitlines()
    assert table[0].split() == ["events", "number", "first", "last"]
    assert table[1].split() == ["sample(0,", "0.5", "s)", "tick", "3", "0", "s", "1", "s"]
    assert table[2].split() == ["floor", "impact", "2", f"{impact:.6g}", "s", f"{2 * impact:.6g}", "s"]
    header, *rows = csv.reader(happened.read_text().splitlines())
    assert header == ["time", "kind", "name"]
    assert [row[1:] for row in rows] == [
        ["tick", "sample(0, 0.5 s)"],
        ["impact", "floor"],
        ["tick", "sample(0, 0.5 s)"],
        ["impact", "floor"],
        ["tick", "sample(0, 0.5 s)"],
    ]
    assert float(rows[1][0]) == pytest.approx(impact, abs=1e-9)

    assert invoke("run", model, "-o", out, "--interval", "0.1").exit_code == 0
    columns = _read(out)
    before, after = np.flatnonzero(columns["time"] == float(rows[1][0]))
    assert after == before + 1
    assert columns["der(h)"][after] == pytest.approx(-0.5 * columns["der(h)"][before], rel=1e-12)


def test_what_happened_before_a_failure_is_written(invoke: Invoke, tmp_path: Path) -> None:
    model, happened = tmp_path / "ball.lag", tmp_path / "events.csv"
    contact, clause = (
        "contact floor: h >= 0 with restitution = 0.5;",
        "when h <= 0 then reinit(der(h), -0.5*der(h)); end when;",
    )
    model.write_text(BALL.replace(contact, "").replace("equation", f"equation {clause}"))
    result = invoke("run", model, "--stop", "3", "--events", happened)
    assert result.exit_code == 3
    assert "error[E0833]: events of `h <= 0` accumulate at t = 1.35" in result.stderr
    _, *rows = csv.reader(happened.read_text().splitlines())
    times = [float(time) for time, kind, _ in rows if kind == "reinit"]
    first = np.sqrt(2 / 9.81)
    exact = first + np.concatenate([[0.0], np.cumsum(2 * first * 0.5 ** np.arange(1, 12))])
    np.testing.assert_allclose(times[:12], exact, rtol=0, atol=1e-9)


def test_a_model_that_ends_itself_says_so(invoke: Invoke, tmp_path: Path) -> None:
    model = tmp_path / "ball.lag"
    model.write_text(BALL.replace("equation", 'equation when h < 0.5 m then terminate("half way"); end when;'))
    result = invoke("run", model)
    assert result.exit_code == 0 and result.stderr == ""
    end = np.sqrt(1 / 9.81)
    assert f"rows from 0 s to {end:g} s" in result.stdout
    assert ["half", "way", "terminate", "1"] in [line.split()[:4] for line in result.stdout.splitlines()]


def test_both_engines_and_both_derivations_give_the_same_motion(invoke: Invoke, pendulum: Path, tmp_path: Path) -> None:
    motions = []
    for options in ([], ["--engine", "c"], ["--derivation", "textbook"], ["--solver", "radau"]):
        out = tmp_path / "out.csv"
        result = invoke("run", pendulum, "--stop", "1", "--tolerance", "1e-10", *options, "-o", out)
        assert result.exit_code == 0, result.stderr
        motions.append(_read(out)["theta"])
    for motion in motions[1:]:
        np.testing.assert_allclose(motion, motions[0], atol=1e-7)


class TestSet:
    def test_quantity_literals(self, invoke: Invoke, pendulum: Path, tmp_path: Path) -> None:
        out = tmp_path / "out.csv"
        result = invoke("run", pendulum, "--stop", "1", "--set", "l=200 cm", "--set", "theta.start=0.1", "-o", out)
        assert result.exit_code == 0, result.stderr
        expected = 0.1 * np.cos(np.sqrt(9.81 / 2) * np.linspace(0, 1, 501))
        np.testing.assert_allclose(_read(out)["theta"], expected, atol=2e-4)

    def test_rates(self, invoke: Invoke, pendulum: Path, tmp_path: Path) -> None:
        out = tmp_path / "out.csv"
        result = invoke("run", pendulum, "--stop", "1", "--set", "der(theta).start=-60 deg/s", "-o", out)
        assert result.exit_code == 0, result.stderr
        assert _read(out)["der(theta)"][0] == pytest.approx(-np.pi / 3)

    def test_hertz_are_no_angular_velocity(self, invoke: Invoke, pendulum: Path) -> None:
        result = invoke("run", pendulum, "--set", "der(theta).start=2 Hz")
        assert result.exit_code == 2
        assert "Hz counts turns" in " ".join(result.stderr.split())

    def test_a_name_is_set_once(self, invoke: Invoke, pendulum: Path) -> None:
        result = invoke("run", pendulum, "--set", "l=1", "--set", "l=2")
        assert result.exit_code == 2
        assert "`l` is set twice" in result.stderr

    def test_structural_parameters_recompile(self, invoke: Invoke, root: Path, tmp_path: Path) -> None:
        out = tmp_path / "out.csv"
        chain = root / "models" / "chain.lag"
        result = invoke("run", chain, "--stop", "0.1", "--set", "N=3", "--set", "l=0.2", "-o", out)
        assert result.exit_code == 0, result.stderr
        assert list(_read(out))[:4] == ["time", "q[1]", "q[2]", "q[3]"]

    def test_booleans(self, invoke: Invoke, root: Path) -> None:
        car = root / "models" / "quarter_car.lag"
        assert invoke("run", car, "--stop", "0.1", "--set", "active=false").exit_code == 0
        assert invoke("run", car, "--stop", "0.1", "--set", "active=1").exit_code == 2

    def test_what_cannot_be_set_is_told_with_the_way_out(self, invoke: Invoke, root: Path) -> None:
        cart, crank = root / "models" / "cart_double_pendulum.lag", root / "models" / "slider_crank.lag"
        assert "with --input" in " ".join(invoke("run", cart, "--set", "u=1").stderr.split())
        assert "`speed` is computed from others" in " ".join(invoke("run", crank, "--set", "speed=1").stderr.split())

    def test_an_array_is_set_by_its_elements(self, invoke: Invoke, root: Path, tmp_path: Path) -> None:
        chain, out = root / "models" / "chain.lag", tmp_path / "out.csv"
        result = invoke("run", chain, "--stop", "0.1", "--set", "q[2].start=10 deg", "-o", out)
        assert result.exit_code == 0, result.stderr
        assert _read(out)["q[2]"][0] == pytest.approx(np.radians(10))
        result = invoke("run", chain, "--set", "q.start=10 deg")
        assert result.exit_code == 2
        assert "--set 'q[1].start=...'" in " ".join(result.stderr.split())

    @pytest.mark.parametrize(
        ("assignment", "words"),
        [
            ("mm=1", "what can be set: m, l, theta.start"),
            ("thta.start=1", "did you mean `theta.start`?"),
            ("theta=1", "theta.start"),
            ("m=1 m", "`m` is a mass [kg], this is a length"),
            ("theta.start=1 s", "a time"),
            ("m", "name=value"),
            ("m=", "name=value"),
            ("m=heavy", "expected a number"),
            ("m=1 kgg", "unknown unit `kgg`"),
            ("m=1 gram", "write `1 g`"),
            ("m=1e999", "this number is too large"),
            ("der(theta)=1", "set its start value with --set 'der(theta).start=...'"),
            ("m=" + "(" * 3000, "(((...: expected a number"),
            ("m=-1", "at least 0"),
            ("m=1; import os", "expected a number"),
        ],
    )
    def test_what_does_not_fit_is_status_2(self, invoke: Invoke, pendulum: Path, assignment: str, words: str) -> None:
        result = invoke("run", pendulum, "--set", assignment)
        assert result.exit_code == 2
        assert words in " ".join(result.stderr.replace("│", " ").split())


class TestInput:
    def test_a_table_drives_the_model(self, invoke: Invoke, root: Path, tmp_path: Path) -> None:
        table, out = tmp_path / "u.csv", tmp_path / "out.csv"
        table.write_text("time,u\n0,0\n1,2\n")
        cart = root / "models" / "cart_double_pendulum.lag"
        assert invoke("run", cart, "--stop", "1", "--input", table, "-o", out).exit_code == 0
        driven = _read(out)["x"][-1]
        assert invoke("run", cart, "--stop", "1", "-o", out).exit_code == 0
        assert driven > _read(out)["x"][-1] + 0.01

    @pytest.mark.parametrize(
        "content",
        [
            "",
            "u,time\n",
            "time\n0\n1\n",
            "time,u\n0,1\n",
            "time,u\n0,1\n1\n",
            "time,u\n0,x\n1,2\n",
            "time,u\n1,1\n0,1\n",
            "time,u\n0,nan\n1,1\n",
        ],
    )
    def test_a_bad_table_is_status_2(self, invoke: Invoke, root: Path, tmp_path: Path, content: str) -> None:
        table = tmp_path / "u.csv"
        table.write_text(content)
        result = invoke("run", root / "models" / "cart_double_pendulum.lag", "--input", table)
        assert result.exit_code == 2
        assert "u.csv" in result.stderr.replace("\n", "")

    def test_the_cell_at_fault_is_shown(self, invoke: Invoke, root: Path, tmp_path: Path) -> None:
        table = tmp_path / "u.csv"
        table.write_text("time,u\n0,0\n1,one\n")
        result = invoke("run", root / "models" / "cart_double_pendulum.lag", "--input", table)
        assert "u.csv:3:3" in result.stderr
        assert "`one` is not a number" in result.stderr

    def test_a_missing_table_is_status_2(self, invoke: Invoke, pendulum: Path, tmp_path: Path) -> None:
        assert invoke("run", pendulum, "--input", tmp_path / "none.csv").exit_code == 2

    def test_an_unknown_input_is_told(self, invoke: Invoke, pendulum: Path, tmp_path: Path) -> None:
        table = tmp_path / "u.csv"
        table.write_text("time,wind\n0,0\n100,0\n")
        result = invoke("run", pendulum, "--input", table)
        assert result.exit_code != 0
        assert "wind" in result.stderr


class TestFailures:
    def test_a_failing_run_keeps_its_rows_with_status_3(self, invoke: Invoke, failing: Path, tmp_path: Path) -> None:
        out = tmp_path / "out.csv"
        result = invoke("run", failing, "-o", out)
        assert result.exit_code == 3
        assert "on the floor" in result.stderr
        columns = _read(out)
        assert 0.0 < columns["time"][-1] < 0.3

    def test_errors_leave_no_file_behind(self, invoke: Invoke, broken: Path, tmp_path: Path) -> None:
        out = tmp_path / "out.csv"
        assert invoke("run", broken, "-o", out).exit_code == 1
        assert not out.exists()

    @pytest.mark.parametrize(
        "options",
        [["--stop", "-1"], ["--stop", "1 m"], ["--interval", "0"], ["--tolerance", "2"], ["--solver", "magic"]],
    )
    def test_options_that_make_no_sense_are_status_2(self, invoke: Invoke, pendulum: Path, options: list[str]) -> None:
        assert invoke("run", pendulum, *options).exit_code == 2

    def test_an_output_that_cannot_be_written_is_status_2(self, invoke: Invoke, pendulum: Path, tmp_path: Path) -> None:
        for path in (tmp_path, tmp_path / "nowhere" / "out.csv"):
            result = invoke("run", pendulum, "-o", path)
            assert result.exit_code == 2
            assert "cannot write" in result.stderr

    def test_forms_that_are_none_are_told_before_the_run(self, invoke: Invoke, pendulum: Path, tmp_path: Path) -> None:
        for options in (["-o", tmp_path / "out.xlsx"], ["--plot", tmp_path / "out.doc"]):
            result = invoke("run", pendulum, *options)
            assert result.exit_code == 2
            assert ".csv" in result.stderr or ".png" in result.stderr
        assert [p.name for p in tmp_path.iterdir()] == ["pendulum.lag"]

    @pytest.mark.parametrize("package", ["pyarrow", "matplotlib"])
    def test_a_missing_package_is_told_before_the_run(
        self, invoke: Invoke, pendulum: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, package: str
    ) -> None:
        monkeypatch.setitem(sys.modules, package, None)
        option = ["-o", tmp_path / "out.parquet"] if package == "pyarrow" else ["--plot", tmp_path / "out.png"]
        result = invoke("run", pendulum, *option)
        assert result.exit_code == 2
        assert f"pip install {package}" in " ".join(result.stderr.split())

    @pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device of Linux")
    def test_a_full_disk_is_status_2(self, invoke: Invoke, pendulum: Path) -> None:
        result = invoke("run", pendulum, "--stop", "0.1", "-o", "/dev/full")
        assert result.exit_code == 2
        assert "No space left" in result.stderr
        assert invoke("derive", pendulum, "-o", "/dev/full").exit_code == 2

    @pytest.mark.skipif(os.name != "posix", reason="devices of Unix")
    def test_a_device_is_written_directly(self, invoke: Invoke, pendulum: Path) -> None:
        assert invoke("run", pendulum, "--stop", "0.1", "-o", "/dev/null").exit_code == 0
        assert not Path("/dev/null").is_file()


@pytest.mark.parametrize("option", [("--column", "slip"), ("--plot", "x.png", "--show", "slip")])
@pytest.mark.parametrize(
    ("declared", "told"),
    [("Velocity slip = der(x);", "`slip` is a definition: write `output` before it"),
     ("input Force slip;", "`slip` is an input: an output with its value is a column"),
     ("parameter Force slip = 1 N;", "`slip` is a parameter: an output with its value is a column")],
)  # fmt: skip
def test_what_is_no_column_is_told_how_it_becomes_one(
    option: tuple[str, ...], declared: str, told: str, invoke: Invoke, tmp_path: Path
) -> None:
    force = "(1 N.s/m)*slip" if "Velocity" in declared else "slip"
    text = f"model M coordinate Length x; {declared} kinetic 1/2*(1 kg)*der(x)^2; force {force} on x; end M;"
    (tmp_path / "m.lag").write_text(text)
    place = [str(tmp_path / each) if each.endswith(".png") else each for each in option]
    result = invoke("run", tmp_path / "m.lag", *place)
    assert result.exit_code == 2
    assert told in " ".join(result.stderr.split())
