"""A page is one file that asks for nothing, shows what it is given as data, and stays small."""

from __future__ import annotations

import hashlib
import os
import re
import subprocess
import sys
from base64 import b64encode
from pathlib import Path

import numpy as np
import pytest
from choice import chosen
from page.pages import MODELS, Elements, page_of

from lagdsl import compile as compile_model
from lagdsl.foundation.diagnostics import CompilationFailed

HOSTILE = """model Hostile "</script><script>alert(1)</script><img src=x onerror=alert(2)>"
  parameter Length l = 1 m "</style><b>--></b><!--";
  coordinate Angle theta(start = 1) "<svg onload=alert(3)>";
  point P = l*{sin(theta), -cos(theta)};
  gravity = -g_n*world.y;
  mass 1 kg at P;
  draw text("<i>&amp;</i>") at P;
  draw sphere(color = "red;} body{display:none") at P;
  annotation(experiment(StopTime = 1));
end Hostile;
"""
EVERY = sorted(path.relative_to(MODELS).with_suffix("").as_posix() for path in MODELS.rglob("*.lag"))
SOME = ("double_pendulum", "bouncing_ball")
BUDGETS = [("double_pendulum", 600e3), ("excavator", 1.6e6)]  # bytes


@pytest.mark.parametrize("name", chosen(EVERY, SOME))
def test_nothing_is_asked_for_and_the_policy_knows_the_one_script(name: str) -> None:
    try:
        text = page_of(name)
    except CompilationFailed:
        pytest.skip("the model has no motion without inputs")
    elements = Elements(text)
    assert [tag for tag, given in elements.tags if {"src", "href", "action", "data"} & set(given)] == []
    (script,) = elements.scripts
    policy = next(given["content"] for tag, given in elements.tags if tag == "meta" and "http-equiv" in given)
    assert policy is not None
    digest = b64encode(hashlib.sha256(script.encode()).digest()).decode()
    assert f"script-src 'sha256-{digest}' blob: 'wasm-unsafe-eval'" in policy
    assert policy.startswith("default-src 'none'")
    assert "'unsafe-eval'" not in policy.replace("'wasm-unsafe-eval'", "")
    assert "http" not in re.sub(r"http://www\.w3\.org/\S*|https://github\.com/\S*", "", _own_words(elements))


def _own_words(elements: Elements) -> str:
    """What the page says itself, without data."""
    return "".join(text for name, text in elements.texts.items() if name not in DATA)


DATA = ("head", "code", "worker", "wasm", "tape", "motion", "source", "derivation")


def test_texts_of_the_model_are_data() -> None:
    elements = Elements(page_of(HOSTILE))
    assert len(elements.scripts) == 1
    tags = [tag for tag, _ in elements.tags]
    assert not {"img", "b", "i"} & {*tags}
    assert tags.count("svg") == 1  # the drawing of the system
    assert elements.head["doc"].startswith("</script><script>alert(1)")
    assert not any(name.startswith("on") for _, given in elements.tags for name in given)


@pytest.mark.parametrize(("name", "budget"), chosen(BUDGETS, BUDGETS[:1]))
def test_a_page_is_small(name: str, budget: float) -> None:
    assert len(page_of(name).encode()) <= budget


def test_the_recorded_motion_is_that_of_the_model() -> None:
    elements = Elements(page_of("double_pendulum"))
    head = elements.head
    table = np.frombuffer(elements.inflated("motion"), dtype="<f4").reshape(-1, head["rows"])
    motion = compile_model(MODELS / "double_pendulum.lag").simulate(interval=(head["stop"] - head["start"]) / 600)
    for column, values in zip(head["columns"], table, strict=False):
        assert np.abs(values - motion[column["name"]]).max() <= 1e-6 * max(np.abs(values).max(), 1.0)
    x, y = _places(head, table, "mass 2")
    a, b = motion["a"], motion["b"]
    assert np.abs(x - (0.5 * np.sin(a) + 0.3 * np.sin(b))).max() < 1e-6
    assert np.abs(y + (0.5 * np.cos(a) + 0.3 * np.cos(b))).max() < 1e-6


def _places(head: dict, table: np.ndarray, name: str) -> tuple[np.ndarray, np.ndarray]:  # type: ignore[type-arg]
    shape = next(shape for shape in head["scene"]["shapes"] if shape["name"] == name)
    first = head["scene"]["first"] + shape["parts"][0]["numbers"]["at"]
    return table[first], table[first + 1]


