"""A component's parameter that is bound to one with a formula is another name for it on paper, too."""

from __future__ import annotations

from pathlib import Path

from click.testing import CliRunner

from lagdsl.interfaces.cli.main import lag

BOUND = """model Bound
  parameter Mass m = 2 kg;
  parameter Length R = 3 m;
  parameter Inertia I = m*R^2/2;
  Lag.Rotational.Rotor rotor(J = I);
  Lag.Rotational.Rotor twin(J = rotor.J + m*R^2);
end Bound;
"""


def test_a_parameter_bound_to_a_formula_is_written(tmp_path: Path) -> None:
    path = tmp_path / "bound.lag"
    path.write_text(BOUND)
    result = CliRunner().invoke(lag, ["derive", str(path), "--to", "text"])
    assert result.exit_code == 0, result.output
    assert "internal error" not in result.output
