"""Artifacts of the backends are deterministic, self-contained, and safe against hostile names."""

from __future__ import annotations

import csv
import os
import shutil
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from choice import chosen, spread
from made_modules import PLAIN, SANITIZED, Made
from sample_programs import chain, closed_chain, pendulum, quaternion_body

from lagdsl.derivation.program.program import Program, Slot
from lagdsl.engines.backends.backend import Artifact
from lagdsl.engines.backends.c.literal import number, string
from lagdsl.engines.backends.identifier import comment_text, identifier
from lagdsl.engines.backends.registry import BACKENDS

HOSTILE = 'a"*/ #define x ??/\n\\end\u2603\'"""; import os'


def _write(artifact: Artifact, folder: Path) -> None:
    for path, text in artifact.files.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text, encoding="utf-8")


def _hostile() -> Program:
    program = pendulum(HOSTILE)
    slot = Slot(name=HOSTILE, unit=HOSTILE, place=HOSTILE)
    layout = replace(program.layout, coordinates=(slot,), parameters=(slot,) * 4, assertions=(HOSTILE, "x" * 9000))
    return replace(program, layout=layout)


def _imported(program: Program) -> ModuleType:
    (text,) = BACKENDS["numpy"].emit(program).files.values()
    module = ModuleType("generated")
    exec(compile(text, "generated", "exec", dont_inherit=True), module.__dict__)
    return module


# ---- bytes -----------------------------------------------------------------------------------------------------------

_DIGEST = """
import hashlib, sys
sys.path[:0] = sys.argv[1:]
from sample_programs import closed_chain, quaternion_body
from lagdsl.engines.backends.registry import BACKENDS
digest = hashlib.sha256()
for make in (closed_chain, quaternion_body):
    for backend in BACKENDS.values():
        for path, text in backend.emit(make()).files.items():
            digest.update(path.encode() + text.encode())
print(digest.hexdigest())
"""


def test_bytes_do_not_depend_on_the_hash_seed(root: Path) -> None:
    digests = set()
    for seed in ("0", "31337"):
        done = subprocess.run(
            [sys.executable, "-c", _DIGEST, str(root), str(root / "tests")],
            env={**os.environ, "PYTHONHASHSEED": seed},
            capture_output=True,
            text=True,
            check=True,
        )
        digests.add(done.stdout)
    assert len(digests) == 1


def test_artifacts_cannot_be_changed() -> None:
    artifact = BACKENDS["numpy"].emit(pendulum())
    with pytest.raises(TypeError):
        artifact.files["x"] = ""  # type: ignore[index]


# ---- C ---------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("compiler", chosen(["gcc", "clang"], ["gcc"]))
@pytest.mark.parametrize(
    "make", spread([pendulum, quaternion_body, lambda: closed_chain(2), lambda: chain(6), _hostile], 3)
)
def test_c_builds_with_its_own_makefile_without_a_warning(
    tmp_path: Path, made: Made, compiler: str, make: object
) -> None:
    if shutil.which(compiler) is None:
        pytest.skip(f"{compiler} is not installed")
    artifact = BACKENDS["c"].emit(make())  # type: ignore[operator]
    _write(artifact, tmp_path)
    done = made(tmp_path, "-j2", *(() if compiler == "gcc" else (f"CC={compiler}",)), f"CFLAGS={PLAIN}")
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.skipif(shutil.which("nm") is None, reason="nm is not installed")
def test_the_runtime_needs_no_operating_system(tmp_path: Path, made: Made) -> None:
    """Nothing but mathematics and the moving of memory, which every C compiler for a microcontroller has."""
    artifact = BACKENDS["c"].emit(pendulum())
    _write(artifact, tmp_path)
    assert made(tmp_path, "libPendulum.a", f"CFLAGS={PLAIN}").returncode == 0
    command = ["cc", "-r", "-nostdlib", "-o", "all.o", "-Wl,--whole-archive", "libPendulum.a"]
    subprocess.run(command, cwd=tmp_path, check=True, capture_output=True)
    listed = subprocess.run(["nm", "-u", "all.o"], cwd=tmp_path, check=True, capture_output=True, text=True).stdout
    known = {
        *("memcpy", "memset", "memmove", "_GLOBAL_OFFSET_TABLE_"),
        *("sqrt", "pow", "exp", "log", "log2", "ldexp", "hypot", "sin", "cos", "sincos"),
        *("fabs", "fmod", "fmax", "fmin", "nearbyint", "floor", "ceil"),
    }
    assert {line.split()[-1] for line in listed.splitlines()} <= known


