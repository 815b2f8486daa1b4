"""The command line as its users call it."""

from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from lagdsl.interfaces.cli.main import lag

PENDULUM = """\
model Pendulum "Point mass on a massless rod"
  parameter Mass m = 1 kg;
  parameter Length l = 0.5 m;
  coordinate Angle theta(start = 60 deg) "from the downward vertical";
  gravity = {0, -9.81 m/s2};
  mass m at {l*sin(theta), -l*cos(theta)};
end Pendulum;
"""


@pytest.fixture
def invoke() -> Callable[..., Result]:
    """`lag` with arguments, in this process."""

    def run(*arguments: object, stdin: str | None = None) -> Result:
        return CliRunner().invoke(lag, [str(a) for a in arguments], input=stdin)

    return run


@pytest.fixture
def pendulum(tmp_path: Path) -> Path:
    path = tmp_path / "pendulum.lag"
    path.write_text(PENDULUM)
    return path


@pytest.fixture
def broken(tmp_path: Path) -> Path:
    path = tmp_path / "broken.lag"
    path.write_text(PENDULUM.replace("cos(theta)", "cos(thta)"))
    return path


@pytest.fixture
def failing(tmp_path: Path) -> Path:
    """Stops after a tenth of a second: its assertion fails."""
    path = tmp_path / "failing.lag"
    path.write_text(
        """model Falling
             coordinate Length h(start = 1 m);
             gravity = -g_n*world.y;
             mass 1 kg at {0, h};
           equation
             assert(h > 0.9 m, "on the floor");
           end Falling;
        """
    )
    return path
