"""The compiled model, as Python programs use it."""

from pathlib import Path

import numpy as np
import pytest

import lagdsl
from lagdsl.interfaces.api.model import Model

G = 9.81
TEXT = """\
model Cart
  parameter Mass M = 2 kg, m = 1 kg;
  parameter Length l = 0.5 m;
  input Force u;
  coordinate Length x;
  coordinate Angle a(start = 30 deg);
  gravity = {0, -9.81 m/s2};
  mass M at {x, 0};
  mass m at {x + l*sin(a), -l*cos(a)};
  force u on x;
  state Real s(start = 2);
  output Length tip = x + l*sin(a);
equation
  der(s) = -s/(1 s);
end Cart;
"""


@pytest.fixture(scope="module")
def model() -> Model:
    return lagdsl.compile(TEXT)


def test_names_in_order(model: Model) -> None:
    assert model.name == "Cart"
    assert model.coordinates == ["x", "a"]
    assert model.states == ["s"]
    assert model.parameters == ["M", "m", "l"]
    assert model.inputs == ["u"]
    assert model.outputs == ["tip"]
    assert model.constraints == []
    assert model.redundant == []
    assert repr(model) == "<Model Cart: x, a, s>"
    np.testing.assert_array_equal(model.defaults, [2, 1, 0.5])


def _mass_matrix(a: float, M: float = 2, m: float = 1, l: float = 0.5) -> np.ndarray:
    return np.array([[M + m, m * l * np.cos(a)], [m * l * np.cos(a), m * l**2]])


def test_equations_of_motion(model: Model) -> None:
    q, qd, u = np.array([0.1, 0.4]), np.array([0.2, -0.3]), [5.0]
    force = np.array([5.0 + 0.5 * np.sin(0.4) * 0.09, -G * 0.5 * np.sin(0.4)])
    mass = _mass_matrix(0.4)
    np.testing.assert_allclose(model.mass_matrix(0.0, q), mass)
    qdd = model.forward_dynamics(0.0, q, qd, u=u)
    np.testing.assert_allclose(qdd, np.linalg.solve(mass, force))
    np.testing.assert_allclose(model.inverse_dynamics(0.0, q, qd, qdd, u=u), 0, atol=1e-12)
    np.testing.assert_allclose(model.inverse_dynamics(0.0, q, qd, [0.0, 0.0]), [5.0, 0.0] - force)
    np.testing.assert_allclose(model.output(0.0, q, qd), [0.1 + 0.5 * np.sin(0.4)])
    assert model.multipliers(0.0, q, qd).shape == (0,)
    assert model.constraint_jacobian(0.0, q).shape == (0, 2)
    kinetic = 0.5 * qd @ mass @ qd
    np.testing.assert_allclose(model.energy(0.0, q, qd), kinetic - G * 0.5 * np.cos(0.4))


def test_leading_axes_broadcast(model: Model) -> None:
    angles = np.linspace(-1, 1, 6).reshape(2, 3)
    q = np.stack([np.zeros_like(angles), angles], axis=-1)
    assert model.forward_dynamics(0.0, q, np.zeros(2)).shape == (2, 3, 2)
    assert model.energy(np.zeros((4, 1, 1)), q, np.zeros(2)).shape == (4, 2, 3)
    matrices = model.mass_matrix(0.0, q)
    np.testing.assert_allclose(matrices[1, 2], _mass_matrix(1.0))
    heavier = model.mass_matrix(0.0, q[0, 0], p=[[3, 1, 0.5], [4, 1, 0.5]])
    np.testing.assert_allclose(heavier[:, 0, 0], [4, 5])
    assert model.state_jacobian(0.0, q, np.zeros(2)).shape == (2, 3, 5, 5)


def test_the_state_jacobian_holds_states(model: Model) -> None:
    jacobian = model.state_jacobian(0.0, [0.0, 0.0], [0.0, 0.0])
    np.testing.assert_allclose(jacobian[:2, 2:4], np.eye(2))
    np.testing.assert_allclose(jacobian[4], [0, 0, 0, 0, -1])


@pytest.mark.parametrize(
    "arguments", [([0.0], [0.0, 0.0]), ([0.0, 0.0], [0.0]), (0.0, 0.0)], ids=["q too short", "qd too short", "scalars"]
)
def test_arrays_of_a_wrong_length_are_refused(model: Model, arguments: tuple[object, object]) -> None:
    with pytest.raises(ValueError, match="2 entries"):
        model.forward_dynamics(0.0, *arguments)  # type: ignore[arg-type]


