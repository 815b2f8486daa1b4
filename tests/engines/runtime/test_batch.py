"""Many states on all cores: the results of single calls, whatever the number of threads."""

from __future__ import annotations

import threading

import numpy as np
import pytest

import lagdsl
from lagdsl.engines.runtime.engines import cores as engine_cores
from lagdsl.engines.runtime.engines.cores import PART, cores, share_out
from lagdsl.engines.runtime.engines.engine import SingularSystem
from lagdsl.interfaces.api.model import Model

LOOP = """model Loop
  parameter Length l = 0.5 m;
  parameter Mass m = 1 kg;
  input Torque u = 0.2 N.m;
  coordinate Angle a(start = 30 deg), b(start = 60 deg);
  gravity = {0, -9.81 m/s2};
  point A = l*{sin(a), -cos(a)};
  mass m at A;
  mass m at A + l*{sin(b), -cos(b)};
  torque u on a;
  constraint l*sin(a) + l*sin(b) = 0.7 m;
end Loop;
"""
# Without inertia where x = 0, whatever y does.
SINGULAR = "model S coordinate Length x(start = 1 m), y; kinetic 1/2*1 kg*((x/1 m)^2*der(x)^2 + der(y)^2); end S;"
COUNT = 3 * PART + 17


@pytest.fixture(scope="module", params=["numpy", "c"])
def model(request: pytest.FixtureRequest) -> Model:
    return lagdsl.compile(LOOP, engine=request.param)


def _states(seed: int = 5) -> dict[str, np.ndarray]:
    draw = np.random.default_rng(seed)
    return {
        "t": draw.uniform(0, 1, COUNT),
        "q": draw.uniform(-1, 1, (COUNT, 2)),
        "qd": draw.normal(size=(COUNT, 2)),
        "u": draw.normal(size=(COUNT, 1)),
        "p": draw.uniform(0.5, 2.0, (COUNT, 2)),
    }


@pytest.mark.parametrize("threads", [None, 1, 3])
def test_the_results_are_those_of_single_calls(model: Model, threads: int | None) -> None:
    states = _states()
    found = model.batch(**states, threads=threads)
    assert found.shape == (COUNT, 2)
    for i in (0, 1, PART - 1, PART, 2 * PART + 3, COUNT - 1):
        one = model.forward_dynamics(**{name: values[i] for name, values in states.items()})
        np.testing.assert_allclose(found[i], one, rtol=1e-12, atol=1e-12)


def test_the_number_of_threads_changes_no_bit(model: Model) -> None:
    states = _states(6)
    alone = model.batch(**states, threads=1)
    for threads in (2, 5):
        np.testing.assert_array_equal(model.batch(**states, threads=threads), alone)


