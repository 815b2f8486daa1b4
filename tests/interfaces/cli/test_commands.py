"""fmt, flat, derive, build, explain, new, and the group itself."""

import inspect
import json
from collections.abc import Callable
from pathlib import Path

import click
import pytest
from click.testing import Result

from lagdsl.interfaces.cli.main import lag

Invoke = Callable[..., Result]


class TestGroup:
    def test_help_lists_every_command(self, invoke: Invoke) -> None:
        result = invoke("--help")
        assert result.exit_code == 0
        for name in ("check", "run", "derive", "build", "fmu", "flat", "fmt", "explain", "new"):
            assert name in result.stdout

    def test_every_command_has_help(self, invoke: Invoke) -> None:
        for name in ("check", "run", "derive", "build", "fmu", "flat", "fmt", "explain", "new"):
            result = invoke(name, "--help")
            assert result.exit_code == 0
            assert "Usage" in result.stdout

    def test_functions_of_commands_take_groups_of_options(self) -> None:
        """At most ten arguments: options that belong together are one record (`lagdsl.interfaces.cli.groups.group`)."""
        context = click.Context(lag)
        found = {name: lag.get_command(context, name) for name in lag.list_commands(context)}
        taken = {name: len(inspect.signature(made.callback).parameters) for name, made in found.items() if made}
        assert len(taken) == 20
        assert {name: count for name, count in taken.items() if count > 10} == {}

    def test_an_unknown_command_is_answered_with_the_nearest(self, invoke: Invoke) -> None:
        result = invoke("chekc", "x.lag")
        assert result.exit_code == 2
        assert "did you mean `check`?" in result.stderr
        assert invoke("quux").exit_code == 2

    def test_version(self, invoke: Invoke) -> None:
        assert invoke("--version").stdout.startswith("lag, version ")


class TestFmt:
    UGLY = "model M coordinate Length x;gravity=0;mass 1 kg at {x,0};end;\n"

    def test_in_place_once(self, invoke: Invoke, tmp_path: Path) -> None:
        path = tmp_path / "m.lag"
        path.write_text(self.UGLY)
        assert invoke("fmt", "--check", path).exit_code == 1
        assert path.read_text() == self.UGLY
        assert invoke("fmt", path).exit_code == 0
        formatted = path.read_text()
        assert "end M;" in formatted
        assert invoke("fmt", "--check", path).exit_code == 0
        assert invoke("fmt", path).exit_code == 0
        assert path.read_text() == formatted

    def test_diff(self, invoke: Invoke, tmp_path: Path) -> None:
        path = tmp_path / "m.lag"
        path.write_text(self.UGLY)
        result = invoke("fmt", "--diff", path)
        assert "+end M;" in result.stdout
        assert path.read_text() == self.UGLY

    def test_standard_input(self, invoke: Invoke) -> None:
        result = invoke("fmt", "-", stdin=self.UGLY)
        assert result.exit_code == 0
        assert "end M;" in result.stdout
        assert invoke("fmt", "-", "other.lag", stdin="").exit_code == 2

    def test_standard_input_that_is_no_text(self, invoke: Invoke) -> None:
        from click.testing import CliRunner

        from lagdsl.interfaces.cli.main import lag

        assert CliRunner().invoke(lag, ["fmt", "-"], input=b"\xff").exit_code == 2

    def test_a_text_with_errors_stays_as_it_is(self, invoke: Invoke, tmp_path: Path) -> None:
        path = tmp_path / "m.lag"
        path.write_text("model M coordinate Length x(;")
        result = invoke("fmt", path)
        assert result.exit_code == 1
        assert "error" in result.stderr
        assert path.read_text() == "model M coordinate Length x(;"

    def test_line_ends_become_those_of_unix(self, invoke: Invoke, pendulum: Path) -> None:
        pendulum.write_bytes(pendulum.read_bytes().replace(b"\n", b"\r\n"))
        assert invoke("fmt", pendulum).exit_code == 0
        assert b"\r" not in pendulum.read_bytes()


class TestFlat:
    def test_it_lists_the_model(self, invoke: Invoke, pendulum: Path, tmp_path: Path) -> None:
        result = invoke("flat", pendulum)
        assert result.exit_code == 0
        assert "theta" in result.stdout
        out = tmp_path / "flat.txt"
        assert invoke("flat", pendulum, "-o", out).exit_code == 0
        assert out.read_text() == result.stdout

    def test_errors(self, invoke: Invoke, broken: Path) -> None:
        result = invoke("flat", broken, "--format", "json")
        assert result.exit_code == 1
        assert json.loads(result.stderr)[0]["code"] == "E0201"


