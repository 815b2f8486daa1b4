"""Sweeps: the plan, the runs, what is kept on disk, the dataset."""

from __future__ import annotations

import threading
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import lagdsl
from lagdsl.engines.runtime.engines.engine import EngineName
from lagdsl.interfaces.api.model import Model
from lagdsl.motion.sweep.dataset import require_room
from lagdsl.motion.sweep.journal import Busy, Journal, fingerprint_of, outcomes
from lagdsl.motion.sweep.plan import (
    Axis,
    Plan,
    Task,
    place,
    require_few,
    require_sound,
    settings,
    task,
    tasks_of,
    variants,
)
from lagdsl.motion.sweep.run import Options, Outcome, Runner, SweptModel
from lagdsl.motion.sweep.sweep import Unfinished, Work, journal_path
from lagdsl.motion.sweep.threads import in_threads

TEXT = """model Drop
  parameter Mass m(min = 0.1 kg) = 1 kg;
  parameter Acceleration g = 9.81 m/s2;
  coordinate Length h(start = 1 m);
  gravity = -g*world.y;
  mass m at {0, h};
equation
  assert(h > 0, "on the floor");
end Drop;
"""
OSCILLATOR = """model Oscillator
  parameter Real k = 1;
  coordinate Real x(start = 0.0);
  input Real u;
  kinetic 1/2*1 kg.m2*der(x)^2;
  potential 1/2*k*1 N.m*x^2;
  force (u + k)*1 N.m on x;
end Oscillator;
"""
OPTIONS = Options(stop=0.3, interval=0.1, tolerance=None, solver="auto", engine="numpy", inputs={})
ON_TAPE = replace(OPTIONS, engine="tape")
LONG = replace(ON_TAPE, stop=1e6, interval=1e5)


@pytest.fixture(scope="module")
def model() -> Model:
    return lagdsl.compile(TEXT)


@pytest.fixture
def swept(model: Model) -> SweptModel:
    return SweptModel(flat=model._compilation.flat, program=model._compilation.program)


def _axis(name: str, *values: float, target: str = "parameter") -> Axis:
    return Axis(name=name, key=name, target=target, unit="", values=values)  # type: ignore[arg-type]


def _plan() -> Plan:
    return Plan(axes=(_axis("m", 1, 2), _axis("g", 5, 10, 15)))


class TestPlan:
    def test_runs_count_as_elements_of_an_array(self) -> None:
        plan = Plan(axes=(_axis("a", 1, 2), _axis("b", 3, 4, 5)), samples=(_axis("c", 6, 7), _axis("d", 8, 9)))
        assert plan.shape == (2, 3, 2)
        assert plan.runs == 12
        for number, (i, j, k) in enumerate(np.ndindex(plan.shape)):
            expected = {"a": (1, 2)[i], "b": (3, 4, 5)[j], "c": (6, 7)[k], "d": (8, 9)[k]}
            assert settings(plan, number)["parameter"] == expected

    def test_a_run_is_told_by_what_is_varied(self) -> None:
        length = Axis(name="l", key="l", target="parameter", unit="m", values=(0.1, 0.25))
        start = Axis(name="x.start", key="x", target="start", unit="", values=(1, 2, 3))
        assert place(Plan(axes=(length, start), fixed=(_axis("m", 7),)), 4) == "l = 0.25 m, x.start = 2"
        assert place(Plan(samples=(length,)), 0) == "l = 0.1 m"
        assert place(Plan(fixed=(_axis("m", 7),)), 0) == ""

    def test_there_is_an_end_to_runs(self) -> None:
        require_few(1_000_000)
        with pytest.raises(ValueError, match=r"1e\+06 runs, at most 1000000"):
            require_few(1_000_001)

    def test_results_must_have_room(self) -> None:
        require_room(1000, 1000, 10, Path("x.nc"))
        with pytest.raises(ValueError, match="fewer runs, fewer rows or fewer columns"):
            require_room(1_000_000, 1_000_000, 10, None)
        with pytest.raises(ValueError, match=r"NetCDF holds 2.15 GB: .* \.parquet"):
            require_room(1000, 300_000, 1, Path("x.nc"))
        require_room(1000, 300_000, 1, Path("x.csv"))

    def test_structural_settings_are_models_of_their_own(self) -> None:
        plan = Plan(
            axes=(_axis("N", 2, 3, target="structural"), _axis("l", 1, 2)), fixed=(_axis("x", 4, target="start"),)
        )
        known = variants(plan)
        assert known == [{"N": 2}, {"N": 3}]
        assert [task(plan, i, known).swept for i in range(4)] == [0, 0, 1, 1]
        assert task(plan, 3, known).start == {"x": 4}
        assert variants(Plan(axes=(_axis("l", 1, 2),))) == [{}]

    @pytest.mark.parametrize(
        ("plan", "words"),
        [
            (Plan(axes=(_axis("a"),)), "has no values"),
            (Plan(axes=(_axis("a", 1, 1),)), "same value twice"),
            (Plan(axes=(_axis("a", 1, np.inf),)), "finite"),
            (Plan(axes=(_axis("a", 1, 2),), fixed=(_axis("a", 1),)), "set twice"),
            (Plan(samples=(_axis("a", 1, 2), _axis("b", 1))), "same number"),
            (Plan(axes=tuple(_axis(n, *range(1000)) for n in "abc")), r"1e\+09 runs"),
        ],
    )
    def test_what_is_no_sweep_is_refused(self, plan: Plan, words: str) -> None:
        with pytest.raises(ValueError, match=words):
            require_sound(plan)


