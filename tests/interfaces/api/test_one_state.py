"""Calls at one state: the bits of the way of arrays, what is left out, arguments of all forms, `out`, errors."""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest
from choice import engines, together

import lagdsl
from lagdsl.engines.backends.python.support.names import arrays_of
from lagdsl.engines.runtime.engines import auto_engine
from lagdsl.engines.runtime.engines.engine import SingularSystem
from lagdsl.interfaces.api.model import Model

# States, inputs with defaults that follow time and a parameter, relations, a contact, rows that lengths weigh.
EVERYTHING = """model Everything
  parameter Length l = 0.5 m;
  parameter Mass m = 1.3 kg;
  parameter Torque most = 0.2 N.m;
  input Torque u = most;
  coordinate Angle a(start = 30 deg), b(start = 60 deg);
  coordinate Length h(start = 0.4 m);
  state Real s(start = 0.3);
  gravity = {0, -9.81 m/s2};
  frame F = world.at({a*l/1 rad, l, 0 m}).rotz(b);
  point A = l*{sin(a), -cos(a)};
  point B = A + l*{sin(b), -cos(b)};
  point C = {2 m, h};
  mass m at A;
  mass m at B;
  mass m at C;
  torque if a > 0.5 rad then u else 2*u on a;
  torque s*1 N.m on b;
  constraint l*sin(a) + l*sin(b) = 0.7 m;
  contact floor: h >= 0 with restitution = 0.5;
  output Angle sum = a + b;
  output Real turned = der(der(a))/(1 rad/s2);
equation
  der(s) = -s/1 s;
end Everything;
"""
SINGULAR = "model S coordinate Length x(start = 1 m), y; kinetic 1/2*1 kg*((x/1 m)^2*der(x)^2 + der(y)^2); end S;"
FULL = ("z", "u", "w")
# How each function is called: the state, then what else it takes.
CALLS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "forward_dynamics": (("q", "qd"), (*FULL, "p")),
    "multipliers": (("q", "qd"), (*FULL, "p")),
    "inverse_dynamics": (("q", "qd", "qdd"), (*FULL, "p")),
    "mass_matrix": (("q",), ("qd", "p")),
    "coriolis_matrix": (("q", "qd"), ("p",)),
    "gravity_forces": (("q",), ("p",)),
    "bias_forces": (("q", "qd"), (*FULL, "p")),
    "regressor": (("q", "qd", "qdd"), (*FULL, "p")),
    "constraint_jacobian": (("q",), ("p",)),
    "output": (("q", "qd"), (*FULL, "p")),
    "energy": (("q", "qd"), ("p",)),
    "state_jacobian": (("q", "qd"), (*FULL, "p")),
    "input_jacobian": (("q", "qd"), (*FULL, "p")),
    "parameter_jacobian": (("q", "qd"), (*FULL, "p")),
    "output_jacobian": (("q", "qd"), (*FULL, "p")),
    "frame.position": (("q",), (*FULL, "p")),
    "frame.rotation": (("q",), (*FULL, "p")),
    "frame.velocity": (("q", "qd"), (*FULL, "p")),
    "frame.jacobian": (("q",), (*FULL, "p")),
    "frame.bias_acceleration": (("q", "qd"), (*FULL, "p")),
    "point.position": (("q",), (*FULL, "p")),
    "point.jacobian": (("q",), (*FULL, "p")),
}


@cache
def model(engine: str = "tape", source: str = EVERYTHING) -> Model:
    return lagdsl.compile(source, engine=engine)  # type: ignore[arg-type]


def call_of(subject: Model, name: str) -> Callable[..., np.ndarray]:
    what, _, function = name.rpartition(".")
    owner: Any = subject if not what else subject.frame("F") if what == "frame" else subject.point("B")
    found: Callable[..., np.ndarray] = getattr(owner, function)
    return found


def arguments(subject: Model, count: int = 2) -> dict[str, np.ndarray]:
    """Several states: every entry differs."""
    draw = np.random.default_rng(3)
    n = len(subject.coordinates)
    found = {name: draw.uniform(0.1, 0.9, (count, n)) for name in ("q", "qd", "qdd")}
    found["z"] = draw.normal(size=(count, len(subject.states)))
    found["u"] = draw.normal(size=(count, len(subject.inputs)))
    found["w"] = draw.integers(0, 2, (count, len(subject.discretes))).astype(float)
    found["p"] = subject.defaults * draw.uniform(0.9, 1.1, (count, len(subject.defaults)))
    return found


@together(("engine", "name"), [(engine, name) for engine in engines(["tape", "c"]) for name in CALLS])
def test_one_state_has_the_bits_of_the_way_of_arrays(engine: str, name: str) -> None:
    subject = model(engine)
    call, (needed, others) = call_of(subject, name), CALLS[name]
    given = arguments(subject)
    times = np.array([0.25, 1.5])
    for rest in ((), others, *((each,) for each in others)):
        of_all = {each: given[each] for each in (*needed, *rest)}
        expected = call(times, **of_all)
        for i in (0, 1, 0):  # what is left out again is not that of the call before
            found = call(float(times[i]), **{each: values[i] for each, values in of_all.items()})
            assert found.dtype == expected.dtype
            np.testing.assert_array_equal(found, expected[i], strict=True)


