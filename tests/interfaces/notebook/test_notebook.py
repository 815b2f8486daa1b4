"""Cells of models, forms of results and failures in a notebook; the notebooks of the documents give what they show."""

from __future__ import annotations

import importlib.util
import re
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

pytest.importorskip("IPython")
from IPython.core.interactiveshell import InteractiveShell
from IPython.utils.capture import capture_output

import lagdsl
from lagdsl.foundation.diagnostics import CompilationFailed
from lagdsl.interfaces.api import watch
from lagdsl.interfaces.notebook import bar
from lagdsl.interfaces.notebook.told import Told

ROOT = Path(__file__).parents[3]
PENDULUM = """%%lag pendulum
model Pendulum
  parameter Mass m = 1 kg;
  parameter Length l = 0.5 m;
  coordinate Angle theta(start = 60 deg);
  gravity = -g_n*world.y;
  mass m at {l*sin(theta), -l*cos(theta)};
end Pendulum;
"""


@pytest.fixture(scope="module")
def shell() -> Iterator[Any]:
    InteractiveShell.clear_instance()
    made = InteractiveShell.instance(colors="nocolor")
    made.display_formatter.active_types = ["text/plain", "text/html", "text/latex", "image/png"]
    made.run_cell("%load_ext lagdsl")
    made.run_cell(PENDULUM)
    yield made
    made.run_cell("%unload_ext lagdsl")
    InteractiveShell.clear_instance()


def shown(shell: Any, code: str, *, fails: bool = False) -> tuple[dict[str, str], str]:
    """Forms of what a cell shows, and its streams."""
    with capture_output() as captured:
        result = shell.run_cell(code)
    assert result.success is not fails, captured.stdout
    forms = dict(captured.outputs[-1].data) if captured.outputs else {}
    if result.result is not None:
        forms = shell.display_formatter.format(result.result)[0]
    return forms, captured.stdout + captured.stderr


def test_a_cell_names_its_model(shell: Any) -> None:
    forms, _ = shown(shell, PENDULUM)
    assert forms["text/plain"] == "pendulum: Pendulum, 1 coordinate, 2 parameters"
    assert isinstance(shell.user_ns["pendulum"], lagdsl.Model)


def test_a_mistake_is_drawn_and_names_nothing(shell: Any) -> None:
    shell.user_ns["broken"] = "an older model"
    forms, streams = shown(
        shell, PENDULUM.replace("%%lag pendulum", "%%lag broken").replace("1 kg", "1*kg"), fails=True
    )
    assert " --> broken:2:24" in forms["text/plain"]
    assert "^^ not declared" in forms["text/plain"]
    assert "a unit stands behind its number: `1 kg`" in forms["text/plain"]
    assert "Traceback" not in streams
    assert "broken" not in shell.user_ns


def test_the_text_of_a_model_is_no_html(shell: Any) -> None:
    cell = PENDULUM.replace("%%lag pendulum", "%%lag evil").replace("1 kg", "<script>alert(1)</script>")
    forms, _ = shown(shell, cell, fails=True)
    assert "<script>" not in forms["text/html"]
    assert "&lt;script&gt;" in forms["text/html"]


@pytest.mark.parametrize("line", ["%%lag", "%%lag 1pendulum", "%%lag a b c", "%%lag 'a'b.c", "%%lag 'a"])
def test_a_cell_without_a_name_says_how_it_is_written(shell: Any, line: str) -> None:
    _, streams = shown(shell, f"{line}\nmodel A end A;\n", fails=True)
    assert "%%lag NAME" in streams
    assert "Traceback" not in streams


def test_a_word_of_python_is_no_name(shell: Any) -> None:
    """The model was made, and no cell could reach it."""
    _, streams = shown(shell, PENDULUM.replace("%%lag pendulum", "%%lag import"), fails=True)
    assert "`import` is a word of Python" in streams and "import" not in shell.user_ns


def test_one_of_several_models_is_chosen(shell: Any) -> None:
    cell = PENDULUM.removeprefix("%%lag pendulum\n") + PENDULUM.removeprefix("%%lag pendulum\n").replace(
        "Pendulum", "B"
    )
    shown(shell, f"%%lag chosen Pendulum\n{cell}")
    assert shell.user_ns["chosen"].name == "Pendulum"


def test_compile_tells_without_a_traceback(shell: Any) -> None:
    forms, streams = shown(shell, "import lagdsl\nlagdsl.compile('model A Real x = ; end A;')", fails=True)
    assert "error[E0100]" in forms["text/plain"]
    assert "Traceback" not in streams


