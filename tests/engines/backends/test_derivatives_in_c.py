"""The program of docs/howto/derivatives_in_c.md compiles; its derivatives are those of the closed form of the ball."""

from __future__ import annotations

import re
import subprocess
from math import sqrt
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from made_modules import PLAIN, Made

from lagdsl.interfaces.cli.main import lag

PAGE = Path(__file__).parents[3] / "docs" / "howto" / "derivatives_in_c.md"
E, G, H = 0.8, 10.0, 1.0
# The program of the page, which prints derivatives by h.start just before and just after the impact, too.
BOTH_SIDES = """
       if (what->what == LAG_BEFORE || what->what == LAG_AFTER) {
           double d[COUNT * MOST];
           const size_t width = lag_sensitivities_width(run->motion.model);
           lag_run_sensitivities *own = *(lag_run_sensitivities **)context;
           if (lag_run_sensitivities_get(own, run, what->t, what->x, d) != LAG_OK) exit(1);
           printf("side %.17g %.17g\\n", d[2 * width], d[2 * width + 1]);
       }
"""
STRICT = ["-std=c11", "-O0", "-Wall", "-Wextra", "-Werror", "-pedantic"]


def _block(kind: str, name: str) -> str:
    (found,) = re.findall(rf"   ```{kind} file={re.escape(name)}\n(.*?)   ```", PAGE.read_text("utf-8"), re.DOTALL)
    return re.sub("^   ", "", found, flags=re.MULTILINE)


def _height(e: complex, g: complex, h: complex, t: float) -> tuple[complex, complex]:
    """Height and rate behind the first impact."""
    impact = (2 * h / g) ** 0.5
    rate = e * g * impact
    return rate * (t - impact) - g * (t - impact) ** 2 / 2, rate - g * (t - impact)


@pytest.fixture(scope="module")
def shown(tmp_path_factory: pytest.TempPathFactory, made: Made) -> list[list[str]]:
    folder = tmp_path_factory.mktemp("ball")
    (folder / "Ball.lag").write_text(_block("modelica", "Ball.lag"))
    program = _block("c", "derivatives.c").replace("    (void)run;\n", BOTH_SIDES)
    (folder / "derivatives.c").write_text(program)
    done = CliRunner().invoke(lag, ["build", str(folder / "Ball.lag"), "--target", "c", "-o", str(folder / "out")])
    assert done.exit_code == 0, done.output
    ready = made(folder / "out", f"CFLAGS={PLAIN}", "libBall.a")
    assert (ready.returncode, ready.stderr) == (0, "")
    subprocess.run(
        ["cc", *STRICT, "-Iout", "-o", "run", "derivatives.c", "out/libBall.a", "-lm"], cwd=folder, check=True
    )
    text = subprocess.run(["./run"], cwd=folder, check=True, capture_output=True, text=True).stdout
    return [line.split() for line in text.splitlines()]


def test_the_impact_moves_as_its_closed_form(shown: list[list[str]]) -> None:
    ((word, *numbers),) = (line for line in shown if line[0] == "impact")
    impact = sqrt(2 * H / G)
    assert word == "impact" and len(shown) == 6
    expected = [impact, 0.0, -impact / (2 * G), impact / (2 * H)]
    np.testing.assert_allclose([float(each) for each in numbers], expected, atol=1e-10)


def test_heights_behind_the_impact_move_as_their_closed_form(shown: list[list[str]]) -> None:
    step = 1e-30j  # complex steps: no digit is lost
    expected = {
        "e": _height(E + step, G, H, 1.0),
        "g": _height(E, G + step, H, 1.0),
        "h.start": _height(E, G, H + step, 1.0),
    }
    for name, *numbers in shown[-3:]:
        exact = [each.imag / step.imag for each in expected.pop(name)]
        np.testing.assert_allclose([float(each) for each in numbers], exact, atol=1e-10)
    assert not expected


def test_derivatives_are_those_on_both_sides_of_the_impact(shown: list[list[str]]) -> None:
    """Behind it dh/dh0 = -e g t1 dt1/dh0: the time at which the ball turns round moves."""
    impact = sqrt(2 * H / G)
    later = impact / (2 * H)
    sides = [[float(each) for each in line[1:]] for line in shown if line[0] == "side"]
    np.testing.assert_allclose(sides, [[1.0, 0.0], [-E * G * impact * later, (1 + E) * G * later]], atol=1e-10)