def test_numbers_of_all_forms_are_the_same_state() -> None:
    subject = model()
    q, qd = np.array([0.5, 0.25, 1.0]), np.array([1.0, 2.0, 3.0])
    expected = subject.forward_dynamics(2.0, q, qd)
    wide = np.zeros((3, 2))
    wide[:, 0] = q
    same: list[tuple[Any, Any, Any]] = [
        (2, q, qd),
        (np.float64(2.0), q.tolist(), (1, 2, 3)),
        (np.array(2.0), wide[:, 0], qd.astype(int)),
        (np.int32(2), q.astype(np.float32), qd[::-1][::-1]),
        (2.0, q.astype(">f8"), qd.astype(np.float16)),
        (2.0, {"a": 0.5, "b": "0.25 rad", "h": 1}, qd),
        (2.0, np.frombuffer(q.tobytes()), memoryview(qd)),
    ]
    for arguments_ in same:
        np.testing.assert_array_equal(subject.forward_dynamics(*arguments_), expected, strict=True)
    assert subject.forward_dynamics([2.0], q, qd).shape == (1, 3)
    assert subject.forward_dynamics(2.0, q[None], qd).shape == (1, 3)


def test_inputs_and_parameters_are_other_names_of_u_and_p() -> None:
    subject = model()
    q, qd = np.array([0.5, 0.25, 1.0]), np.zeros(3)
    p = subject.defaults
    p[subject.parameters.index("l")] = 0.7
    expected = subject.forward_dynamics(0.0, q, qd, u=[0.4], p=p)
    found = subject.forward_dynamics(0.0, q, qd, inputs={"u": "0.4 N.m"}, parameters={"l": 0.7})
    np.testing.assert_array_equal(found, expected)
    frame = subject.frame("F")
    assert np.array_equal(frame.position(0.0, q, parameters={"l": 0.7}), frame.position(0.0, q, p=p))
    with pytest.raises(ValueError, match="u and inputs are two names"):
        subject.forward_dynamics(0.0, q, qd, u=[0.4], inputs={"u": 0.4})
    with pytest.raises(ValueError, match="p and parameters are two names"):
        frame.position(0.0, q, p=p, parameters={"l": 0.7})


@together("name", CALLS)
def test_out_takes_the_result(name: str) -> None:
    subject = model()
    call, (needed, _) = call_of(subject, name), CALLS[name]
    given = {each: values[0] for each, values in arguments(subject).items() if each in needed}
    expected = call(0.5, **given)
    room = np.full(expected.shape, np.nan)
    assert call(0.5, **given, out=room) is room
    np.testing.assert_array_equal(room, expected)
    several = np.full((2, *expected.shape), np.nan)
    assert call(0.5, **{each: np.stack([v, v]) for each, v in given.items()}, out=several) is several
    np.testing.assert_array_equal(several, np.stack([expected, expected]))


def test_out_may_be_an_argument() -> None:
    subject, qd = model(), np.array([0.3, -0.2, 0.1])
    q = np.array([0.5, 0.25, 1.0])
    expected = subject.forward_dynamics(0.0, q, qd)
    assert np.array_equal(subject.forward_dynamics(0.0, q, qd, out=qd), expected)


@pytest.mark.parametrize("several", [False, True])
def test_out_of_another_kind_is_refused(several: bool) -> None:
    subject = model()
    q = np.array([0.5, 0.25, 1.0])
    axes = (2,) if several else ()
    given = np.broadcast_to(q, (*axes, 3))
    locked = np.zeros((*axes, 3, 3))
    locked.flags.writeable = False
    refused: list[tuple[Any, str]] = [
        (np.zeros((*axes, 3)), "shape"),
        (np.zeros((*axes, 3, 3), dtype=np.float32), "float64"),
        (np.zeros((*axes, 3, 3), dtype=complex), "float64"),
        (np.zeros((*axes, 3, 3), order="F"), "C-contiguous"),
        (np.zeros((*axes, 3, 6))[..., ::2], "C-contiguous"),
        (locked, "read-only"),
        ([[0.0] * 3] * 3, "list"),
    ]
    for out, words in refused:
        with pytest.raises(ValueError, match=words):
            subject.mass_matrix(0.0, given, out=out)
    assert np.array_equal(subject.mass_matrix(0.0, q), subject.mass_matrix(0.0, q[None])[0])


