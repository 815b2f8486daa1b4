"""Values by name on the command line: one grammar of ranges, units, arrays, and the same options everywhere."""

from __future__ import annotations

import csv
import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from choice import spread
from click.testing import Result

Invoke = Callable[..., Result]
MODELS = Path(__file__).parents[3] / "models"
SHORT = ("--stop", "0.2", "--interval", "0.1")

TWO = """model Two "Two angles and an input"
  parameter Mass m[2] = {1 kg, 2 kg};
  parameter Real gain = 1;
  coordinate Angle q[2](start = {10 deg, 20 deg});
  input Torque tau;
  potential (3 N.m/rad^2)*(q[1]^2 + q[2]^2)*gain;
  kinetic 1/2*(1 m2)*(m[1]*der(q[1])^2 + m[2]*der(q[2])^2);
  torque tau on q[1];
end Two;
"""
SAMPLED = """model Sampled
  coordinate Length x(start = 1 m);
  discrete Real held(start = 0);
  input Force f = 0 N;
  mass 1 kg at {x, 0};
  gravity = 0;
  force (1 N)*held + f on x;
equation
  when sample(0, 0.1 s) then
    held = -x/(1 m);
  end when;
end Sampled;
"""


@pytest.fixture
def two(tmp_path: Path) -> Path:
    path = tmp_path / "two.lag"
    path.write_text(TWO)
    return path


def header_of(path: Path) -> list[str]:
    return next(csv.reader(path.read_text().splitlines()))


def words(result: Result) -> str:
    return " ".join(result.stderr.replace("│", " ").split())


class TestRanges:
    @pytest.mark.parametrize(
        ("text", "rewritten"),
        spread(
            [
                ("k=0 N/m:3 N/m:31", "k=0:0.1:3 N/m"),
                ("k=0:3:31", "k=0:0.1:3 N/m"),
                ("k=1 N/m:2 N/m:4", "k=linspace(1, 2, 4) N/m"),
                ("k=10:20:3", "k=10:5:20 N/m"),
                ("k=-10:20:7", "k=-10:5:20 N/m"),
                ("k=0.1:3:30", "k=0.1:0.1:3 N/m"),
                ("x[1].start=0 cm:3 cm:4", "x[1].start=0:1:3 cm"),
            ],
            3,
        ),
    )
    def test_a_count_is_refused_with_the_text_to_write(self, invoke: Invoke, text: str, rewritten: str) -> None:
        result = invoke("modes", MODELS / "three_masses.lag", "--vary", text)
        assert result.exit_code == 2
        assert f"write '{rewritten}'" in words(result), words(result)
        assert invoke("modes", MODELS / "three_masses.lag", "--vary", rewritten).exit_code == 0

    def test_sweeps_refuse_it_alike(self, invoke: Invoke, pendulum: Path) -> None:
        result = invoke("sweep", pendulum, "--set", "l=0.1 m:1 m:10", *SHORT)
        assert result.exit_code == 2
        assert "write 'l=0.1:0.1:1 m'" in words(result)
        result = invoke("sweep", pendulum, "--set", "l=1:2:2", *SHORT)
        assert "1 run" in result.stdout and "N0872" in result.stderr and "do not meet 2" in words(result)

    def test_a_search_over_a_range_looks_at_all_its_values(self, invoke: Invoke) -> None:
        """Earlier versions looked at three values of 0:0.1:3, and found no threshold."""
        column = MODELS / "ziegler_column.lag"
        result = invoke("modes", column, "--set", "a.start=0", "--vary", "P=0:0.5:3 N")
        assert "eigenvalues for 7 values of P from 0 to 3 N" in result.stdout
        assert "threshold P = 2.08578643763 N" in result.stdout

    def test_numbers_without_unit_draw_a_note(self, invoke: Invoke, two: Path) -> None:
        result = invoke("modes", two, "--set", "q.start={0, 0} deg", "--vary", "gain=0:3:30")
        assert "note[N0873]" in result.stderr and "11 values" in words(result)
        assert "for 30 values from the first number to the second write `gain=linspace(0, 3, 30)`" in words(result)

    @pytest.mark.parametrize(
        ("text", "words_"),
        [
            ("k=1:2 m", "`k` is"),
            ("k=linspace(1, 2) N/m", "linspace(first, last, count)"),
            ("k=linspace(1, 2, x) N/m", "linspace(first, last, count)"),
            ("k=linspace(1, 1, 3) N/m", "are the same"),
            ("k=normal(1, 2) N/m", "expected a number"),
            ("k=1:2:3:4 N/m", "a range is first:step:last"),
            ("k=::", "a range is first:step:last"),
            ("k=5 N/m", "2 to 100000 different values"),
            ("k=0:1e-9:3 N/m", "2 to 100000 different values"),
            ("k=1:1:2 N/m, 3", "expected a number"),
            ("k=1 N/m:2 kN/m", "one unit"),
        ],
    )
    def test_what_is_no_range(self, invoke: Invoke, text: str, words_: str) -> None:
        result = invoke("modes", MODELS / "three_masses.lag", "--vary", text)
        assert result.exit_code == 2
        assert words_ in words(result), words(result)


