"""Pages with several motions: rows of a file, runs of a sweep, modes as moving shapes."""

from __future__ import annotations

from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from choice import chosen
from page.pages import MODELS, Elements, page_of

from lagdsl import compile as compile_model
from lagdsl.documents.page.modes import LEVELS, modes_page
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.interfaces.api.model import Model
from lagdsl.motion.signals.table_io import write_table

CIRCLE = """model Circle
  coordinate Length x(start = 0), y(start = -0.5 m);
  gravity = -g_n*world.y;
  mass 1 kg at {x, y};
  constraint x^2 + y^2 = (0.5 m)^2;
end Circle;
"""


@cache
def model(name: str) -> Model:
    return compile_model(MODELS / f"{name}.lag")


def tables(elements: Elements) -> list[np.ndarray[Any, Any]]:
    """Of every run the columns (width, rows)."""
    numbers = np.frombuffer(elements.inflated("motion"), dtype="<f4")
    lengths = [run["rows"] for run in elements.head["runs"]]
    width = len(numbers) // sum(lengths)
    ends = np.cumsum([0, *lengths]) * width
    return [numbers[a:b].reshape(width, -1) for a, b in pairwise(ends)]


class TestRowsOfAFile:
    @pytest.mark.parametrize("units", chosen([True, False], [True]))
    def test_are_shown_as_they_stand_there_with_their_scene(self, units: bool, tmp_path: Path) -> None:
        motion = model("double_pendulum").simulate(interval=0.05)
        write_table(motion, tmp_path / "rows.csv", units=units)
        page = model("double_pendulum").show(tmp_path / "p.html", browser=False, results=tmp_path / "rows.csv")
        elements = Elements(page.read_text())
        head, (table,) = elements.head, tables(elements)
        assert head["live"] is False and elements.inflated("tape") == b""
        assert "rows.csv" in head["said"] and "nothing is integrated" in head["said"]
        for column, values in zip(head["columns"], table, strict=False):
            assert np.abs(values - motion[column["name"]]).max() <= 1e-6 * max(np.abs(values).max(), 1.0)
        shape = next(s for s in head["scene"]["shapes"] if s["name"] == "mass 2")
        x, y = table[head["scene"]["first"] + shape["parts"][0]["numbers"]["at"] :][:2]
        assert np.abs(x - (0.5 * np.sin(motion["a"]) + 0.3 * np.sin(motion["b"]))).max() < 1e-6
        assert np.abs(y + (0.5 * np.cos(motion["a"]) + 0.3 * np.cos(motion["b"]))).max() < 1e-6

    @pytest.mark.parametrize(
        ("header", "told"),
        [
            ("time,a,b,der(a),bder", "has no column `bder`"),
            ("time,a,b,der(a),der(bb)", "did you mean `der(b)`?"),
            ("time,a,b,der(a)", "has no column `der(b)`: a row needs all rates of DoublePendulum"),
            ("time,a [m],b,der(a),der(b)", "`a` is in rad, the file has it in m"),
        ],
    )
    def test_of_another_model_are_refused_with_the_nearest_name(self, header: str, told: str, tmp_path: Path) -> None:
        row = ",".join(["0"] * (header.count(",") + 1))
        (tmp_path / "rows.csv").write_text(f"{header}\n{row}\n{row.replace('0', '1', 1)}\n")
        with pytest.raises(ValueError, match=r"rows\.csv") as found:
            model("double_pendulum").show(tmp_path / "p.html", browser=False, results=tmp_path / "rows.csv")
        assert told in str(found.value)

    def test_that_cannot_be_read_are_told(self, tmp_path: Path) -> None:
        with pytest.raises(CompilationFailed, match="E0820"):
            model("double_pendulum").show(tmp_path / "p.html", browser=False, results=tmp_path / "none.csv")

    def test_times_that_stand_twice_are_events(self, tmp_path: Path) -> None:
        motion = model("bouncing_ball").simulate(stop=1.0)
        write_table(motion, tmp_path / "rows.csv")
        page = model("bouncing_ball").show(tmp_path / "p.html", browser=False, results=tmp_path / "rows.csv")
        (run,) = Elements(page.read_text()).head["runs"]
        assert [e["time"] for e in run["events"]] == [motion.events[0].time]


@cache
def swept() -> Any:
    return model("pendulum").sweep({"l": [0.2, 0.5, 1.0], "theta.start": [0.1, 1.0]}, interval=0.1)