class TestRuns:
    def test_a_run_that_fails_says_when_and_why(self, swept: SweptModel) -> None:
        plan = Plan(axes=(_axis("g", 10, 100),))
        good, bad = sorted(in_threads([swept], OPTIONS, tasks_of(plan, [{}], ()), 2, 1), key=lambda each: each.index)
        assert (good.status, good.message, good.ended) == ("ok", "", 0.3)
        np.testing.assert_allclose(good.values[:, 0], 1 - 5 * np.array([0, 0.1, 0.2, 0.3]) ** 2)
        assert bad.status == "failed"
        assert "on the floor" in bad.message
        assert np.sqrt(0.02) < bad.ended <= 0.2  # assertions are looked at after steps and in rows
        np.testing.assert_allclose(bad.values[:2, 0], [1, 0.5])

    @pytest.mark.parametrize(
        ("chosen", "words"),
        [({"m": 0.01}, "at least 0.1 kg"), ({"m": "x"}, "")],
    )
    def test_nothing_is_raised(self, swept: SweptModel, chosen: dict[str, float], words: str) -> None:
        (outcome,) = in_threads([swept], OPTIONS, [_task(chosen)], 1, 1)
        assert outcome.status == "failed"
        assert words in outcome.message
        assert np.isnan(outcome.ended)

    def test_a_model_that_does_not_compile_fails_its_runs(self) -> None:
        assert Runner([SweptModel(fault="E0203: no `x`")], OPTIONS)(_task({})).message == "E0203: no `x`"

    def test_threads_give_the_same(self, swept: SweptModel) -> None:
        plan = Plan(axes=(_axis("m", 1, 2), _axis("g", 5, 10, 100)))
        runner = Runner([swept], ON_TAPE)
        alone = [runner(each) for each in tasks_of(plan, [{}], ())]
        several = in_threads([swept], ON_TAPE, tasks_of(plan, [{}], ()), plan.runs, 3)
        for one, other in zip(alone, sorted(several, key=lambda outcome: outcome.index), strict=True):
            assert (one.index, one.status, one.names) == (other.index, other.status, other.names)
            assert one.message == other.message
            np.testing.assert_array_equal(one.values, other.values)
        assert {one.status for one in alone} == {"ok", "failed"}

    @pytest.mark.parametrize("engine", ["numpy", "tape"])
    def test_leaving_early_stops_the_threads(self, engine: EngineName) -> None:
        """The first run is short, the others take many minutes."""
        others = set(threading.enumerate())  # those of tests before, in the same process
        made = in_threads([_oscillator()], replace(LONG, engine=engine), [_task({"k": k}) for k in (0, 1, 2, 3)], 4, 2)
        begun = time.perf_counter()
        assert next(made).status == "ok"
        made.close()
        assert time.perf_counter() - begun < 60
        assert set(threading.enumerate()) <= others

    def test_functions_are_inputs_too(self) -> None:
        options = replace(LONG, stop=1.0, interval=0.5, inputs={"u": lambda t: 6 * t})
        (outcome,) = in_threads([_oscillator()], options, [_task({"k": 0})], 1, 2)
        np.testing.assert_allclose(outcome.values[:, 0], np.array([0, 0.5, 1]) ** 3, atol=1e-6)


def _oscillator() -> SweptModel:
    compilation = lagdsl.compile(OSCILLATOR)._compilation
    return SweptModel(flat=compilation.flat, program=compilation.program)


def _task(parameters: dict[str, float]):
    return Task(index=0, swept=0, parameters=parameters, start={})