def test_the_same_model_gives_the_same_page() -> None:
    code = (
        "import hashlib; from page.pages import page_of; print(hashlib.sha256(page_of('clutch').encode()).hexdigest())"
    )
    command = [sys.executable, "-c", code]
    paths = os.pathsep.join([str(Path(__file__).parents[1]), *sys.path])
    done = subprocess.run(
        command,
        env={**os.environ, "PYTHONHASHSEED": "1", "PYTHONPATH": paths},
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.strip() == hashlib.sha256(page_of("clutch").encode()).hexdigest()  # this process drew its seed


def test_a_run_that_ends_early_is_shown_as_far_as_it_went() -> None:
    failing = """model Falling
  coordinate Length x(start = 1 m);
  gravity = -g_n*world.y;
  mass 1 kg at {0, x};
equation
  assert(x > 0.5 m, "too low");
  annotation(experiment(StopTime = 2));
end Falling;
"""
    head = Elements(page_of(failing)).head
    assert "too low" in head["said"]
    assert (head["start"], head["stop"]) == (0.0, 2.0)


def test_models_and_motions_show_themselves(tmp_path: Path) -> None:
    model = compile_model(MODELS / "pendulum.lag")
    path = model.show(tmp_path / "model.html", browser=False, parameters={"l": 2.0}, start={"theta": 1.0})
    begun = {slider["name"]: slider["value"] for slider in Elements(path.read_text()).head["parameters"]}
    assert (begun["l"], begun["theta.start"]) == (2.0, 1.0)
    motion = model.simulate(stop=0.5, start={"theta": 0.5})
    text = motion.show(tmp_path / "motion.html", browser=False).read_text()
    assert Elements(text).head["stop"] == 0.5
    frame = motion._repr_html_()
    assert frame.startswith('<iframe title="Pendulum" sandbox="allow-scripts allow-downloads"')
    assert "<script" not in frame
    with pytest.raises(KeyError):
        model.show(tmp_path / "x.html", browser=False, parameters={"length": 2.0})


def test_sliders_of_inputs_begin_with_the_values_that_are_given(tmp_path: Path) -> None:
    model = compile_model("""model Pushed
  input Force u = 2 N;
  coordinate Length x;
  gravity = 0;
  mass 1 kg at {x, 0};
  force {u, 0} at {x, 0};
  annotation(experiment(StopTime = 1));
end Pushed;
""")
    for given, begun in (({}, 2.0), ({"u": 5.0}, 5.0), ({"u": lambda t: 3.0 + t}, 3.0)):
        path = model.show(tmp_path / "page.html", browser=False, inputs=given)
        (slider,) = Elements(path.read_text()).head["inputs"]
        assert (slider["name"], slider["value"]) == ("u", begun)


def test_numbers_beyond_single_precision_are_its_largest() -> None:
    """A warning of NumPy stood among the words of `lag show`."""
    text = """model M
      coordinate Length x(start = 1 m);
      kinetic 1/2*(1 kg)*der(x)^2;
      output Real y = 1e300*x/(1 m);
    end M;"""
    elements = Elements(page_of(text))
    table = np.frombuffer(elements.inflated("motion"), dtype="<f4").reshape(-1, elements.head["rows"])
    assert np.isfinite(table).all() and table.max() == np.finfo("<f4").max


def test_a_page_begins_with_what_a_person_varies() -> None:
    """Fixed starts rather than guesses, scalars rather than axes and mass centres of components; or the annotation."""
    head = Elements(page_of("four_bar")).head
    links = [f"{link}.{name}" for link in ("crank", "coupler", "rocker") for name in ("l", "m")]
    assert head["sliders"] == ["A.q.start", *links, "tau"] and head["curves"] == []
    text = """model M
  parameter Length l = 1 m; parameter Angle a0 = 20 deg; input Torque u;
  coordinate Angle theta(start = a0);
  gravity = -g_n*world.y; mass 1 kg at {l*sin(theta), -l*cos(theta)}; torque u on theta;
  output Length x = l*sin(theta);
  annotation(page(sliders = {theta, u}, curves = {x, der(theta)}));
end M;
"""
    head = Elements(page_of(text, 1.0)).head
    assert head["sliders"] == ["theta.start", "u"] and head["curves"] == ["x", "der(theta)"]
    assert "theta.start" in [each["name"] for each in head["parameters"]]  # though it follows from a parameter
    units = {each["name"]: each["display"]["unit"] for each in head["columns"]}
    assert (units["theta"], units["der(theta)"]) == ("deg", "rad/s")


def test_currents_are_in_amperes() -> None:
    head = Elements(page_of("library/rlc_circuit")).head
    units = {each["name"]: each["display"]["unit"] for each in head["columns"]}
    assert (units["C1.q"], units["der(C1.q)"]) == ("C", "A")


def test_each_character_of_the_text_has_its_ink() -> None:
    text = 'model M "𝒓"\n  coordinate Length x(start = 1 m);\n  kinetic 1/2*(1 kg)*der(x)^2;\nend M;\n'
    head = Elements(page_of(text, 1.0)).head
    assert len(head["inks"]) == len(text.encode("utf-16-le")) // 2
    assert head["inks"][:5] == "kkkkk" and set(head["inks"]) <= set("csnuklt ")