def test_the_example_prints_accelerations_and_motion(tmp_path: Path, made: Made) -> None:
    _write(BACKENDS["c"].emit(pendulum()), tmp_path)
    assert made(tmp_path, f"CFLAGS={PLAIN}").returncode == 0
    program = str(tmp_path / "Pendulum")
    printed = subprocess.run([program], capture_output=True, text=True, check=True).stdout
    m, length, torque = 1.5, 0.7, 1.0
    expected = -9.80665 / length * np.sin(0.5) + torque / (m * length**2)
    name, value = printed.split(" = ")
    assert name == "der(der(theta))"
    assert float(value.split()[0]) == pytest.approx(expected, rel=1e-15)
    rows = list(
        csv.DictReader(
            subprocess.run([program, "1", "1e-3"], capture_output=True, text=True, check=True).stdout.splitlines()
        )
    )
    assert list(rows[0]) == ["time", "theta", "der(theta)", "z0", "y0", "y1"]
    assert len(rows) == 1001
    from scipy.integrate import solve_ivp

    def rates(_: float, x: np.ndarray) -> list[float]:
        theta, rate, z = x
        return [rate, -9.80665 / length * np.sin(theta) + (torque - 0.1 * z) / (m * length**2), (rate - z) / 0.3]

    reference = solve_ivp(rates, (0, 1), [0.5, 0, 0], rtol=1e-12, atol=1e-12).y[:, -1]
    state, outputs = np.split(np.array([float(x) for x in list(rows[-1].values())[1:]]), [3])
    np.testing.assert_allclose(state, reference, rtol=1e-9)
    np.testing.assert_allclose(outputs, [rates(0.0, state)[1], length * np.cos(state[0])], rtol=1e-14)


def test_the_loop_for_real_time_ends_where_the_motion_does(tmp_path: Path, made: Made) -> None:
    _write(BACKENDS["c"].emit(pendulum()), tmp_path)
    assert made(tmp_path, f"CFLAGS={PLAIN}").returncode == 0
    table = subprocess.run([str(tmp_path / "Pendulum"), "1", "1"], capture_output=True, text=True, check=True).stdout
    theta = float(table.splitlines()[-1].split(",")[1])
    for method, tolerance in (("rk4", 1e-9), ("leapfrog", 1e-5), ("ros2", 1e-5)):
        command = [str(tmp_path / "realtime"), "1", "1e-3", method]
        steps, end = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()
        assert steps.startswith("1000 steps of 0.001 s: mean ")
        assert float(end.split()[2]) == pytest.approx(theta, abs=tolerance)