def test_leading_axes_broadcast(model: Model) -> None:
    draw = np.random.default_rng(7)
    q, p = draw.uniform(-1, 1, (40, 1, 2)), draw.uniform(0.5, 2, (30, 2))
    qd = np.array([0.3, -0.2])
    found = model.batch(0.0, q, qd, p=p, threads=2)
    assert found.shape == (40, 30, 2)
    np.testing.assert_allclose(found, model.forward_dynamics(0.0, q, qd, p=p), rtol=1e-12, atol=1e-12)
    assert model.batch(0.0, q[0, 0], qd).shape == (2,)
    assert model.batch(0.0, np.zeros((0, 2)), qd).shape == (0, 2)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"q": np.zeros((COUNT, 3))}, "q must have 2 entries"),
        ({"p": np.zeros(1)}, "p must have 2 entries"),
        ({"qd": np.zeros((COUNT + 1, 2))}, r"leading axes \(1554,\) of qd do not fit \(1553,\)"),
        ({"threads": 0}, "threads must be at least 1"),
    ],
)
def test_shapes_that_do_not_fit_are_told(model: Model, change: dict[str, object], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        model.batch(**{**_states(), **change})


@pytest.mark.parametrize("engine", ["numpy", "c"])
@pytest.mark.parametrize("threads", [1, 4])
def test_a_singular_state_is_told(engine: str, threads: int) -> None:
    model = lagdsl.compile(SINGULAR, engine=engine)
    q = np.ones((COUNT, 2))
    q[2 * PART + 5, 0] = 0.0
    with pytest.raises(SingularSystem, match=r"coordinate 0 \(`x`\) is not determined") as failure:
        model.batch(0.0, q, np.ones(2), threads=threads)
    assert failure.value.coordinate == 0


def test_the_first_failure_counts_and_every_thread_has_its_own_worker() -> None:
    meet = threading.Barrier(2, timeout=10)
    workers = []

    def worker():
        workers.append(threading.get_ident())

        def part(first: int, end: int) -> None:
            if first < 2 * PART:
                meet.wait()  # both threads are at work
                raise SingularSystem(first)

        return part

    with pytest.raises(SingularSystem) as failure:
        share_out(5 * PART, 2, worker)
    assert failure.value.coordinate == 0
    assert len(set(workers)) == len(workers) == 2


@pytest.mark.parametrize(("seconds", "threads"), [(0.0, 3), (float("inf"), 1)])
def test_threads_start_where_the_rest_takes_long(monkeypatch: pytest.MonkeyPatch, seconds: float, threads: int) -> None:
    """A first part tells how long the rest takes; the others meet where there are several threads."""
    monkeypatch.setattr(engine_cores, "_WORTH_THREADS", seconds)
    monkeypatch.setattr(engine_cores, "cores", lambda: 2)
    meet = threading.Barrier(2, timeout=10)
    done: list[tuple[int, int]] = []
    workers = []

    def worker():
        workers.append(threading.get_ident())

        def part(first: int, end: int) -> None:
            if threads > 1 and PART <= first < 3 * PART:
                meet.wait()
            done.append((first, end))

        return part

    share_out(4 * PART + 5, None, worker)
    assert sorted(done) == [*((k * PART, (k + 1) * PART) for k in range(4)), (4 * PART, 4 * PART + 5)]
    assert len(workers) == threads


def test_few_states_stay_in_one_thread(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(engine_cores, "_WORTH_THREADS", 0.0)
    done: list[tuple[int, int]] = []
    share_out(PART, None, lambda: lambda first, end: done.append((first, end)))
    assert done == [(0, PART)]


def test_memory_serves_one_call_after_the_other(model: Model) -> None:
    """No call sees what another one left there: parameters, inputs, another number of states."""
    states = _states(8)
    alone = model.batch(**states)
    model.batch(0.0, states["q"][:40], np.zeros(2))
    np.testing.assert_array_equal(model.batch(**states), alone)
    np.testing.assert_array_equal(
        model.batch(0.0, states["q"][:300], np.zeros(2)), model.batch(0.0, states["q"], np.zeros(2))[:300]
    )


def test_out_takes_the_result_and_may_be_an_argument(model: Model) -> None:
    states = _states(9)
    expected = model.batch(**states)
    room = np.empty_like(expected)
    assert model.batch(**states, out=room) is room
    np.testing.assert_array_equal(room, expected)
    qd = states["qd"]
    assert model.batch(**states, out=qd) is qd
    np.testing.assert_array_equal(qd, expected)
    with pytest.raises(ValueError, match="out must have the shape"):
        model.batch(**states, out=room[:-1])


def test_cores() -> None:
    assert cores() >= 1


def test_the_form_of_the_arguments_changes_no_bit(model: Model) -> None:
    """Arrays in one piece go to C as they lie; strided, read-only and nested ones are brought there."""
    states = _states()
    q, qd, u, p = (states[name][:300] for name in ("q", "qd", "u", "p"))
    known = model.batch(0.0, q.tolist(), qd.tolist(), u=u.tolist(), p=p.tolist())
    fixed = q.copy()
    fixed.flags.writeable = False
    for given in (q, np.asfortranarray(q), fixed, np.hstack([q, q])[:, :2]):
        assert np.array_equal(model.batch(0.0, given, qd, u=u, p=p), known)
    room = np.empty_like(q)
    assert model.batch(0.0, q, qd, u=u, p=p, out=room) is room
    assert np.array_equal(room, known)
    rates = qd.copy()
    assert model.batch(0, q, rates, u=u, p=p, out=rates) is rates
    assert np.array_equal(rates, known)
    one = model.batch(0.0, q, qd, u=u[0], p=p[0])
    assert np.array_equal(one, model.batch(0.0, q, qd, u=np.tile(u[0], (300, 1)), p=np.tile(p[0], (300, 1))))
    assert np.array_equal(model.batch(0.0, q, qd, u=u), model.batch(0.0, q, qd, u=u, p=model.defaults))
    with pytest.raises(ValueError, match="qd must have 2 entries"):
        model.batch(0.0, q, qd[:, :1])