class TestUnits:
    @pytest.mark.parametrize(
        ("assignment", "code", "note"),
        [
            (
                "theta.start=30",
                "warning[W0421]",
                "`theta.start=30` has no unit: it is 30 rad = 1719 deg help: write `30 deg` or `30 rad`",
            ),
            ("der(theta).start=2", "note[N0871]", "it is 2 rad/s = 114.6 deg/s"),
            ("l=70", "note[N0871]", "it is 70 m help: write `70 m`"),
            ("m=2e3", "note[N0871]", "it is 2000 kg help: write `2e3 kg`"),
        ],
    )
    def test_a_bare_number_draws_both_readings(
        self, invoke: Invoke, pendulum: Path, assignment: str, code: str, note: str
    ) -> None:
        result = invoke("run", pendulum, *SHORT, "--set", assignment)
        assert result.exit_code == 0
        assert code in result.stderr and note in words(result), words(result)

    @pytest.mark.parametrize("assignment", ["theta.start=0", "theta.start=30 deg", "m=2000 g"])
    def test_units_and_zeros_draw_none(self, invoke: Invoke, pendulum: Path, assignment: str) -> None:
        assert invoke("run", pendulum, *SHORT, "--set", assignment).stderr == ""

    def test_a_list_draws_one_note(self, invoke: Invoke, pendulum: Path) -> None:
        result = invoke("sweep", pendulum, *SHORT, "--set", "theta.start=0, 0.1, 0.2")
        assert result.stderr.count("N0871") == 1
        assert "in rad, up to 0.2 rad = 11.46 deg" in words(result)

    def test_draws_draw_it_too(self, invoke: Invoke, pendulum: Path) -> None:
        result = invoke("sweep", pendulum, *SHORT, "--set", "theta.start=normal(0, 5)", "--random", "2")
        assert "in rad, up to 5 rad = 286.5 deg help: write `normal(0, 5) deg`" in words(result)

    def test_sweeps_and_runs_show_the_same_units(self, invoke: Invoke, pendulum: Path) -> None:
        one = invoke("run", pendulum, *SHORT).stdout.splitlines()
        (row,) = (line.split() for line in one if line.startswith("theta"))
        many = invoke("sweep", pendulum, *SHORT, "--set", "m=1 kg").stdout.splitlines()
        (swept,) = (line.split() for line in many if line.startswith("theta"))
        assert (swept[-1], swept[1]) == (row[-1], row[2]) == ("deg", row[2])

    @pytest.mark.parametrize("command", [("run",), ("sweep", "--set", "m=1, 2 kg")])
    def test_headers_with_units(self, invoke: Invoke, pendulum: Path, tmp_path: Path, command: tuple[str, ...]) -> None:
        out = tmp_path / "out.csv"
        name, *options = command
        result = invoke(name, pendulum, *options, *SHORT, "--units", "-o", out)
        assert result.exit_code == 0, result.stderr
        header = header_of(out)
        assert {"time [s]", "theta [rad]", "der(theta) [rad/s]"} <= {*header}
        assert invoke(name, pendulum, *options, "--units").exit_code == 2

    def test_a_varied_angle_is_shown_in_degrees(self, invoke: Invoke, two: Path) -> None:
        result = invoke("modes", two, "--vary", "q[1].start=0:30:90 deg", "--input", "tau=0 N.m")
        assert "4 values of q[1] from 0 to 90 deg" in result.stdout
        assert "q[1] [deg]" in result.stdout

    def test_flat_and_check_tell_the_display_unit(self, invoke: Invoke, pendulum: Path) -> None:
        assert "Angle theta [rad, shown in deg], start = 1.047" in invoke("flat", pendulum).stdout
        shown = invoke("check", pendulum).stdout
        assert shown.rstrip().endswith("0 outputs; shown in deg: theta")