class TestDerive:
    @pytest.mark.parametrize(
        ("form", "sign"),
        [("text", "theta"), ("markdown", "#"), ("latex", "\\documentclass"), ("html", "<!DOCTYPE html>")],
    )
    def test_every_form(self, invoke: Invoke, pendulum: Path, form: str, sign: str) -> None:
        result = invoke("derive", pendulum, "--to", form)
        assert result.exit_code == 0, result.stderr
        assert sign in result.stdout or "θ" in result.stdout

    def test_errors(self, invoke: Invoke, broken: Path) -> None:
        assert invoke("derive", broken).exit_code == 1


class TestBuild:
    @pytest.mark.parametrize("target", ["numpy", "c"])
    def test_it_writes_the_sources_and_names_them(
        self, invoke: Invoke, pendulum: Path, tmp_path: Path, target: str
    ) -> None:
        folder = tmp_path / "deep" / "er"
        result = invoke("build", pendulum, "--target", target, "-o", folder)
        assert result.exit_code == 0, result.stderr
        written = sorted(str(p) for p in folder.rglob("*") if p.is_file())
        assert written == sorted(result.stdout.split())
        assert written

    def test_errors(self, invoke: Invoke, broken: Path, pendulum: Path, tmp_path: Path) -> None:
        assert invoke("build", broken, "--target", "c", "-o", tmp_path / "b").exit_code == 1
        assert not (tmp_path / "b").exists()
        assert invoke("build", pendulum, "--target", "c", "-o", pendulum).exit_code == 2
        assert invoke("build", pendulum, "--target", "fortran", "-o", tmp_path).exit_code == 2
        assert invoke("build", pendulum, "--target", "numpy", "--batch", "-o", tmp_path).exit_code == 2

    @pytest.mark.parametrize("target", ["numpy", "c"])
    def test_terms_and_points_by_name(self, invoke: Invoke, tmp_path: Path, target: str) -> None:
        model = tmp_path / "m.lag"
        model.write_text("""model M coordinate Length x; frame f = world.move({x, 0, 0}); point P = f.point({0, x, 0});
          mass 1 kg at P; end M;""")
        arguments = ("build", model, "--target", target, "-o", tmp_path / target, "--terms", "--frame", "f", "--point")
        assert invoke(*arguments, "P").exit_code == 0
        text = (tmp_path / target / ("M.py" if target == "numpy" else "M.c")).read_text()
        assert "equation_terms" in text and "kinematics" in text and "regressor" in text
        refused = invoke(*arguments, "Q")
        assert (refused.exit_code, "there are P" in refused.stderr) == (2, True)

    def test_functions_of_many_states_come_when_asked_for(self, invoke: Invoke, pendulum: Path, tmp_path: Path) -> None:
        plain = invoke("build", pendulum, "--target", "c", "-o", tmp_path / "plain").stdout
        batch = invoke("build", pendulum, "--target", "c", "--batch", "-o", tmp_path / "batch").stdout
        assert "Pendulum_states.c" in batch
        assert "Pendulum_states.c" not in plain