def test_the_c_engine_gives_the_same(model: Model) -> None:
    compiled = lagdsl.compile(TEXT, engine="c")
    q, qd = [[0.1, 0.4], [0.2, -0.7]], [0.2, -0.3]
    np.testing.assert_allclose(compiled.forward_dynamics(0, q, qd), model.forward_dynamics(0, q, qd), rtol=1e-13)


def test_the_textbook_route_gives_the_same(model: Model) -> None:
    symbolic = lagdsl.compile(TEXT, derivation="textbook")
    q, qd = [0.1, 0.4], [0.2, -0.3]
    np.testing.assert_allclose(symbolic.forward_dynamics(0, q, qd), model.forward_dynamics(0, q, qd), rtol=1e-12)


def test_equations_in_symbols(model: Model) -> None:
    equations = model.equations
    assert equations.mass_matrix.shape == (2, 2)
    assert model.equations is equations


def test_initial_state(model: Model) -> None:
    state = model.initial_state(start={"x": 3.0, "der(a)": 0.5, "s": 1.0})
    np.testing.assert_allclose(state.q, [3.0, np.radians(30)])
    np.testing.assert_allclose(state.qd, [0.0, 0.5])
    np.testing.assert_allclose(state.z, [1.0])


def test_simulation(model: Model) -> None:
    motion = model.simulate(stop=1.0, interval=0.1, inputs={"u": lambda t: 3.0 * t}, parameters={"l": 0.7})
    assert motion.names == ("time", "x", "a", "der(x)", "der(a)", "s", "tip")
    np.testing.assert_allclose(motion["s"], 2 * np.exp(-motion.time), rtol=1e-6)
    np.testing.assert_allclose(motion["tip"], motion["x"] + 0.7 * np.sin(motion["a"]))
    momentum = 3 * motion["der(x)"] + 0.7 * np.cos(motion["a"]) * motion["der(a)"]
    np.testing.assert_allclose(momentum, 1.5 * motion.time**2, atol=1e-6)


def test_a_motion_has_a_figure_and_a_frame(model: Model, tmp_path: Path) -> None:
    motion = model.simulate(stop=0.5)
    assert isinstance(motion, lagdsl.Trajectory)
    motion.plot(tmp_path / "a.png")
    assert (tmp_path / "a.png").stat().st_size > 1000
    assert list(motion.to_dataframe().columns) == list(motion.names)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"parameters": {"mm": 1}}, "no parameter `mm`; there are M, m, l"),
        ({"start": {"der(aa)": 1}}, r"no start value `der\(aa\)`; did you mean `der\(a\)`"),
    ],
)
def test_unknown_names_are_told(model: Model, options: dict[str, dict[str, float]], words: str) -> None:
    with pytest.raises(KeyError, match=words):
        model.simulate(**options)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"parameters": {"m": float("nan")}}, "`m` must be a finite number"),
        ({"parameters": {"m": "heavy"}}, "m=heavy: expected a number with or without a unit"),
        ({"parameters": {"m": -1.0}}, "`m` must be at least 0 kg, not -1 kg"),
        ({"start": {"a": float("inf")}}, "`a` must be a finite number"),
    ],
)
def test_values_that_do_not_fit_are_refused(model: Model, options: dict[str, dict[str, float]], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        model.simulate(**options)  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=words):
        model.initial_state(**options)  # type: ignore[arg-type]


def test_kinds_of_parameters() -> None:
    model = lagdsl.compile(
        """model M
             parameter Boolean on = true;
             parameter Integer n = 2;
             parameter Real share(max = 1) = 0.5;
             coordinate Length x;
             mass 1 kg at {x, 0};
             force if on then n*share*(1 N) else 0 on x;
           end M;"""
    )
    assert model.simulate(stop=1.0, parameters={"on": True, "n": 3})["x"][-1] == pytest.approx(0.75)
    assert model.simulate(stop=1.0, parameters={"on": False})["x"][-1] == 0.0
    for values, words in (({"on": 2}, "true"), ({"n": 2.5}, "whole"), ({"share": 2}, "at most 1, not 2")):
        with pytest.raises(ValueError, match=words):
            model.simulate(parameters=values)