class TestSweeps:
    def test_a_page_has_every_run_with_its_parameters(self, tmp_path: Path) -> None:
        page = model("pendulum").show(tmp_path / "p.html", browser=False, sweep=swept())
        elements = Elements(page.read_text())
        runs = elements.head["runs"]
        assert [run["label"] for run in runs][:2] == [
            "l = 0.2 m, theta.start = 5.72958 deg", "l = 0.2 m, theta.start = 57.2958 deg",
        ]  # fmt: skip
        names = [slider["name"] for slider in elements.head["parameters"]]
        assert [run["parameters"][names.index("l")] for run in runs] == [0.2, 0.2, 0.5, 0.5, 1.0, 1.0]
        for k, table in enumerate(tables(elements)):
            expected = swept()["theta"].values.reshape(6, -1)[k]
            assert np.abs(np.interp(swept()["time"].values[:10], table[0], table[1]) - expected[:10]).max() < 0.02
        assert len(page.read_bytes()) < 1.6e6

    def test_a_part_of_a_sweep_is_a_sweep(self, tmp_path: Path) -> None:
        page = model("pendulum").show(tmp_path / "p.html", browser=False, sweep=swept().isel(l=1))
        assert [run["label"] for run in Elements(page.read_text()).head["runs"]] == [
            "theta.start = 5.72958 deg", "theta.start = 57.2958 deg",
        ]  # fmt: skip

    def test_of_another_model_and_of_too_many_runs_are_refused(self, tmp_path: Path) -> None:
        with pytest.raises(ValueError, match="the sweep is of `Pendulum`, not of `DoublePendulum`"):
            model("double_pendulum").show(tmp_path / "p.html", browser=False, sweep=swept())
        many = model("pendulum").sweep({"l": np.linspace(0.1, 1.0, 201)}, stop=0.01, interval=0.01)
        with pytest.raises(ValueError, match="at most 200 runs, the sweep has 201"):
            model("pendulum").show(tmp_path / "p.html", browser=False, sweep=many)


class TestModes:
    def test_each_mode_moves_as_its_eigenvalue_says(self, tmp_path: Path) -> None:
        """x(t) = x0 + Re(a shape exp(s t)), here for two coordinates that no constraint ties."""
        modes = model("double_pendulum").modes(q=[0.0, 0.0], qd=[0.0, 0.0])
        elements = Elements(modes.show(tmp_path / "p.html", browser=False).read_text())
        head = elements.head
        assert head["live"] is False and len(head["runs"]) == 2 * len(LEVELS)
        for k, table in enumerate(tables(elements)):
            s, shape = modes.eigenvalues[2 * (k // 3)], modes.shapes[2 * (k // 3)]
            t, a, b = table[0].astype(float), table[1], table[2]
            size = np.real(a[0] / shape[0])
            for values, entry in ((a, shape[0]), (b, shape[1])):
                expected = np.real(size * entry * np.exp(s * t))
                assert np.abs(values - expected).max() < 1e-5 * np.abs(expected).max()
            assert t[-1] == pytest.approx(6.0 * np.pi / abs(s.imag), rel=1e-6)
        first, second, third = (np.abs(table[1]).max() for table in tables(elements)[:3])
        assert (second / first, third / second) == pytest.approx((2.5, 2.0), rel=1e-5)

    def test_constraints_hold_at_finite_amplitudes(self, tmp_path: Path) -> None:
        """On a line along the tangent the mass would leave its circle."""
        modes = compile_model(CIRCLE).modes()
        elements = Elements(modes.show(tmp_path / "p.html", browser=False).read_text())
        for table in tables(elements):
            x, y = table[1].astype(float), table[2].astype(float)
            assert np.abs(np.hypot(x, y) - 0.5).max() < 1e-7  # single precision
        assert np.ptp(x) > 0.05

    def test_eigenvalues_over_a_parameter_stand_beside(self) -> None:
        compiled = model("ziegler_column")
        found = compiled.vary("P", np.linspace(0.0, 3.0, 13))
        flat, names = compiled._compilation.flat, [slot.name for slot in compiled._engine.layout.parameters]
        head = Elements(modes_page(flat, compiled.modes(), names=names, variation=found)).head
        locus = head["locus"]
        assert (locus["name"], locus["values"][-1]) == ("P", 3.0)
        assert [t["value"] for t in locus["thresholds"]] == [t.value for t in found.thresholds] != []
        assert locus["eigenvalues"][3][0] == [found.eigenvalues[3, 0].real, found.eigenvalues[3, 0].imag]

    def test_a_model_without_a_mode_that_moves_is_told(self, tmp_path: Path) -> None:
        free = compile_model("model Free\n  coordinate Length x;\n  gravity = 0;\n  mass 1 kg at {x, 0};\nend Free;\n")
        with pytest.raises(ValueError, match="Free has no mode that moves"):
            free.modes(sink=Sink()).show(tmp_path / "p.html", browser=False)


def test_a_page_of_one_motion_has_no_runs() -> None:
    assert "runs" not in Elements(page_of("pendulum")).head