class TestExplain:
    def test_a_page(self, invoke: Invoke) -> None:
        result = invoke("explain", "e0401")
        assert result.exit_code == 0
        assert "E0401" in result.stdout

    def test_an_unknown_code(self, invoke: Invoke) -> None:
        result = invoke("explain", "W0401")
        assert result.exit_code == 2
        assert "E0401" in result.stderr

    def test_a_component_with_its_inherited_parameters(self, invoke: Invoke) -> None:
        page = invoke("explain", "DCMotor").stdout
        assert "| `J` | Inertia | kg.m2 | `0` | of the rotor |" in page
        assert "| `k` | ElectricalTorqueConstant | N.m/A |" in page

    @pytest.mark.parametrize(
        ("name", "said"),
        [
            ("DCMtor", "did you mean `DCMotor`?"),
            ("reacton", "did you mean `reaction`?"),
            ("xyzzy", "function, type or"),
        ],
    )
    def test_a_name_of_nothing(self, invoke: Invoke, name: str, said: str) -> None:
        result = invoke("explain", name)
        assert result.exit_code == 2
        assert said in result.stderr

    def test_classes_of_one_name_and_about_one_thing_are_listed(self, invoke: Invoke) -> None:
        named, about = invoke("explain", "Spring"), invoke("explain", "shafts")
        assert named.exit_code == about.exit_code == 0
        assert "- `Lag.Planar.Spring`: Linear spring between two points\n" in named.stdout
        assert "- `Lag.Translational.Spring`: " in named.stdout
        assert "- `Lag.Rotational.Clutch`: Dry friction between two shafts" in about.stdout

    @pytest.mark.parametrize(
        ("word", "parts"),
        [
            ("force", ["force F at P;", "A force vector.", "section Forces and torques"]),
            ("dissipation", ["Rayleigh function", "section Energies and masses"]),
            ("reaction", ["reaction(A).force", "reaction(C).force;", "section Results"]),
            ("contact", ["contact c: gap >= 0", "contact floor: h >= 0", "docs/reference/events.md"]),
            ("when", ["elsewhen", "reinit(der(h), -e*pre(der(h)));", "section Events"]),
            ("Angle", ["`Angle` is a Real in `rad`"]),
        ],
    )
    def test_a_word_of_the_language(self, invoke: Invoke, word: str, parts: list[str]) -> None:
        page = invoke("explain", word).stdout
        assert [part for part in parts if part not in page] == []


class TestNewFromAModel:
    @pytest.fixture(autouse=True)
    def elsewhere(self, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.chdir(tmp_path)

    def test_a_copy_under_its_own_name(self, invoke: Invoke, root: Path, tmp_path: Path) -> None:
        assert invoke("new", "--from", "dc_motor").exit_code == 0
        original = root / "models" / "library" / "dc_motor.lag"
        assert (tmp_path / "dc_motor.lag").read_text() == original.read_text()

    def test_a_copy_under_another_name(self, invoke: Invoke, tmp_path: Path) -> None:
        assert invoke("new", "mine", "--from", "four_bar").exit_code == 0
        text = (tmp_path / "mine.lag").read_text()
        assert text.startswith("model Mine ") and text.rstrip().endswith("end Mine;")
        assert invoke("check", "mine.lag").exit_code == 0

    def test_an_unknown_model(self, invoke: Invoke, tmp_path: Path) -> None:
        result = invoke("new", "--from", "four_bars")
        assert result.exit_code == 2
        assert "`four_bar`" in result.stderr
        assert not list(tmp_path.iterdir())

    def test_neither_name_nor_model(self, invoke: Invoke) -> None:
        assert invoke("new").exit_code == 2

    def test_the_list_names_every_model(self, invoke: Invoke, root: Path) -> None:
        listed = invoke("new", "--list").stdout
        names = {line.split()[0] for line in listed.splitlines()}
        files = (root / "models").rglob("*.lag")
        assert names == {path.relative_to(root / "models").with_suffix("").as_posix() for path in files}


class TestNew:
    def test_it_runs(self, invoke: Invoke, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.chdir(tmp_path)
        assert invoke("new", "my-first").exit_code == 0
        assert "model MyFirst " in (tmp_path / "my-first.lag").read_text()
        assert invoke("check", "my-first.lag").exit_code == 0
        assert invoke("fmt", "--check", "my-first.lag").exit_code == 0

    def test_a_name_with_a_space_can_be_pasted(
        self, invoke: Invoke, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.chdir(tmp_path)
        assert invoke("new", "my first").stdout.endswith("lag run 'my first.lag'\n")
        assert "model MyFirst " in (tmp_path / "my first.lag").read_text()

    def test_it_never_overwrites(self, invoke: Invoke, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.chdir(tmp_path)
        (tmp_path / "a.lag").write_text("mine")
        result = invoke("new", "a.lag")
        assert result.exit_code == 2
        assert "exists" in result.stderr
        assert (tmp_path / "a.lag").read_text() == "mine"

    @pytest.mark.parametrize("name", ["9lives", "nowhere/model", "°", "", ".lag"])
    def test_names_that_are_none(
        self, invoke: Invoke, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
    ) -> None:
        monkeypatch.chdir(tmp_path)
        result = invoke("new", "--", name)
        assert result.exit_code == 2
        assert not list(tmp_path.iterdir())