def test_the_example_is_clean_under_sanitizers(tmp_path: Path, made: Made) -> None:
    _write(BACKENDS["c"].emit(quaternion_body("Body")), tmp_path)
    assert made(tmp_path, f"CFLAGS={SANITIZED}").returncode == 0
    done = subprocess.run([str(tmp_path / "Body"), "0.01", "1e-3"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert len(done.stdout.splitlines()) == 12


@pytest.mark.parametrize("folder", ["", "/home/somebody/", "C:\\models\\"])
def test_lines_tell_where_they_come_from_but_not_in_which_folder(folder: str) -> None:
    program = pendulum()
    slot = replace(program.layout.coordinates[0], place=f"{folder}pendulum.lag:4")
    moved = replace(program, layout=replace(program.layout, coordinates=(slot,)))
    text = BACKENDS["c"].emit(moved).files["Pendulum.c"]
    assert "/* pendulum.lag:4 */" in text
    assert text == BACKENDS["c"].emit(program).files["Pendulum.c"]


def test_numbers_read_back_and_strings_hold_only_plain_characters() -> None:
    for value in (0.1, -1e-300, 5e-324, 1.7976931348623157e308, 3.0):
        assert float(number(value).strip("()")) == value
    assert number(float("inf")) == "(double)INFINITY"
    assert number(float("-inf")) == "(-(double)INFINITY)"
    assert number(float("nan")) == "(double)NAN"
    assert string('a"\\?\n\u00e9') == '"a\\042\\134\\077\\012\\303\\251"'
    assert len(string("x" * 9000)) < 4096


def test_identifiers_and_comments() -> None:
    assert identifier("Cart.Pole", frozenset()) == "Cart_Pole"
    assert identifier("main", frozenset({"main"})) == "model_main"
    assert identifier("2link", frozenset()) == "model_2link"
    assert identifier("", frozenset()) == "model_"
    assert identifier("\u0394", frozenset()) == "model__"
    assert comment_text("a*/b\\\n//c.lag:3") == "a__b__" + "__c.lag:3"


# ---- NumPy -----------------------------------------------------------------------------------------------------------


def test_hostile_names_are_data_in_python() -> None:
    module = _imported(_hostile())
    assert module.NAME == HOSTILE
    assert module.COORDINATES == ((HOSTILE, HOSTILE),)
    assert not hasattr(module, "os")


def test_the_module_imports_numpy_and_the_standard_library_only(tmp_path: Path) -> None:
    _write(BACKENDS["numpy"].emit(pendulum()), tmp_path)
    probe = (
        "import sys, Pendulum; print(sorted(m for m in sys.modules if m.split('.')[0] in ('lagdsl', 'scipy', 'sympy')))"
    )
    done = subprocess.run([sys.executable, "-c", probe], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"


def test_functions_of_the_module_broadcast_and_tell_their_shapes() -> None:
    module = _imported(pendulum())
    q = np.linspace(-1, 1, 6).reshape(3, 2, 1)
    qdd = module.forward_dynamics(0.0, q, [0.0], u=[0.0])
    np.testing.assert_allclose(qdd, -9.80665 / 0.7 * np.sin(q), rtol=1e-14)
    p = np.array([[2.0, 0.5, 0.0, 1.0], [1.0, 0.25, 0.0, 1.0]])
    np.testing.assert_allclose(
        module.forward_dynamics(0.0, q, [0.0], u=[0.0], p=p)[:, 1], -9.80665 / 0.25 * np.sin(q[:, 1]), rtol=1e-14
    )
    assert module.mass_matrix(0.0, q).shape == (3, 2, 1, 1)
    assert module.constraint_jacobian(0.0, q).shape == (3, 2, 0, 1)
    assert module.multipliers(0.0, q, [0.0]).shape == (3, 2, 0)
    assert module.output([0.0, 1.0], q, [0.0]).shape == (3, 2, 2)
    assert module.energy(0.0, q, [1.0]).shape == (3, 2)
    assert module.state_jacobian(0.0, q, [0.0]).shape == (3, 2, 3, 3)
    assert module.parameter_jacobian(0.0, q, [0.0]).shape == (3, 2, 3, 4)
    assert module.output_jacobian(0.0, q, [0.0], by="input").shape == (3, 2, 2, 1)
    np.testing.assert_allclose(
        module.inverse_dynamics(0.0, q, [0.0], module.forward_dynamics(0.0, q, [0.0])), np.zeros((3, 2, 1)), atol=1e-14
    )
    assert "shape (..., nq)" in module.forward_dynamics.__doc__
    assert module.forward_dynamics(0.0, 0.3, 0.0).shape == (1,)


def test_wrong_lengths_and_singular_states_are_told() -> None:
    module = _imported(pendulum())
    with pytest.raises(ValueError, match="q must have 1 entries"):
        module.forward_dynamics(0.0, [1.0, 2.0], [0.0])
    with pytest.raises(ValueError, match="takes 2 arguments"):
        module.evaluate("start", 0.0)
    with pytest.raises(ValueError, match="p of start must have 4"):
        module.evaluate("start", 0.0, [1.0])
    with pytest.raises(module.SingularSystem) as caught:
        module.forward_dynamics(0.0, [[0.1], [0.2]], [0.0], p=[0.0, 1.0, 1.0, 1.0])
    assert caught.value.coordinate == 0


def test_no_coordinates_and_no_arguments() -> None:
    module = _imported(closed_chain())
    np.testing.assert_array_equal(module.forward_dynamics(0.0, np.zeros((0, 3)), [0.0] * 3).shape, (0, 3))
