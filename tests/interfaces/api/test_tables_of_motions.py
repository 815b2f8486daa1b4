"""Motions as labelled data: the numbers, what was set, and the units, in every form."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import pytest

import lagdsl
from lagdsl.interfaces.api.motions import Motions

TEXT = """model Fall
  parameter Mass m(min = 0.1 kg) = 1 kg;
  input Force f = 0;
  coordinate Length h(start = 1 m);
  kinetic 1/2*m*der(h)^2;
  force f on h;
equation
  assert(h < 2 m, "too high");
end Fall;
"""
UNITS = {"time": "s", "h": "m", "der(h)": "m/s", "m": "kg", "h.start": "m", "f": "N"}


@pytest.fixture(scope="module")
def motions() -> Motions:
    """Run 2 fails where h = 0.5 m + t^2/2*8 m/s2 reaches 2 m."""
    model = lagdsl.compile(TEXT, engine="tape")
    return model.simulate_many(
        parameters={"m": [1.0, 2.0, 1.0]}, start={"h": 0.5}, inputs={"f": ["1 N", 2.0, 8.0]}, stop=1.0, interval=0.5
    )


def test_xarray(motions: Motions) -> None:
    pytest.importorskip("xarray")
    data = motions.to_xarray()
    assert dict(data.sizes) == {"run": 3, "time": 3} and data.attrs["model"] == "Fall"
    np.testing.assert_array_equal(data["h"].values, motions["h"])
    np.testing.assert_allclose(data["h"].sel(run=0, time=1.0), 0.5 + 0.5, rtol=1e-9)
    assert {name: data[name].attrs["units"] for name in UNITS} == UNITS
    np.testing.assert_array_equal(data["f"].values, [1.0, 2.0, 8.0])
    assert list(data["status"].values) == ["ok", "ok", "failed"] and "too high" in str(data["message"].values[2])
    np.testing.assert_array_equal(data["ended"].values, motions.ended)
    assert list(motions.ended[:2]) == [1.0, 1.0] and np.sqrt(3 / 8) <= motions.ended[2] < 1.0
    grouped = data["h"].isel(time=-1).groupby("m").mean()
    np.testing.assert_allclose(grouped.sel(m=2.0), 1.0, rtol=1e-9)


def test_pandas(motions: Motions) -> None:
    pytest.importorskip("pandas")
    frame = motions.to_dataframe()
    assert list(frame.columns) == ["run", "m", "f", "h.start", "time", "h", "der(h)"] and len(frame) == 9
    assert frame.attrs["model"] == "Fall" and frame.attrs["units"] == UNITS
    np.testing.assert_array_equal(frame["h"].to_numpy().reshape(3, 3), motions["h"])
    np.testing.assert_array_equal(frame["f"].to_numpy(), np.repeat([1.0, 2.0, 8.0], 3))
    np.testing.assert_array_equal(frame["time"].to_numpy(), np.tile([0.0, 0.5, 1.0], 3))


def test_parquet(motions: Motions, tmp_path: Path) -> None:
    pd, parquet = pytest.importorskip("pandas"), pytest.importorskip("pyarrow.parquet")
    motions.to_parquet(tmp_path / "runs.parquet")
    frame = pd.read_parquet(tmp_path / "runs.parquet")
    assert frame.attrs == {"model": "Fall", "units": UNITS}
    pd.testing.assert_frame_equal(frame, motions.to_dataframe())
    schema = parquet.read_schema(tmp_path / "runs.parquet")
    assert {name: schema.field(name).metadata[b"unit"].decode() for name in UNITS} == UNITS
    assert schema.field("run").metadata is None


def test_parquet_of_sweeps_and_single_motions(tmp_path: Path) -> None:
    pytest.importorskip("xarray")
    pd, parquet = pytest.importorskip("pandas"), pytest.importorskip("pyarrow.parquet")
    model = lagdsl.compile(TEXT, engine="tape")
    model.sweep({"m": [1.0, 2.0]}, inputs={"f": 1.0}, stop=1.0, interval=0.5, output=tmp_path / "sweep.parquet")
    units = {name: unit for name, unit in UNITS.items() if name != "h.start"} | {"ended": "s"}
    assert pd.read_parquet(tmp_path / "sweep.parquet").attrs == {"model": "Fall", "units": units}
    schema = parquet.read_schema(tmp_path / "sweep.parquet")
    assert schema.field("f").metadata[b"unit"] == b"N" and schema.field("status").metadata is None
    from lagdsl.motion.signals.table_io import write_table

    motion = model.simulate(stop=1.0, interval=0.5)
    write_table(motion, tmp_path / "one.parquet")
    frame = pd.read_parquet(tmp_path / "one.parquet")
    assert frame.attrs == motion.to_dataframe().attrs == {"model": "Fall", "units": {n: UNITS[n] for n in frame}}
    stored = parquet.read_schema(tmp_path / "one.parquet").metadata[b"PANDAS_ATTRS"]
    assert json.loads(stored)["units"]["der(h)"] == "m/s"


def test_tables_are_no_settings(motions: Motions) -> None:
    """A signal over time has no place in a column of numbers."""
    model = lagdsl.compile(TEXT, engine="tape")
    runs = model.simulate_many(inputs={"f": [1.0, ([0.0, 1.0], [0.0, 1.0])]}, stop=1.0, interval=0.5)
    assert runs.settings == {}
    shared = model.simulate_many(start={"h": [0.0, 1.0]}, inputs={"f": "2 N"}, stop=1.0, interval=0.5)
    assert {name: values.tolist() for name, values in shared.settings.items()} == {"h.start": [0, 1], "f": [2, 2]}


@pytest.mark.parametrize(("package", "call"), [("pandas", "to_dataframe"), ("xarray", "to_xarray")])
def test_a_package_that_is_missing(motions: Motions, monkeypatch: pytest.MonkeyPatch, package: str, call: str) -> None:
    monkeypatch.setattr("lagdsl.interfaces.api.motions.find_spec", lambda name: None if name == package else sys)
    with pytest.raises(ModuleNotFoundError, match=f"pip install {package}"):
        getattr(motions, call)()
