"""`column(file, name)`: numbers of a file with the unit of its header, beside the text and nowhere else."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import lagdsl
from lagdsl.foundation.diagnostics import CompilationFailed

FAN = """model Fan
  structural parameter AngularVelocity speed[:] = column("fan.csv", "speed");
  parameter Torque torque[size(speed, 1)] = column("fan.csv", "torque");
  coordinate Angle q(der(start = 100 rad/s));
  kinetic 1/2*(0.1 kg.m2)*der(q)^2;
  torque -table(der(q), speed, torque) on q;
end Fan;
"""
# 60 rpm = 2 pi rad/s: the torque is c*der(q) with c = 1/(2 pi) N.m.s.
DATA = "remark,speed [rpm],torque [kN.m]\nfirst,0,0\n,600,0.01\nlast one,1200,0.02\n"


@pytest.fixture
def fan(tmp_path: Path) -> Path:
    (tmp_path / "fan.lag").write_text(FAN, encoding="utf-8")
    (tmp_path / "fan.csv").write_text(DATA, encoding="utf-8")
    return tmp_path / "fan.lag"


def test_the_motion_of_a_table_in_a_file(fan: Path) -> None:
    """The speed falls as exp(-c*t/J)."""
    motion = lagdsl.compile(fan).simulate(stop=1.0, interval=0.25, tolerance=1e-10)
    expected = 100 * np.exp(-motion.time / (2 * np.pi) / 0.1)
    np.testing.assert_allclose(motion["der(q)"], expected, rtol=1e-7)


def test_units_and_bare_numbers(fan: Path) -> None:
    fan.with_name("fan.csv").write_text("time [ms],T [degC],n,a [deg]\n0,20,1,180\n500,30,2,90\n", encoding="utf-8")
    text = """model Columns
      structural parameter Time at[:] = column("fan.csv", "time");
      parameter Temperature T[2] = column("fan.csv", "T");
      parameter Length n[2] = column("fan.csv", "n");
      parameter Angle a[2] = column("fan.csv", "a");
      Lag.Blocks.TimeTable ramp(at = at, v = column("fan.csv", "n"));
      state Real x(start = 0);
      output Real y = ramp.y, w = at[2]/(1 s), warm = T[1]/(1 K), long = n[2]/(1 m), half = a[1];
    equation
      der(x) = 0;
    end Columns;"""
    fan.write_text(text, encoding="utf-8")
    motion = lagdsl.compile(fan).simulate(stop=0.5, interval=0.25)
    np.testing.assert_allclose(motion["y"], [1.0, 1.5, 2.0], rtol=1e-15)
    ends = [motion[name][0] for name in ("w", "warm", "long", "half")]
    np.testing.assert_allclose(ends, [0.5, 293.15, 2.0, np.pi], rtol=1e-15)


@pytest.mark.parametrize(
    ("change", "data", "code", "words"),
    [
        (("fan.csv", "fun.csv"), DATA, "E0820", "has no such file"),
        (("fan.csv", "../fan.csv"), DATA, "E0820", "lies outside of the folder"),
        (("fan.csv", "/etc/passwd"), DATA, "E0820", "begins at the root of the machine"),
        (('"speed"', '"spede"'), DATA, "E0821", "did you mean `speed`"),
        (('"speed"', "1"), DATA, "E0312", "the name of a column"),
        (("", ""), DATA.replace("torque", "speed"), "E0829", "two columns `speed`"),
        (("", ""), DATA.replace("rpm", "rpmm"), "E0878", "fan.csv:1:1"),
        (("", ""), DATA.replace("600", "6OO"), "E0823", "line 3, column `speed`"),
        (("", ""), DATA.replace("600", "true"), "E0823", "line 3, column `speed`"),
        (("", ""), DATA.replace(",600", ""), "E0824", "line 3"),
        (("", ""), DATA.splitlines()[0] + "\n", "E0827", "0 row"),
        (("", ""), "", "E0821", "the file is empty"),
        (("", ""), DATA.replace("rpm", "kg"), "E0407", "is a mass"),
        (("", ""), DATA.replace("1200", "500"), "E0362", "must increase"),
    ],
)
def test_faults(fan: Path, change: tuple[str, str], data: str, code: str, words: str) -> None:
    fan.write_text(FAN.replace(*change) if change[0] else FAN, encoding="utf-8")
    fan.with_name("fan.csv").write_text(data, encoding="utf-8")
    with pytest.raises(CompilationFailed) as raised:
        lagdsl.compile(fan)
    assert code in [each.code for each in raised.value.diagnostics]
    assert words in str(raised.value)