class TestArrays:
    def test_an_array_by_its_name(self, invoke: Invoke, two: Path, tmp_path: Path) -> None:
        out = tmp_path / "out.csv"
        result = invoke("run", two, *SHORT, "--set", "q.start={30, 40} deg", "--input", "tau=0 N.m", "-o", out)
        assert (result.exit_code, result.stderr) == (0, "")
        row = next(csv.DictReader(out.read_text().splitlines()))
        np.testing.assert_allclose([float(row["q[1]"]), float(row["q[2]"])], np.radians([30, 40]), rtol=1e-15)

    @pytest.mark.parametrize(
        ("assignment", "words_"),
        [
            ("q.start={1, 2, 3} deg", "`q.start` has 2 elements (q[1].start to q[2].start), not 3"),
            ("q.start=10 deg", "--set 'q.start={...}'"),
            ("gain={1, 2}", "`gain` is no array"),
            ("m={1 kg, 2 m}", "this is a length"),
        ],
    )
    def test_what_does_not_fit(self, invoke: Invoke, two: Path, assignment: str, words_: str) -> None:
        result = invoke("run", two, "--set", assignment)
        assert result.exit_code == 2
        assert words_ in words(result), words(result)


class TestInputs:
    """`--input` means the same in run, sweep, linearize, modes and trim."""

    @pytest.mark.parametrize(
        "command", spread([("run", *SHORT), ("sweep", *SHORT), ("linearize",), ("modes",), ("trim",)], 3)
    )
    def test_values_and_tables(self, invoke: Invoke, two: Path, tmp_path: Path, command: tuple[str, ...]) -> None:
        table = tmp_path / "tau.csv"
        table.write_text("time [ms],tau [kN.m]\n0,0.002\n1000,0.002\n")
        name, *options = command
        found = [invoke(name, two, *options, "--input", given) for given in ("tau=2 N.m", table)]
        assert [result.exit_code for result in found] == [0, 0], [result.stderr for result in found]
        assert found[0].stdout == found[1].stdout
        assert found[0].stdout != invoke(name, two, *options).stdout
        assert "N0875" not in found[0].stderr + found[1].stderr
        assert "note[N0875]: no value is given for the input `tau`: it is 0 N.m" in invoke(name, two, *options).stderr

    def test_a_table_is_read_at_the_time_of_the_state(self, invoke: Invoke, two: Path, tmp_path: Path) -> None:
        table = tmp_path / "tau.csv"
        table.write_text("time,tau\n0,0\n4,8\n")
        result = invoke("linearize", two, "--input", table, "--time", "1", "--to", "json")
        assert json.loads(result.stdout)["u"] == [2.0]
        assert invoke("linearize", two, "--input", table, "--time", "5").exit_code == 1

    @pytest.mark.parametrize("command", ["run", "linearize"])
    @pytest.mark.parametrize(
        ("header", "status", "code"),
        [("time,tau [kg]", 1, "E0878"), ("time,tau [Nn]", 2, "E0878"), ("time [m],tau", 2, "E0878")],
    )
    def test_units_that_do_not_fit(
        self, invoke: Invoke, two: Path, tmp_path: Path, command: str, header: str, status: int, code: str
    ) -> None:
        table = tmp_path / "tau.csv"
        table.write_text(f"{header}\n0,0\n100,0\n")
        result = invoke(command, two, "--input", table)
        assert (result.exit_code, code in result.stderr) == (status, True), result.stderr

    @pytest.mark.parametrize(
        ("kind", "unit"), [("TemperatureDifference", "degC"), ("AngularVelocity", "Hz"), ("AngularVelocity", "kHz")]
    )
    def test_units_of_points_and_of_turns(self, invoke: Invoke, tmp_path: Path, kind: str, unit: str) -> None:
        path, table = tmp_path / "given.lag", tmp_path / "given.csv"
        scale = "1 K.s" if kind == "TemperatureDifference" else "1 rad"
        path.write_text(f"model Given\n input {kind} u;\n state Real y;\nequation\n der(y) = u/({scale});\nend Given;")
        table.write_text(f"time,u [{unit}]\n0,5\n100,5\n")
        result = invoke("run", path, "--input", table, *SHORT)
        assert (result.exit_code, "E0878" in result.stderr) == (1, True), result.stderr

    def test_an_input_is_given_once(self, invoke: Invoke, two: Path, tmp_path: Path) -> None:
        table = tmp_path / "tau.csv"
        table.write_text("time,tau\n0,0\n100,0\n")
        result = invoke("run", two, "--input", "tau=1 N.m", "--input", table)
        assert (result.exit_code, "given twice" in words(result)) == (2, True)

    def test_a_stated_default_draws_no_note(self, invoke: Invoke, tmp_path: Path) -> None:
        path = tmp_path / "two.lag"
        path.write_text(TWO.replace("input Torque tau;", "input Torque tau = 0 N.m;"))
        assert invoke("run", path, *SHORT).stderr == ""