def test_inputs_from_a_file(model: Model, tmp_path: Path) -> None:
    table = tmp_path / "u.csv"
    table.write_text("time,u\n0,0\n1,3\n")
    from_file = model.simulate(stop=1.0, inputs=table)
    np.testing.assert_allclose(from_file["x"], model.simulate(stop=1.0, inputs={"u": lambda t: 3 * t})["x"], atol=1e-6)
    assert model.simulate(stop=1.0, inputs=str(table))["x"][-1] == from_file["x"][-1]
    with pytest.raises(lagdsl.CompilationFailed, match="cannot read the table"):
        model.simulate(inputs=tmp_path / "none.csv")


def test_engines_and_derivations_that_are_none() -> None:
    with pytest.raises(ValueError, match="no engine `rust`; there are auto, tape, c, numpy"):
        lagdsl.compile(TEXT, engine="rust")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="no derivation `guess`; there are graph, textbook"):
        lagdsl.compile(TEXT, derivation="guess")  # type: ignore[arg-type]


def test_constrained_models() -> None:
    model = lagdsl.compile(
        """model P
             parameter Length l = 0.5 m;
             coordinate Length x(start = l), y;
             gravity = {0, -9.81 m/s2};
             mass 2 kg at {x, y};
             constraint rod: x^2 + y^2 = l^2;
             constraint again: norm({x, y}) = l;
           end P;"""
    )
    assert model.constraints == ["rod", "again"]
    assert sorted(model.redundant) == [False, True]
    np.testing.assert_allclose(model.constraint_jacobian(0.0, [0.3, -0.4]), [[0.6, -0.8], [0.6, -0.8]])
    lam = model.multipliers(0.0, [0.0, -0.5], [2.0, 0.0])
    radial = -(2 * 4 / 0.5 + 2 * 9.81)  # the rod pulls: weight and centripetal force
    np.testing.assert_allclose(model.constraint_jacobian(0.0, [0.0, -0.5])[:, 1] @ lam, -radial)
    np.testing.assert_allclose(lam[0], lam[1])  # least norm shares equally between equal rows


def test_failures_are_told_with_time_and_motion() -> None:
    model = lagdsl.compile(
        """model M
             coordinate Length h(start = 1);
             gravity = {0, -10 m/s2};
             mass 1 kg at {0, h};
           equation
             assert(h > 0.8 m, "low");
           end M;"""
    )
    with pytest.raises(lagdsl.SimulationFailed, match="low") as caught:
        model.simulate(stop=1.0)
    assert caught.value.time == pytest.approx(0.2, abs=0.1)
    assert caught.value.trajectory["h"][-1] < 1.0
    assert caught.value.trajectory.plot() is not None


def test_discretes_are_an_argument() -> None:
    text = """model Buffer
      parameter Length play = 0.1 m;
      coordinate Length x, h(start = 1 m);
      discrete Force F(start = 3);
      kinetic 1/2*(1 kg)*(der(x)^2 + der(h)^2);
      contact floor: h >= 0 with restitution = 0.5;
      force F - (if x > play then (1000 N/m)*(x - play) else 0) on x;
      force -1 N on h;
    equation
      when sample(1 s, 1 s) then
        F = 0;
      end when;
    end Buffer;"""
    model = lagdsl.compile(text)
    assert model.discretes[:4] == ["F", "closed(floor)", "impacts(floor)", "x > play"]
    q = np.array([[0.0, 1.0], [0.2, 0.0]])
    np.testing.assert_allclose(model.forward_dynamics(0.0, q, np.zeros(2)), [[3.0, -1.0], [-97.0, -1.0]])
    w = np.zeros(len(model.discretes))
    w[[0, 1]] = 5.0, 1.0
    np.testing.assert_allclose(model.forward_dynamics(0.0, q[1], np.zeros(2), w=w), [5.0, 0.0], atol=1e-12)
    event = model.simulate(stop=1.0).events[0]
    assert isinstance(event, lagdsl.Event) and (event.name, event.kind) == ("x > play", "true")
    assert event.time == pytest.approx(np.sqrt(2 * 0.1 / 3.0), abs=1e-9)


def test_structural_parameters(root: Path) -> None:
    model = lagdsl.compile(root / "models" / "chain.lag", structural={"N": 3})
    assert model.coordinates == ["q[1]", "q[2]", "q[3]"]


