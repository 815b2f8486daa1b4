"""Motions are read by the names of their columns, and what is no real number is refused."""

from pathlib import Path

import pytest
from click.testing import CliRunner

import lagdsl
from lagdsl.interfaces.cli.main import lag

TEXT = """model Spring
  parameter Stiffness k = 4 N/m;
  input Force f(min = 0 N) = 0 N;
  coordinate Length x(start = 1 m, min = 0 m);
  kinetic 1/2*(1 kg)*der(x)^2;
  potential 1/2*k*x^2;
  force f on x;
end Spring;
"""


def test_a_motion_iterates_over_names():
    motion = lagdsl.compile(TEXT).simulate(stop=0.1)
    assert list(motion) == list(motion.names) and {"time", "x", "der(x)"} <= set(motion)
    assert dict(motion)["x"][0] == 1.0
    assert "x" in motion and "y" not in motion


def test_complex_numbers_are_refused():
    model = lagdsl.compile(TEXT)
    assert model.batch(0.0, [1.0], [0.0])[0] == pytest.approx(-4.0, rel=1e-15)
    for call in (model.batch, model.forward_dynamics):
        with pytest.raises(ValueError, match="real numbers"):
            call(0.0, [1.0 + 1.0j], [0.0])


@pytest.fixture
def spring(tmp_path: Path) -> Path:
    path = tmp_path / "spring.lag"
    path.write_text(TEXT, encoding="utf-8")
    return path


def ran(*arguments: object):
    return CliRunner().invoke(lag, [str(each) for each in arguments])


def test_an_ending_names_a_form(spring: Path):
    assert ran("derive", spring, "--to", "md").stdout == ran("derive", spring, "--to", "markdown").stdout != ""


def test_starts_out_of_bounds_are_told(spring: Path):
    assert "W0328" in ran("run", spring, "--stop", "0.1", "--set", "x.start=-1 m").stderr
    assert "W0328" in ran("sweep", spring, "--stop", "0.1", "--set", "x.start=-1, 1 m").stderr
    assert "W0328" not in ran("run", spring, "--stop", "0.1", "--set", "x.start=2 m").stderr


def test_an_input_is_varied_by_its_own_option(spring: Path):
    """The hint of the other option is followed: it leads to a sweep."""
    told = ran("sweep", spring, "--set", "f=1, 2, 3 N")
    assert told.exit_code == 2 and "give it with --input 'f=...'" in told.stderr
    done = ran("sweep", spring, "--stop", "0.1", "--input", "f=-1, 2, 3 N")
    assert done.exit_code == 0 and "3 runs" in done.stdout and "W0328" in done.stderr


def test_a_sweep_without_a_scheduler_leaves_no_journal(spring: Path, tmp_path: Path):
    pytest.importorskip("distributed")
    output = tmp_path / "runs.csv"
    values = ("sweep", spring, "--stop", "0.1", "--set", "k=1, 2 N/m", "-o", output)
    assert ran(*values, "--scheduler", "tcp://127.0.0.1:9").exit_code == 2
    assert not output.with_name("runs.csv.partial").exists()
    assert ran(*values).exit_code == 0 and output.exists()


def test_constants_are_not_offered(spring: Path):
    spring.write_text(TEXT.replace("  input", "  constant Real two = 2;\n  input"), encoding="utf-8")
    assert "two" not in ran("run", spring, "--set", "q=1").stderr
    assert "constant" in ran("run", spring, "--set", "two=1").stderr