class TestOptions:
    @pytest.mark.parametrize("command", ["linearize", "modes"])
    def test_trim(self, invoke: Invoke, command: str) -> None:
        car = MODELS / "three_masses.lag"
        held = json.loads(invoke("trim", car, "--to", "json", "--hold", "x[1]", "--free", "f").stdout)
        found = json.loads(invoke(command, car, "--to", "json", "--trim", "--hold", "x[1]", "--free", "f").stdout)
        assert found["kind"] == "equilibrium"
        values = dict(zip(held["names"], held["values"], strict=True))
        np.testing.assert_allclose(found["u"], [values["f"]])
        result = invoke(command, car, "--hold", "x[1]")
        assert (result.exit_code, "give --trim" in words(result)) == (2, True)

    def test_columns_of_a_run(self, invoke: Invoke, pendulum: Path, two: Path, tmp_path: Path) -> None:
        out = tmp_path / "out.csv"
        assert invoke("run", pendulum, *SHORT, "--column", "theta", "-o", out).exit_code == 0
        assert header_of(out) == ["time", "theta"]
        assert "der(theta)" not in invoke("run", pendulum, *SHORT, "--column", "theta").stdout
        for command in ("run", "sweep"):
            assert "did you mean `theta`" in words(invoke(command, pendulum, *SHORT, "--column", "thet"))
        assert invoke("run", two, *SHORT, "--column", "q", "-o", out).exit_code == 0
        assert header_of(out) == ["time", "q[1]", "q[2]"]

    @pytest.mark.parametrize(
        ("ending", "begins"), [("html", "<!DOCTYPE html>"), ("tex", "\\documentclass"), ("md", "# "), ("txt", "")]
    )
    def test_the_ending_decides_the_form_of_a_derivation(
        self, invoke: Invoke, pendulum: Path, tmp_path: Path, ending: str, begins: str
    ) -> None:
        out = tmp_path / f"page.{ending}"
        assert invoke("derive", pendulum, "-o", out).exit_code == 0
        text = out.read_text()
        assert text.lower().startswith(begins.lower()), text[:80]
        form = {"html": "html", "tex": "latex", "md": "markdown", "txt": "text"}[ending]
        assert text == invoke("derive", pendulum, "--to", form).stdout

    @pytest.mark.parametrize(
        "arguments",
        [
            ("derive", "-o", "x.pdf"),
            ("derive", "--to", "latex", "-o", "x.html"),
            ("flat", "-o", "x.html"),
            ("run", "--events", "x.parquet"),
            ("run", "-o", "x.json"),
            ("modes", "--to", "csv", "-o", "x.json"),
            ("linearize", "-o", "x.html"),
            ("fmu", "-o", "x.zip"),
            ("run", "--plot", "x.csv"),
            ("sweep", "-o", "x.html"),
        ],
    )
    def test_an_ending_that_promises_something_else(
        self,
        invoke: Invoke,
        pendulum: Path,
        tmp_path: Path,
        monkeypatch: pytest.MonkeyPatch,
        arguments: tuple[str, ...],
    ) -> None:
        monkeypatch.chdir(tmp_path)
        command, *options = arguments
        result = invoke(command, pendulum, *options)
        assert result.exit_code == 2, result.stderr
        assert [path.name for path in tmp_path.iterdir()] == ["pendulum.lag"]

    def test_the_form_of_diagnostics_is_not_that_of_results(self, invoke: Invoke) -> None:
        car = MODELS / "three_masses.lag"
        new = invoke("trim", car, "--to", "json", "--input", "f=0 N")
        old = invoke("trim", car, "--format", "json", "--input", "f=0 N")
        assert json.loads(new.stdout) == json.loads(old.stdout)
        assert new.stderr == ""
        assert [each["code"] for each in json.loads(old.stderr)] == ["N0877"]


