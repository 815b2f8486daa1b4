"""The motion of models over its experiment: closed forms, invariants, constraints; and the pages about it."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
from choice import ALL, chosen
from click.testing import CliRunner

import lagdsl
from lagdsl.engines.runtime.engines.selection import engine_of
from lagdsl.interfaces.cli.main import lag
from models.corpus import MODELS, compiled, expectations, path_of
from models.kinds import OF_EACH_KIND, SOME, over
from models.references import REFERENCES, pendulums

CONSERVED = 1e-9
# Frictions of 40 contacts take hours in NumPy at this tolerance.
SLOW_IN_NUMPY = ("capstan",)


@cache
def _model(name: str) -> lagdsl.Model:
    compilation = compiled(name).compilation
    return lagdsl.Model(compilation, engine_of(compilation.program, "tape"), compiled(name).source)


@cache
def _motion(name: str) -> lagdsl.Trajectory:
    tolerance = 1e-8 if name.startswith("slider_crank") else 1e-10
    return _model(name).simulate(tolerance=tolerance, stop=_stop(name))


def _stop(name: str) -> float | None:
    """None: the end of the experiment. `make check` ends earlier where the reference takes long."""
    found = expectations(name)
    until: float | None = found.get("until")
    return until if ALL else found.get("until_in_check", until)


@SOME
def test_motion_is_the_known_one(name: str) -> None:
    motion = _motion(name)
    parameters = dict(zip(_model(name).parameters, _model(name).defaults, strict=True))
    expected = REFERENCES[name.rpartition("/")[2]](parameters, motion.time)
    assert expected
    for column, values in expected.items():
        scale = max(float(np.max(np.abs(values))), 1e-3)
        error = float(np.max(np.abs(motion[column] - values))) / scale
        assert error <= expectations(name)["tolerance"], (column, error)


@SOME
def test_what_is_conserved_stays(name: str) -> None:
    """Invariants to 1e-9 of their own size or of that of their terms; a model without damping and drive claims one."""
    motion = _motion(name)
    for record in motion.invariants:
        assert record.limit > 0
        assert record.drift <= record.limit
    if "E" in (record.name for record in motion.invariants):
        scale = max(abs(motion.energy[0]), _kinetic_scale(name))
        assert np.max(np.abs(motion.energy - motion.energy[0])) <= CONSERVED * scale


def _kinetic_scale(name: str) -> float:
    """The largest kinetic or potential energy on the way."""
    model, motion = _model(name), _motion(name)
    q = np.stack([motion[c] for c in model.coordinates], axis=-1)
    qd = np.stack([motion[f"der({c})"] for c in model.coordinates], axis=-1)
    rest = model.energy(motion.time, q, np.zeros_like(qd))
    return float(max(np.max(np.abs(rest)), np.max(np.abs(model.energy(motion.time, q, qd) - rest))))


@SOME
def test_constraints_do_not_drift(name: str) -> None:
    motion = _motion(name)
    assert np.max(motion.position_residual, initial=0.0) <= CONSERVED
    scale = max(1.0, *(float(np.max(np.abs(motion[f"der({c})"]))) for c in _model(name).coordinates), 1.0)
    assert np.max(motion.velocity_residual, initial=0.0) <= CONSERVED * scale


@over([name for name in chosen(MODELS, OF_EACH_KIND[1::6]) if name not in SLOW_IN_NUMPY])
def test_the_same_happens_under_both_engines(name: str) -> None:
    """The same events in the same order, at the same times; none where nothing can happen. Where contacts touch or
    come to rest, the order of what happens at one instant is a matter of round-off: there the motions are compared."""
    ours = _motion(name)
    if not compiled(name).graph.layout.discretes:
        assert not ours.events
        return
    theirs = lagdsl.compile(path_of(name), engine="numpy").simulate(tolerance=1e-10, stop=float(ours.time[-1]))
    if name in ("bouncing_ball", "newtons_cradle"):
        for column in compiled(name).flat.coordinates:
            _, mine, their = np.intersect1d(ours.time, theirs.time, return_indices=True)
            assert len(mine) > 100
            first, second = ours[column.name][mine], theirs[column.name][their]
            np.testing.assert_allclose(first, second, rtol=0, atol=1e-6)
        return
    assert [(event.name, event.kind) for event in ours.events] == [(event.name, event.kind) for event in theirs.events]
    first, second = ([event.time for event in motion.events] for motion in (ours, theirs))
    np.testing.assert_allclose(first, second, rtol=0, atol=1e-8 * max(1.0, ours.time[-1]))


def test_the_pendulum_has_the_period_of_the_elliptic_integral() -> None:
    expected = expectations("pendulum")["period"]
    model = _model("pendulum")
    period = getattr(pendulums, expected["reference"])(dict(zip(model.parameters, model.defaults, strict=True)))
    rising = _motion("pendulum").crossings(expected["column"], 0.0, direction=1)
    assert len(rising) > 3
    np.testing.assert_allclose(np.diff(rising), period, rtol=expected["tolerance"])


def test_a_closed_loop_keeps_its_constraints_for_a_hundred_seconds() -> None:
    motion = _model("four_bar_angles").simulate(stop=100.0, interval=0.1)
    assert motion.time[-1] == 100.0
    assert np.max(motion.position_residual) < CONSERVED
    assert np.max(motion.velocity_residual) < CONSERVED


@over(chosen(MODELS, OF_EACH_KIND[2::15]))
def test_the_command_line_runs_it(name: str, tmp_path: Path) -> None:
    """A short motion as `lag run`, and the derivation as a page."""
    runner = CliRunner()
    table = tmp_path / "out.csv"
    result = runner.invoke(lag, ["run", str(path_of(name)), "--stop", "0.1", "-o", str(table)])
    assert result.exit_code == 0, result.output
    header, *rows = table.read_text().splitlines()
    assert header.split(",")[0] == "time"
    assert len(rows) >= 2
    page = tmp_path / "page.html"
    result = runner.invoke(lag, ["derive", str(path_of(name)), "--to", "html", "-o", str(page)])
    assert result.exit_code == 0, result.output
    assert page.read_text(encoding="utf-8").startswith("<!DOCTYPE html>")