class TestJournal:
    def _outcome(self, index: int) -> Outcome:
        values = np.array([[1.0, np.nan], [0.1 + index, -0.0]])
        return Outcome(
            index=index,
            status="failed",
            ended=np.nan,
            message="ä\n",
            names=("x", "der(x)"),
            units=("m", "m/s"),
            values=values,
        )

    def test_what_is_written_is_read(self, tmp_path: Path) -> None:
        path = tmp_path / "j"
        assert fingerprint_of(path) is None
        with Journal(path, "abc") as journal:
            journal.append(self._outcome(3))
        with Journal(path, "abc") as journal:
            journal.append(self._outcome(1))
        assert fingerprint_of(path) == "abc"
        found = list(outcomes(path))
        assert [each.index for each in found] == [3, 1]
        np.testing.assert_array_equal(found[0].values, self._outcome(3).values)
        assert (found[0].message, found[0].names, found[0].units) == ("ä\n", ("x", "der(x)"), ("m", "m/s"))
        assert np.isnan(found[0].ended)

    def test_a_record_cut_short_anywhere_costs_itself_only(self, tmp_path: Path) -> None:
        path = tmp_path / "j"
        with Journal(path, "abc") as journal:
            journal.append(self._outcome(0))
            first = path.stat().st_size
            journal.append(self._outcome(1))
        whole = path.read_bytes()
        for size in range(first, len(whole)):
            path.write_bytes(whole[:size])
            with Journal(path, "abc") as journal:
                assert path.stat().st_size == first
                journal.append(self._outcome(2))
            assert [each.index for each in outcomes(path)] == [0, 2]

    def test_a_changed_byte_is_noticed(self, tmp_path: Path) -> None:
        path = tmp_path / "j"
        with Journal(path, "abc") as journal:
            journal.append(self._outcome(0))
        data = bytearray(path.read_bytes())
        data[-3] ^= 1
        path.write_bytes(bytes(data))
        assert list(outcomes(path)) == []

    def test_one_process_at_a_time(self, tmp_path: Path) -> None:
        path = tmp_path / "j"
        with Journal(path, "abc"), pytest.raises(Busy, match="another process"):
            Journal(path, "abc")
        with Journal(path, "abc"):
            assert list(outcomes(path)) == []

    def test_a_title_cut_short_begins_anew(self, tmp_path: Path) -> None:
        path = tmp_path / "j"
        path.write_bytes(b"lag sweep 1 ab")
        with Journal(path, "xyz"):
            assert fingerprint_of(path) == "xyz"


