"""Messages of a fit: of one that cannot begin, and of one that ends."""

import numpy as np
import pytest
from fit.measured_models import BALL, DAMPED, LINE, compiled

import lagdsl

TIMES = np.linspace(0.0, 2.0, 30)


def data(**columns):
    return {"time": TIMES, "theta": 0.1 * np.cos(4.0 * TIMES)} | columns


@pytest.mark.parametrize(
    ("code", "given", "arguments"),
    [
        ("E1101", data(thata=TIMES), {"free": "l"}),
        ("E1102", {"time": TIMES}, {"free": "l"}),
        ("E1103", data(time=TIMES - 1.0), {"free": "l"}),
        ("E1103", data(), {"free": "l", "stop": 1.0}),
        ("E1104", {"time": [1.0], "theta": [0.1]}, {"free": "l"}),
        ("E1105", data(), {"free": []}),
        ("E1105", data(), {}),
        ("E1106", data(), {"free": {"l": (1.0, 2.0)}}),
        ("E1106", data(), {"free": {"l": (2.0, 1.0)}}),
        ("E1107", data(), {"free": "l", "parameters": {"m": 0.0}}),
        ("E1109", data(), {"free": "l", "sigma": {"der(theta)": 1.0}}),
        ("E0874", data(), {"free": "length"}),
        ("E0874", data(), {"free": "l", "sigma": {"tetha": 1.0}}),
    ],
)
def test_refused(code, given, arguments):
    with pytest.raises(lagdsl.CompilationFailed) as caught:
        compiled(DAMPED).fit(given, **arguments)
    assert code in [each.code for each in caught.value.diagnostics]


def test_fewer_events_than_measured():
    with pytest.raises(lagdsl.CompilationFailed, match="E1108"):
        compiled(BALL).fit({"floor": np.linspace(0.1, 0.5, 90)}, "g", stop=1.0)


@pytest.mark.parametrize(
    ("words", "given", "arguments"),
    [
        ("no loss", data(), {"loss": "square"}),
        ("at least 1", data(), {"starts": 0}),
        ("between 0 and 1", data(), {"confidence": 95}),
        ("no numbers", data(theta=np.full(30, np.nan)), {}),
        ("as many numbers", data(theta=[1.0]), {}),
        ("not decrease", data(time=TIMES[::-1]), {}),
        ("must be positive", data(), {"sigma": {"theta": -1.0}}),
        ("not free", data(), {"own": ["c"]}),
        ("at least one run", [], {}),
        ("a run has data", {"run": {"file": "a.csv"}}, {}),
    ],
)
def test_wrong_arguments(words, given, arguments):
    with pytest.raises(ValueError, match=words):
        compiled(DAMPED).fit(given, "l", **arguments)


def test_another_order_of_events_is_told():
    text = BALL.replace(
        "contact floor: h >= 0 with restitution = e;",
        "contact floor: h >= 0 with restitution = e;\n  contact wall: 1.2 m - h >= 0 with restitution = 1;",
    )
    times = np.linspace(0.0, 1.0, 60)
    model = compiled(text)
    motion = model.simulate(times=times, start={"der(h)": 1.9})
    seen = {"time": times, "h": motion["h"][np.searchsorted(motion.time, times, side="right") - 1]}
    found = model.fit(seen, ["der(h).start"], start={"der(h)": 2.0})
    assert "W1112" in [each.code for each in found.notes]


def test_residuals_that_are_not_white_are_told():
    seen = {"time": TIMES, "x": 1.0 + 0.2 * TIMES**2}
    found = compiled(LINE).fit(seen, ["x.start", "der(x).start"])
    assert [each.code for each in found.notes] == ["W1114"]
    assert found.series[0].white < 1e-6


# The first steps go too far: x(1 s) = p^3, and beyond 1.5 m there is no motion.
CUBE = """model Cube
  parameter Real p = 0.3;
  coordinate Length x(start = 0, der(start = p^3*(1 m/s)));
  mass 1 kg at {x, 0};
equation
  assert(x < 1.5 m, "too far");
end Cube;
"""


def test_trials_without_a_motion_are_told():
    found = compiled(CUBE).fit({"time": TIMES[:16], "x": TIMES[:16]}, "p")
    assert found["p"] == pytest.approx(1.0, rel=1e-6)
    assert [each.code for each in found.notes] == ["W1115"]


def test_a_search_without_an_end_is_told(monkeypatch):
    monkeypatch.setattr("lagdsl.motion.fit.search._MOST_TRIALS", 2)
    found = compiled(CUBE).fit({"time": TIMES[:16], "x": TIMES[:16]}, "p")
    assert "W1110" in [each.code for each in found.notes] and not found.converged
