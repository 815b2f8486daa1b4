"""`lag check`."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import Result

Invoke = Callable[..., Result]


def test_a_sound_model_gives_one_line(invoke: Invoke, pendulum: Path) -> None:
    result = invoke("check", pendulum)
    assert result.exit_code == 0
    assert result.stderr == ""
    assert result.stdout.startswith("Pendulum: 1 coordinate = 1 degree of freedom")
    assert len(result.stdout.splitlines()) == 1


def test_errors_go_to_standard_error_with_status_1(invoke: Invoke, broken: Path) -> None:
    result = invoke("check", broken)
    assert result.exit_code == 1
    assert result.stdout == ""
    assert "error[E0201]: unknown name `thta`" in result.stderr
    assert "did you mean `theta`?" in result.stderr


def test_json_holds_the_place(invoke: Invoke, broken: Path) -> None:
    result = invoke("check", broken, "--format", "json")
    assert result.exit_code == 1
    (diagnostic,) = json.loads(result.stdout)
    assert diagnostic["code"] == "E0201"
    assert (diagnostic["line"], diagnostic["column"], diagnostic["end_column"]) == (6, 35, 39)
    assert diagnostic["file"] == str(broken)


def test_json_of_a_sound_model_is_an_empty_array(invoke: Invoke, pendulum: Path) -> None:
    result = invoke("check", pendulum, "--format", "json")
    assert result.exit_code == 0
    assert json.loads(result.stdout) == []


def test_impossible_initial_values_are_found(invoke: Invoke, tmp_path: Path) -> None:
    path = tmp_path / "m.lag"
    path.write_text(
        """model M
             coordinate Length x(start = 1, fixed = true), y(start = 1, fixed = true);
             gravity = -g_n*world.y;
             mass 1 kg at {x, y};
             constraint rod: x^2 + y^2 = (1 m)^2;
           end M;
        """
    )
    result = invoke("check", path)
    assert result.exit_code == 1
    assert "E0801" in result.stderr or "E0802" in result.stderr


def test_one_of_several_models_is_chosen_by_name(invoke: Invoke, pendulum: Path) -> None:
    text = pendulum.read_text()
    pendulum.write_text(text + text.replace("Pendulum", "Other"))
    assert invoke("check", pendulum).stdout.startswith("Other:")
    assert invoke("check", pendulum, "-m", "Pendulum").stdout.startswith("Pendulum:")
    assert invoke("check", pendulum, "-m", "Pendulun").exit_code == 1


@pytest.mark.parametrize("content", [None, b"\xff\xfe\x00", b"model M\0 end M;"], ids=["missing", "not UTF-8", "NUL"])
def test_unreadable_files_are_status_2(invoke: Invoke, tmp_path: Path, content: bytes | None) -> None:
    path = tmp_path / "x.lag"
    if content is not None:
        path.write_bytes(content)
    result = invoke("check", path)
    assert result.exit_code == 2
    assert str(path) in result.stderr
    assert json.loads(invoke("check", path, "--format", "json").stdout)


def test_a_directory_is_status_2(invoke: Invoke, tmp_path: Path) -> None:
    assert invoke("check", tmp_path).exit_code == 2


@pytest.mark.parametrize("content", ["", "   \n", "// nothing\n"])
def test_a_text_without_a_model_is_an_error(invoke: Invoke, tmp_path: Path, content: str) -> None:
    path = tmp_path / "x.lag"
    path.write_text(content)
    assert invoke("check", path).exit_code == 1


def test_line_ends_and_a_byte_order_mark_do_not_matter(invoke: Invoke, pendulum: Path) -> None:
    pendulum.write_bytes(b"\xef\xbb\xbf" + pendulum.read_bytes().replace(b"\n", b"\r\n"))
    assert invoke("check", pendulum).exit_code == 0


def test_faults_of_the_other_models_of_a_file_are_told(invoke: Invoke, tmp_path: Path) -> None:
    sound = "model {}\n  coordinate Length x;\n  gravity = 0;\n  mass 1 kg at {{{}, 0}};\nend;\n"
    file = tmp_path / "two.lag"
    file.write_text(sound.format("A", "xx") + sound.format("B", "x"))
    result = invoke("check", str(file))
    assert result.exit_code == 1
    assert "error[E0201]: unknown name `xx`" in result.stderr
    assert invoke("check", "-m", "B", str(file)).exit_code == 0


def test_what_happens_at_instants_is_told_and_contacts_are_no_constraints(invoke: Invoke, tmp_path: Path) -> None:
    path = tmp_path / "ball.lag"
    path.write_text(
        """model Ball
             coordinate Length h(start = 1 m);
             discrete Integer n(start = 0);
             gravity = -g_n*world.y;
             mass 1 kg at {0, h};
             contact floor: h >= 0 with restitution = 0.5;
           equation
             when {h <= 0.2 m, sample(0, 5 ms)} then
               n = pre(n) + 1;
             end when;
           end Ball;
        """
    )
    result = invoke("check", path)
    line, events = result.stdout.splitlines()
    assert line == (
        "Ball: 1 coordinate = 1 degree of freedom (d = 3N - k = 3*1 - 2 = 1); "
        "0 constraints, 0 states, 0 inputs, 0 outputs"
    )
    assert events == (
        "events: 1 contact (floor); 1 discrete variable (n); 1 clock (sample(0, 5 ms)); "
        "1 when clause; 1 located relation"
    )