@pytest.mark.filterwarnings("error")
def test_what_is_no_state_is_told() -> None:
    subject, q, qd = model(), np.array([0.5, 0.25, 1.0]), np.zeros(3)
    wrong: list[tuple[tuple[Any, ...], dict[str, Any], str]] = [
        ((0.0, q * 1j, qd), {}, "q must be made of real numbers.*complex"),
        ((1j, q, qd), {}, "t must be made of real numbers.*complex"),
        ((0.0, q, qd), {"u": np.array([1j])}, "u must be made of real numbers.*complex"),
        ((0.0, q, qd), {"p": subject.defaults + 1j}, "p must be made of real numbers.*complex"),
        ((0.0, [1, 2, "x"], qd), {}, "q must be made of real numbers"),
        ((None, q, qd), {}, "t must be made of real numbers"),
        ((0.0, None, qd), {}, "qd is given without q"),
        ((0.0, q[:2], qd), {}, "q must have 3 entries.*the arguments are t, q, qd"),
        ((0.0, q, np.zeros(4)), {}, "qd must have 3 entries"),
        ((0.0, q, qd), {"z": np.zeros(2)}, "z must have 1 entries"),
        ((0.0, q, qd), {"w": np.zeros(99)}, "w must have"),
        ((q, q, qd), {}, "that of coordinates"),
    ]
    for given, named, words in wrong:
        with pytest.raises(ValueError, match=words):
            subject.forward_dynamics(*given, **named)
    with pytest.raises(ValueError, match="qdd must be made of real numbers"):
        subject.inverse_dynamics(0.0, q, qd, None)  # type: ignore[arg-type]
    assert np.isnan(subject.forward_dynamics(0.0, [np.nan, 0.2, 0.3], qd)).any()


def test_a_singular_state_is_told_and_the_next_one_computed() -> None:
    subject = model(source=SINGULAR)
    out = np.full(2, 7.0)
    for _ in range(2):
        with pytest.raises(SingularSystem, match="`x`"):
            subject.forward_dynamics(0.0, np.zeros(2), np.zeros(2), out=out)
        assert np.array_equal(out, [7.0, 7.0])
        assert np.array_equal(subject.forward_dynamics(0.0, np.ones(2), np.zeros(2), out=out), [0.0, 0.0])
        out[:] = 7.0


def test_rows_that_the_equations_multiply_are_those_of_the_text() -> None:
    """The second row is multiplied by a power of two of about 1e5. Half of the load is in both, in the multipliers of
    least norm of rows of equal length."""
    subject = model(
        source="model W coordinate Length x, y; kinetic 1/2*1 kg*(der(x)^2 + der(y)^2); force 1 N on x;"
        " constraint big: x = y; constraint small: 1e-5*x = 1e-5*y; end W;"
    )
    zero = np.zeros(2)
    assert subject._row_factors[1] > 1.0
    out = np.zeros((2, 2))
    assert subject.constraint_jacobian(0.0, zero, out=out) is out
    np.testing.assert_array_equal(out, [[1.0, -1.0], [1e-5, -1e-5]])
    np.testing.assert_allclose(subject.multipliers(0.0, zero, zero) @ out, [-0.5, 0.5], rtol=1e-14)
    for call, given in ((subject.constraint_jacobian, 1), (subject.multipliers, 2)):
        assert np.array_equal(call(0.0, *[zero] * given), call(0.0, *[zero[None]] * given)[0])


def test_several_threads_may_call_one_model() -> None:
    subject = model()
    given = arguments(subject, 8)
    expected = [subject.forward_dynamics(0.5, given["q"][i], given["qd"][i], p=given["p"][i]) for i in range(8)]
    wrong: list[int] = []

    def work(i: int) -> None:
        for _ in range(300):
            found = subject.forward_dynamics(0.5, given["q"][i], given["qd"][i], p=given["p"][i])
            if not np.array_equal(found, expected[i]):
                wrong.append(i)

    threads = [threading.Thread(target=work, args=(i,)) for i in range(8)]
    for each in threads:
        each.start()
    for each in threads:
        each.join()
    assert wrong == []


def test_the_engine_auto_hears_of_calls(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(auto_engine, "_CALLS", 5)
    heard: list[float] = []
    monkeypatch.setattr(auto_engine.AutoEngine, "is_compiled", property(lambda self: len(heard) > 1))
    monkeypatch.setattr(auto_engine.AutoEngine, "worked", lambda self, seconds: heard.append(seconds))
    subject = lagdsl.compile(SINGULAR)
    for _ in range(30):
        assert np.array_equal(subject.forward_dynamics(0.0, np.ones(2), np.zeros(2)), [0.0, 0.0])
    assert len(heard) == 2
    assert min(heard) > 0.0


def test_outputs_by_name_are_those_of_the_vector() -> None:
    subject = model()
    q, qd = np.array([0.5, 0.25, 1.0]), np.zeros(3)
    expected = arrays_of(subject.outputs, subject.output(0.0, q, qd))
    assert subject.named_outputs(0.0, q, qd) == expected
    assert expected["sum"] == 0.75
