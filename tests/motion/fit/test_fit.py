"""Fits against closed forms: linear least squares, times of bounces, intervals by repetition."""

import numpy as np
import pytest
from choice import ALL
from fit.measured_models import BALL, DAMPED, LINE, compiled
from scipy.stats import t as student

import lagdsl


def line(random, count=40, sigma=0.05):
    times = np.linspace(0.0, 2.0, count)
    return {"time": times, "x": 1.0 + 0.5 * times + random.normal(0.0, sigma, count)}


def exact(data):
    """Values, covariance and residual deviation of the straight line through the data (Gauss)."""
    matrix = np.column_stack([np.ones(len(data["time"])), data["time"]])
    values, squares, *_ = np.linalg.lstsq(matrix, data["x"], rcond=None)
    variance = squares[0] / (len(matrix) - 2)
    return values, variance * np.linalg.inv(matrix.T @ matrix), np.sqrt(variance)


def test_straight_line_is_that_of_linear_least_squares():
    data = line(np.random.default_rng(0))
    found = compiled(LINE).fit(data, ["x.start", "der(x).start"])
    values, covariance, deviation = exact(data)
    assert np.allclose(list(found.values.values()), values, rtol=1e-7)
    assert np.allclose(found.covariance, covariance, rtol=1e-5)
    half = student.ppf(0.975, 38) * np.sqrt(np.diag(covariance))
    assert np.allclose(np.diff(list(found.intervals.values())).ravel(), 2.0 * half, rtol=1e-5)
    assert np.isclose(found.series[0].sigma * found.deviation, deviation, rtol=1e-6)
    assert np.isclose(found.correlation[0, 1], covariance[0, 1] / np.sqrt(np.prod(np.diag(covariance))), rtol=1e-5)
    assert found.start == pytest.approx({"x": values[0], "der(x)": values[1]})
    assert found.sum_of_squares == pytest.approx(found.freedom * found.deviation**2)
    began = np.sum((data["x"] - 0.9 - 0.2 * data["time"]) ** 2) / found.series[0].sigma ** 2
    assert found.first_sum_of_squares == pytest.approx(began)


def test_several_runs_share_some_values_and_have_others_for_themselves():
    first, second = line(np.random.default_rng(1)), line(np.random.default_rng(2))
    runs = {"a": {"data": first}, "b": {"data": second}}
    found = compiled(LINE).fit(runs, "x.start, der(x).start", own=["x.start"])
    times = first["time"]
    matrix = np.zeros((80, 3))
    matrix[:40, 0], matrix[40:, 1], matrix[:, 2] = 1.0, 1.0, np.tile(times, 2)
    values = np.linalg.lstsq(matrix, np.concatenate([first["x"], second["x"]]), rcond=None)[0]
    assert list(found.values) == ["x.start (a)", "x.start (b)", "der(x).start"]
    assert np.allclose(list(found.values.values()), values, rtol=1e-7)


def test_given_sigmas_weigh_columns():
    random = np.random.default_rng(3)
    data = line(random)
    data["der(x)"] = 0.5 + random.normal(0.0, 0.01, 40)
    found = compiled(LINE).fit(data, ["x.start", "der(x).start"], sigma={"x": "5 cm", "der(x)": 0.01})
    ones, zeros = np.ones(40), np.zeros(40)
    matrix = np.vstack([np.column_stack([ones, data["time"]]) / 0.05, np.column_stack([zeros, ones]) / 0.01])
    values = np.linalg.lstsq(matrix, np.concatenate([data["x"] / 0.05, data["der(x)"] / 0.01]), rcond=None)[0]
    assert np.allclose(list(found.values.values()), values, rtol=1e-7)
    free = compiled(LINE).fit(data, ["x.start", "der(x).start"])
    assert [each.sigma for each in free.series] == pytest.approx([0.05, 0.01], rel=0.3)
    assert np.allclose(list(free.values.values()), values, rtol=0.02)


def test_outliers_do_not_move_a_robust_fit():
    data = line(np.random.default_rng(4), sigma=0.01)
    data["x"][::8] += 3.0
    plain = compiled(LINE).fit(data, ["x.start", "der(x).start"])
    robust = compiled(LINE).fit(data, ["x.start", "der(x).start"], loss="cauchy", sigma={"x": 0.01})
    assert abs(plain["x.start"] - 1.0) > 0.2
    assert abs(robust["x.start"] - 1.0) < 0.01


def impacts(e, g, h, count):
    """Times of the first bounces of a ball that falls from h: t_0 = sqrt(2 h/g), then 2 e^k t_0."""
    first = np.sqrt(2.0 * h / g)
    return first * (1.0 + 2.0 * np.cumsum(np.concatenate([[0.0], e ** np.arange(1, count)])))