class TestSilence:
    def test_a_sampled_controller_is_held(self, invoke: Invoke, tmp_path: Path) -> None:
        path = tmp_path / "sampled.lag"
        path.write_text(SAMPLED)
        for command in ("linearize", "trim"):
            result = invoke(command, path, "--set", "x.start=0 m")
            assert "note[N0876]" in result.stderr, (command, result.stderr)
            assert "`held`, which `sample(0, 0.1 s)` sets" in words(result)
        modes = invoke("modes", path, "--set", "x.start=0 m")
        assert "N0876" not in modes.stderr
        assert "sampled loop" in modes.stdout
        assert "N0876" not in invoke("linearize", MODELS / "pendulum.lag").stderr

    def test_redundant_closures_are_told_by_check_alone(self, invoke: Invoke) -> None:
        """In the plane three of six equations hold by themselves; 3(n - 1) - 2j = 3*3 - 2*4 = 1."""
        four_bar = MODELS / "four_bar.lag"
        checked = invoke("check", four_bar)
        assert "note[N0701]" in checked.stderr
        assert "this is usual and harmless: in a planar loop" in checked.stderr
        assert "Gruebler in the plane: 3*3 moving links - 2*4 joints = 1" in checked.stdout
        assert "N0701" not in invoke("run", four_bar, "--stop", "0.01").stderr

    def test_structural_values_have_their_own_warnings(self, invoke: Invoke, tmp_path: Path) -> None:
        """Notes are about the model that runs, not about the one with other structural parameters."""
        path = tmp_path / "some.lag"
        path.write_text(
            """model Some
              structural parameter Integer n = 1;
              coordinate Length x(start = 1 m);
              input Force f[n];
              mass 1 kg at {x, 0};
              gravity = 0;
              force sum(f) on x;
            end Some;
            """
        )
        assert "`f[1]`: it is 0 N" in invoke("run", path, *SHORT).stderr
        assert "`f[1]`, `f[2]`, `f[3]`: they are zero" in invoke("run", path, *SHORT, "--set", "n=3").stderr


def test_check_flat_and_derive_take_values(invoke: Invoke, tmp_path: Path) -> None:
    path = tmp_path / "row.lag"
    path.write_text(
        "model Row structural parameter Integer n = 2; parameter Stiffness k = 1 N/m;"
        " coordinate Length x[n](each start = 1 m);"
        " for i in 1:n loop kinetic 1/2*(1 kg)*der(x[i])^2; potential 1/2*k*x[i]^2; end for; end Row;"
    )
    assert "Row: 3 coordinates" in invoke("check", path, "--set", "n=3").stdout
    flat = invoke("flat", path, "--set", "n=1", "--set", "k=2 N/cm", "--set", "x[1].start=30 cm").stdout
    assert "k [N/m] = 200" in flat and "start = 0.3" in flat and "x[2]" not in flat
    assert "x_2" not in invoke("derive", path, "--set", "n=1").stdout
    refused = invoke("check", path, "--set", "kk=2")
    assert refused.exit_code == 2 and "has no parameter `kk`" in refused.stderr
    assert invoke("check", path, "--set", "k=1 kg").exit_code == 2


