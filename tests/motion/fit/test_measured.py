"""`measure` in the text of a model, and parameters that a fit finds."""

import numpy as np
import pytest
from fit.measured_models import DAMPED, compiled

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import flatten_file

MEASURED = DAMPED.replace("c(min = 0) = 0.01 N.m.s/rad", "c(fixed = false, start = 0.01 N.m.s/rad, min = 0)").replace(
    "end Damped", "  output Length tip[2] = {l*sin(theta), -l*cos(theta)};\n"
    "  measure encoder: theta with sigma = 0.2 deg;\n"
    "  measure der(theta);\n"
    "  measure tip with sigma = 1 mm;\nend Damped"
)  # fmt: skip


def seen(**columns):
    times = np.linspace(0.0, 2.0, 41)
    motion = compiled(DAMPED).simulate(times=times, parameters={"c": 0.03, "l": 0.6})
    found = {name: motion[of] for name, of in columns.items()}
    return {"time": times, **found}


def test_measurements_of_the_flat_model():
    flat = flatten_file(SourceFile("a.lag", MEASURED), Sink())
    found = [(each.name, each.of, each.sigma, each.stated) for each in flat.measurements]
    assert found == [
        ("encoder", "theta", pytest.approx(np.radians(0.2)), True),
        ("der(theta)", "der(theta)", None, False),
        ("tip[1]", "tip[1]", 1e-3, False),
        ("tip[2]", "tip[2]", 1e-3, False),
    ]
    (free,) = [each for each in flat.parameters if each.estimated]
    assert (free.name, free.value, free.free) == ("c", 0.01, False)


def test_the_text_names_columns_and_unknowns():
    data = seen(encoder="theta")
    found = compiled(MEASURED).fit(data, parameters={"l": 0.6})
    assert found["c"] == pytest.approx(0.03, rel=1e-5)
    assert found.series[0].sigma == pytest.approx(np.radians(0.2))
    assert "start = 0.03 N.m.s/rad" in found.text or "start = 0.0300" in found.text or "start = 0.02999" in found.text


def test_a_run_takes_the_guess():
    motion = compiled(MEASURED).simulate(stop=1.0, interval=0.1)
    assert np.array_equal(motion["theta"], compiled(DAMPED).simulate(stop=1.0, interval=0.1)["theta"])


def test_initial_equations_decide_where_there_are_some():
    text = MEASURED.replace("end Damped", "initial equation\n  der(der(theta)) = -c*theta/(1 N.m.s3);\nend Damped")
    flat = flatten_file(SourceFile("a.lag", text), Sink())
    assert [each.name for each in flat.parameters if each.free] == ["c"]