def test_times_of_bounces():
    times = impacts(0.8, 9.81, 1.0, 12)
    found = compiled(BALL).fit({"floor": times}, ["e", "g"], sigma={"floor": "1 ms"})
    assert found.values == pytest.approx({"e": 0.8, "g": 9.81}, rel=1e-7)
    assert found.motions[0].events[0].time == pytest.approx(times[0], rel=1e-9)


def test_times_of_bounces_show_a_quotient():
    found = compiled(BALL).fit({"floor": impacts(0.8, 9.81, 1.0, 12)}, ["e", "g", "h.start"], sigma={"floor": 1e-3})
    assert [str(each) for each in found.hidden] == ["of g and h.start only g/h.start is visible in the data"]
    assert found["g"] / found["h.start"] == pytest.approx(9.81, rel=1e-7)
    assert np.isinf(found.intervals["g"]).all() and np.isfinite(found.intervals["e"]).all()


def test_bounds_are_kept_and_told():
    data = {"time": np.linspace(0.0, 2.0, 50), "theta": np.zeros(50)}
    data["theta"] = compiled(DAMPED).simulate(times=data["time"], parameters={"c": 0.05})["theta"]
    found = compiled(DAMPED).fit(data, {"c": (0, "0.02 N.m.s/rad")})
    assert found["c"] == pytest.approx(0.02, rel=1e-6)
    assert next(each.code for each in found.notes) == "W1111"
    assert np.isnan(found.intervals["c"]).all()


def test_many_starts_find_the_frequency():
    data = {"time": np.linspace(0.0, 6.0, 60)}
    data["theta"] = compiled(DAMPED).simulate(times=data["time"], parameters={"l": 1.1})["theta"]
    far = compiled(DAMPED).fit(data, {"l": ("10 cm", "2 m")}, parameters={"l": 0.2})
    near = compiled(DAMPED).fit(data, {"l": ("10 cm", "2 m")}, parameters={"l": 0.2}, starts=12)
    assert far["l"] != pytest.approx(1.1, rel=0.01)
    assert near["l"] == pytest.approx(1.1, rel=1e-6)


def test_inputs_of_the_data_are_those_of_the_run():
    text = LINE.replace("  mass", "  input Force u;\n  force u on x;\n  mass").replace("1 kg", "m")
    model = compiled(text.replace("  coordinate", "  parameter Mass m = 1 kg;\n  coordinate"))
    times = np.linspace(0.0, 2.0, 41)
    force = np.sin(3.0 * times)
    data = {"time": times, "u": force}
    data["x"] = model.simulate(times=times, parameters={"m": 2.5}, inputs={"u": (times, force)})["x"]
    assert model.fit(data, "m")["m"] == pytest.approx(2.5, rel=1e-6)
    held = {"u": lagdsl.Hold(times.tolist(), force.tolist())}
    motion = model.simulate(times=times, parameters={"m": 2.5}, inputs=held)
    data["x"] = motion["x"][np.searchsorted(motion.time, times, side="right") - 1]
    assert model.fit(data, "m", hold=True)["m"] == pytest.approx(2.5, rel=1e-6)


def test_intervals_of_bounces_hold_the_truth_as_often_as_they_say():
    """Times of impacts of a ball that falls from rest are sqrt(h/g) times a function of e: they show e and g/h."""
    runs, random, truth = 1000 if ALL else 15, np.random.default_rng(6), np.array([0.8, 9.81])
    times, held = impacts(*truth, 1.0, 20), np.zeros(2)
    for _ in range(runs):
        found = compiled(BALL).fit({"floor": times + random.normal(0.0, 1e-3, 20)}, ["e", "g", "h.start"])
        assert [str(each) for each in found.hidden] == ["of g and h.start only g/h.start is visible in the data"]
        _, g, h = found.values.values()
        slope = np.array([0.0, 1.0 / h, -g / h**2])
        half = student.ppf(0.975, found.freedom) * np.sqrt(slope @ found.covariance @ slope)
        low, high = found.intervals["e"]
        held += [low < truth[0] < high, abs(g / h - truth[1]) < half]
    assert np.all(np.abs(held / runs - 0.95) < (0.02 if ALL else 4.0 * np.sqrt(0.95 * 0.05 / runs)))


@pytest.mark.parametrize("runs", [1000 if ALL else 60])
def test_intervals_hold_the_truth_as_often_as_they_say(runs):
    random = np.random.default_rng(5)
    held = np.zeros(2)
    for _ in range(runs):
        found = compiled(LINE).fit(line(random, count=12), ["x.start", "der(x).start"])
        ends = np.array(list(found.intervals.values()))
        held += (ends[:, 0] < [1.0, 0.5]) & (ends[:, 1] > [1.0, 0.5])
    spread = np.sqrt(0.95 * 0.05 / runs)
    assert np.all(np.abs(held / runs - 0.95) < 4.0 * spread)