class TestDataset:
    @pytest.fixture(autouse=True)
    def _needs_xarray(self) -> None:
        pytest.importorskip("xarray")

    def test_every_column_over_every_axis(self, model: Model) -> None:
        draws = np.random.default_rng(1).normal(1.0, 0.1, 4)
        data = model.sweep(
            {"g": [5, 10], "m": 2.0}, samples={"h.start": draws}, stop=0.3, interval=0.1, tolerance=1e-10, jobs=1
        )
        assert data["h"].dims == ("g", "sample", "time")
        assert data["h"].attrs["units"] == "m"
        assert float(data["m"]) == 2.0
        fall = draws[None, :, None] - 0.5 * data["g"].values[:, None, None] * data["time"].values ** 2
        np.testing.assert_allclose(data["h"].values, fall, atol=1e-9)
        np.testing.assert_array_equal(data["h.start"].values, draws)
        assert (data["status"] == "ok").all()

    def test_failures_are_recorded(self, model: Model) -> None:
        data = model.sweep({"g": [5, 100]}, stop=0.3, interval=0.1, jobs=1, columns=["h"])
        assert list(data["status"].values) == ["ok", "failed"]
        assert "on the floor" in str(data["message"].values[1])
        np.testing.assert_allclose(data["h"].values[1, :2], [1, 0.5])
        assert np.isnan(data["h"].values[1, 3])
        assert "der(h)" not in data

    @pytest.mark.parametrize(
        ("options", "error", "words"),
        [
            ({"values": {"h.stat": [1, 2]}}, KeyError, "did you mean `h.start`"),
            ({"values": {"m": [[1, 2]]}}, ValueError, "a sequence of numbers"),
            ({"values": {"m": [0.01, 2]}}, ValueError, "at least 0.1"),
            ({"values": {}, "samples": {"m": [1, 2], "g": [1]}}, ValueError, "same number"),
            ({"values": {"m": [1, 2]}, "output": "x.txt"}, ValueError, ".nc, .parquet, .csv"),
            ({"values": {"m": [1, 2]}, "resume": True}, ValueError, "with an output"),
            ({"values": {"m": np.linspace(1, 2, 2000), "g": np.linspace(1, 2, 2000)}}, ValueError, "4e\\+06 runs"),
        ],
    )
    def test_what_does_not_fit_is_told(
        self, model: Model, options: dict[str, object], error: type[Exception], words: str
    ) -> None:
        with pytest.raises(error, match=words):
            model.sweep(**options)  # type: ignore[arg-type]

    def test_names_of_the_model_come_first(self) -> None:
        text = """model M parameter Real status = 1; coordinate Real time_; gravity = 0;
                  kinetic status/2*1 kg.m2*der(time_)^2; end M;"""
        data = lagdsl.compile(text).sweep({"status": [1, 2]}, stop=1, interval=1, jobs=1)
        assert data["time_"].dims == ("status", "time")
        assert list(data["status_"].values) == ["ok", "ok"]

    @pytest.mark.parametrize("ending", [".nc", ".parquet", ".csv"])
    def test_files(self, model: Model, tmp_path: Path, ending: str) -> None:
        import pandas as pd
        import xarray

        out = tmp_path / f"out{ending}"
        data = model.sweep({"g": [5, 100]}, stop=0.3, interval=0.1, jobs=1, output=out)
        assert [p.name for p in tmp_path.iterdir()] == [out.name]
        if ending == ".nc":
            with xarray.open_dataset(out) as read:
                xarray.testing.assert_equal(read.load(), data)
            return
        table = (
            pd.read_parquet(out) if ending == ".parquet" else pd.read_csv(out, keep_default_na=False, na_values=[""])
        )
        assert len(table) == 8
        np.testing.assert_array_equal(table["h"], data["h"].values.ravel())

    def test_an_interrupted_sweep_goes_on(self, model: Model, tmp_path: Path) -> None:
        out = tmp_path / "out.nc"
        values = {"g": np.arange(1.0, 7.0)}

        def interrupt(fraction: float) -> None:
            if fraction > 0.4:
                raise KeyboardInterrupt

        with pytest.raises(KeyboardInterrupt):
            model.sweep(values, stop=0.3, interval=0.1, jobs=1, output=out, progress=interrupt)
        kept = journal_path(out)
        assert not out.exists()
        assert len(list(outcomes(kept))) == 3
        with Journal(kept, fingerprint_of(kept) or ""), pytest.raises(Busy):
            model.sweep(values, stop=0.3, interval=0.1, jobs=1, output=out, resume=True)
        with pytest.raises(Unfinished, match="resume it"):
            model.sweep(values, stop=0.3, interval=0.1, jobs=1, output=out)
        with pytest.raises(Unfinished, match="another sweep"):
            model.sweep(values, stop=0.3, interval=0.05, jobs=1, output=out, resume=True)
        seen: list[float] = []
        data = model.sweep(values, stop=0.3, interval=0.1, jobs=1, output=out, resume=True, progress=seen.append)
        assert seen == pytest.approx([4 / 6, 5 / 6, 1])
        whole = model.sweep(values, stop=0.3, interval=0.1, jobs=1)
        np.testing.assert_array_equal(data["h"].values, whole["h"].values)
        assert not kept.exists()

    def test_a_cluster_that_goes_away(self, model: Model, tmp_path: Path) -> None:
        LocalCluster = pytest.importorskip("distributed").LocalCluster
        out = tmp_path / "out.nc"
        values = {"g": np.arange(1.0, 100.0)}
        with LocalCluster(n_workers=1, processes=False, dashboard_address=None) as cluster:
            address = cluster.scheduler_address

            def end(fraction: float) -> None:
                cluster.close()

            with pytest.raises(ConnectionError, match="was lost"):
                model.sweep(values, stop=0.1, interval=0.1, scheduler=address, output=out, progress=end)
        assert all(outcome.status == "ok" for outcome in outcomes(journal_path(out)))
        data = model.sweep(values, stop=0.1, interval=0.1, jobs=1, output=out, resume=True)
        assert (data["status"] == "ok").all()

    def test_the_c_engine(self, tmp_path: Path) -> None:
        data = lagdsl.compile(TEXT, engine="c").sweep({"g": [5, 6]}, stop=0.3, interval=0.1, jobs=2)
        assert (data["status"] == "ok").all()

    def test_a_cluster(self, model: Model, tmp_path: Path) -> None:
        LocalCluster = pytest.importorskip("distributed").LocalCluster
        with pytest.raises(ConnectionError, match="no Dask scheduler"):
            model.sweep({"g": [5, 6]}, scheduler="nonsense://x")
        model.sweep({"g": [5, 6]}, stop=0.3, interval=0.1, output=tmp_path / "after.nc")  # as if nothing had been
        with LocalCluster(n_workers=1, processes=False, dashboard_address=None) as cluster:
            data = model.sweep({"g": [5, 6]}, stop=0.3, interval=0.1, scheduler=cluster.scheduler_address)
        assert (data["status"] == "ok").all()


def test_work_is_local_unless_said() -> None:
    assert Work().scheduler is None