def test_results_show_themselves(shell: Any) -> None:
    assert shown(shell, "pendulum")[0]["text/html"].startswith("<iframe ")
    assert shown(shell, "pendulum.modes(q=[0.0])")[0]["text/html"].startswith("<iframe ")
    linear = shown(shell, "pendulum.linearize(q=[0.0])")[0]["text/html"]
    assert "<th>der(theta) [rad/s]</th>" in linear
    assert "<td>-19.6133</td>" in linear  # g/l
    varied = shown(shell, "pendulum.vary('l', '0.5:0.5:1 m', q=[3.141592653589793])")[0]["text/html"]
    assert "<th>l [m]</th>" in varied
    assert "<td>3.13156</td>" in varied  # sqrt(g/l) for 1 m, of the upright pendulum


def test_figures_are_drawn(shell: Any) -> None:
    """pyplot does not know them, so no backend of a notebook draws them."""
    drawn: Any = shown(shell, "pendulum.simulate(stop=0.1).plot(show='theta')")[0]["image/png"]
    assert drawn.startswith(b"\x89PNG")


def test_equations_are_those_of_the_textbook(shell: Any) -> None:
    """m l^2 theta'' = -m g l sin theta; the rows are compared as SymPy reads them."""
    latex = shown(shell, "pendulum.equations")[0]["text/latex"]
    assert re.sub(r"\s", "", latex) == (r"$\displaystyle\ddot{\theta}l^{2}m=-g_{n}lm\sin{\left(\theta\right)}$")


def test_constraints_have_rows_of_their_own() -> None:
    text = """model Bead
  coordinate Length x(start = 1 m), y;
  gravity = -g_n*world.y;
  mass 2 kg at {x, y};
  constraint x^2 + y^2 = 1 m2;
end Bead;"""
    latex = lagdsl.compile(text).equations._repr_latex_()
    assert latex is not None
    assert latex.count("&=") == 3
    assert latex.count(r"\\") == 2
    assert r"\lambda" in latex


def test_a_table_has_units() -> None:
    motion = lagdsl.compile(PENDULUM.partition("\n")[2]).simulate(stop=0.1)
    assert motion.to_dataframe().attrs == {
        "model": "Pendulum",
        "units": {"time": "s", "theta": "rad", "der(theta)": "rad/s"},
    }


def test_long_work_has_a_bar(shell: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bar, "_PATIENCE", 0.0)
    with capture_output() as captured:
        assert shell.run_cell("several = pendulum.sweep({'l': [0.4, 0.5, 0.6, 0.7]}, stop=0.1)").success
    drawn = [each.data["text/html"] for each in captured.outputs]
    assert '<progress value="0.250" max="1">25 %</progress>' in drawn[0]
    assert drawn[-1] == ""  # nothing is left of it


def test_work_of_less_than_a_second_has_none(shell: Any) -> None:
    with capture_output() as captured:
        assert shell.run_cell("short = pendulum.simulate(stop=0.1)").success
    assert captured.outputs == []


def test_who_watches_himself_is_told() -> None:
    parts: list[float] = []
    assert watch.watched(parts.append, "work") == parts.append


def test_colours_of_a_terminal_become_styles() -> None:
    with pytest.raises(CompilationFailed) as failure:
        lagdsl.compile("model A Real x = 1 < 2 < 3; end A;")
    told = Told(failure.value.diagnostics)
    html = told._repr_html_()
    assert html.count("<span") == html.count("</span>")
    assert "\x1b" not in html + repr(told)


# ---- the notebooks of the documents ----------------------------------------------------------------------------------


def _execute() -> ModuleType:
    spec = importlib.util.spec_from_file_location("execute", ROOT / "docs" / "notebooks" / "execute.py")
    assert spec is not None
    assert spec.loader is not None
    made = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(made)
    return made


EXECUTE = _execute()


def told(notebook: dict[str, Any]) -> list[str]:
    """Texts of the outputs of all cells, without sizes of figures."""
    found = []
    for cell in notebook["cells"]:
        for output in cell.get("outputs", []):
            text = "".join(output.get("data", {}).get("text/plain", output.get("text", [])))
            found.append(re.sub(r"\d\.\d+e[+-]\d+|<Figure .*>", "...", text))
    return found


def parts(texts: list[str]) -> tuple[list[list[str]], list[float]]:
    """Words, and the numbers between them: their last digits depend on the version of NumPy."""
    pieces = [re.split(r"(\d+\.\d+)", text) for text in texts]
    return [each[::2] for each in pieces], [float(number) for each in pieces for number in each[1::2]]


@pytest.mark.parametrize("name", EXECUTE.names())
def test_notebook(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every cell runs, and its texts are those that are stored; `python docs/notebooks/execute.py` writes them."""
    monkeypatch.chdir(ROOT / "docs" / "notebooks")
    stored = EXECUTE.read(name)
    assert stored["nbformat"] == 4
    words, numbers = parts(told(EXECUTE.executed(stored, pictures=False)))
    stored_words, stored_numbers = parts(told(stored))
    assert words == stored_words
    assert numbers == pytest.approx(stored_numbers, rel=1e-10)