def test_check_with_values_says_nothing_of_those_in_the_text(invoke: Invoke, tmp_path: Path) -> None:
    path = tmp_path / "divides.lag"
    path.write_text(
        "model D parameter Real k = 0; coordinate Length x(start = 1 m);"
        " kinetic 1/2*(1 kg)*der(x)^2; potential 1/2*(1 N/m)/k*x^2; end D;"
    )
    assert invoke("check", path).exit_code == 1
    assert invoke("check", path, "--set", "k=2").exit_code == 0
    assert "E0808" in invoke("check", path, "--set", "k=0").stderr


def test_names_that_other_structure_brings(invoke: Invoke, tmp_path: Path) -> None:
    path = tmp_path / "row.lag"
    path.write_text(
        "model Row\n  structural parameter Integer N = 2;\n  parameter Mass m[N] = fill(1 kg, N);\n"
        "  coordinate Length x[N];\n  for i in 1:N loop\n    kinetic 1/2*m[i]*der(x[i])^2;\n  end for;\n"
        "  output Mass total = sum(m);\nend Row;\n",
        encoding="utf-8",
    )
    for order in (["--set", "N=3", "--set", "m[3]=5 kg"], ["--set", "m[3]=5 kg", "--set", "N=3"]):
        result = invoke("run", path, *order, "--set", "x[3].start=2 m", "--stop", "1")
        assert result.exit_code == 0 and "total          7" in result.output
    for command in ("check", "run", "flat", "modes"):
        result = invoke(command, path, "--set", "N=1", "--set", "m[2]=5 kg")
        assert result.exit_code == 2 and "has no parameter `m[2]`; did you mean `m[1]`" in words(result)
    result = invoke("check", path, "--set", "N=30", "--set", "wrong=5 kg")
    assert "and 79 more" in words(result)


@pytest.mark.parametrize(
    ("given", "help_"),
    [
        (("--set", "gain=0:0.1:3"), "`lag sweep --set` takes ranges"),
        (("--set", "gain=1, 2"), "`lag sweep --set` takes ranges"),
        (("--input", "tau=1, 2 N.m"), "`lag sweep --input` takes ranges"),
    ],
)
def test_one_value_where_one_is_meant(invoke: Invoke, tmp_path: Path, given: tuple[str, str], help_: str) -> None:
    (tmp_path / "two.lag").write_text(TWO)
    found = invoke("run", tmp_path / "two.lag", *given, *SHORT)
    assert found.exit_code == 2 and "one value stands here, as in 2 " in words(found) and help_ in words(found)


@pytest.mark.parametrize("value", ["(" * 5000, "1+" * 3000 + "1 N.m", "1e" + "9" * 300])
def test_a_value_that_no_file_can_be_named_by(invoke: Invoke, two: Path, value: str) -> None:
    """The system refused to look for a file of that name, which was an internal error."""
    found = invoke("run", two, "--input", f"tau={value}", *SHORT)
    assert found.exit_code == 2 and "expected a number with or without a unit" in words(found)


@pytest.mark.parametrize(("unit", "meant"), [("cmm", "cm"), ("mmm", "mm"), ("kgs", "kg"), ("Nm", "N.m")])
def test_the_unit_that_is_meant(invoke: Invoke, two: Path, unit: str, meant: str) -> None:
    """`cmm` was told to mean `cm.m`, which nobody means."""
    found = invoke("run", two, "--set", f"m[1]=70 {unit}", *SHORT)
    assert found.exit_code == 2 and f"did you mean `{meant}`?" in words(found)