def test_every_public_name_is_there_and_documented() -> None:
    for name in lagdsl.__all__:
        assert getattr(lagdsl, name).__doc__
        assert name in dir(lagdsl)
    with pytest.raises(AttributeError, match="no attribute 'nonsense'"):
        _ = lagdsl.nonsense  # type: ignore[attr-defined]


class TestCheck:
    @pytest.mark.parametrize(
        ("source", "code"),
        [
            ("nowhere.lag", "E0133"),
            (Path(__file__).parent, "E0132"),
            ("a" * 5000, "E0134"),
            ("\0", "E0134"),
            (b"model M end M;", "E0134"),
            (None, "E0134"),
            (["model M end M;"], "E0134"),
            ("", "E0135"),
            ("  ", "E0135"),
            ("(" * 10_000 + ";", "E0100"),
        ],
        ids=range(10),
    )
    def test_whatever_it_is_given_it_tells(self, source: object, code: str) -> None:
        assert code in [d.code for d in lagdsl.check(source)]  # type: ignore[arg-type]

    def test_line_ends_of_all_systems(self) -> None:
        for end in ("\n", "\r\n", "\r"):
            assert [d for d in lagdsl.check(TEXT.replace("\n", end)) if d.severity == "error"] == []

    def test_a_sound_model(self, root: Path) -> None:
        assert [d for d in lagdsl.check(root / "models" / "pendulum.lag") if d.severity != "note"] == []
        assert lagdsl.check(str(root / "models" / "pendulum.lag")) == lagdsl.check(root / "models" / "pendulum.lag")

    @pytest.mark.parametrize("source", ["nowhere.lag", "", "model", "model M;\n", "\0;", "(" * 10_000 + "\n"])
    def test_bad_models_raise_nothing(self, source: str) -> None:
        assert any(d.severity == "error" for d in lagdsl.check(source))

    def test_compile_raises_with_all_of_it(self) -> None:
        text = "model M coordinate Length x; mass mm at {x, 0}; gravity = gg; end M;"
        with pytest.raises(lagdsl.CompilationFailed) as caught:
            lagdsl.compile(text)
        assert [d.code for d in caught.value.diagnostics] == ["E0201", "E0201"]
        assert "unknown name `mm`" in str(caught.value)


def test_the_derivation_in_symbols_has_the_events_of_the_model() -> None:
    """A ball that falls 5 m at 10 m/s2 and bounces with half its speed is at its top again after 1 s + 0.5 s."""
    text = """model Ball
      coordinate Length h(start = 5 m);
      discrete Integer hits(start = 0);
      gravity = {0, -10 m/s2};
      mass 1 kg at {0, h};
      contact floor: h >= 0 m with restitution = 0.5;
      force (if der(h) > 100 m/s then 1 N else 0 N) on h;
    equation
      when h < 1 m then
        hits = pre(hits) + 1;
      end when;
      annotation(experiment(StopTime = 1.5));
    end Ball;
    """
    motion = lagdsl.compile(text, derivation="textbook").simulate()
    assert motion["h"][-1] == pytest.approx(1.25, abs=1e-9)
    assert motion["der(h)"][-1] == pytest.approx(0.0, abs=1e-8)
    assert motion["hits"][-1] == 1.0


def test_initial_state_under_inputs_is_that_of_the_motion() -> None:
    """A spring of 2 N/m at rest: x = F/k."""
    pressed = lagdsl.compile(
        """
        model Pressed
          coordinate Length x;
          input Force F = 1;
          kinetic 1/2*(1 kg)*der(x)^2;
          potential 1/2*(2 N/m)*x^2;
          force F on x;
          initial equation
            der(x) = 0;
            der(der(x)) = 0;
        end Pressed;
        """,
        engine="tape",
    )
    inputs = {"F": ([0.0, 9.0], [6.0, 0.0])}
    np.testing.assert_allclose(pressed.initial_state(inputs={"F": "6 N"}).q, [3.0], rtol=1e-9)
    np.testing.assert_allclose(pressed.initial_state().q, [0.5], rtol=1e-9)
    np.testing.assert_array_equal(
        pressed.initial_state(inputs=inputs).q, pressed.simulate(stop=1, inputs=inputs)["x"][:1]
    )
