"""Exported models in importers of others (`make fmu-check`); skipped, with a message, where one is not installed.

Python packages stand in an environment of their own (`make peers`, or PEERS=folder of a virtual environment), programs
on the path or in the folders of FMI_CLIENTS.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

import fmpy
import numpy as np
import pytest

from fmi.exported import VERSIONS, Exported, exported
from fmi.importing import exchanged
from fmi.motions import SAME, SAME_NEAR_EVENTS, Floats, deviation, model, motion, signals, span

CLIENTS = Path(__file__).parent / "clients"
PEERS = Path(os.environ.get("PEERS", ".peers")) / "bin" / "python"
pytestmark = pytest.mark.skipif(not os.environ.get("LAGDSL_EXPLORE"), reason="takes minutes: make fmu-check")
BOTH = pytest.mark.parametrize("version", VERSIONS)
NAMES = (
    "double_pendulum",
    "four_bar",
    "pendulum_two_dependent_constraints",
    "rolling_coin",
    "newtons_cradle",
    "furuta_swing_up",
    "clutch",
    "van_der_pol",
    "library/parts_with_play",
    "servo_drive",
    "library/ladder_filter",  # coordinates that are no states
)
MODELS = pytest.mark.parametrize("name", NAMES)
SMOOTH = (
    "double_pendulum",
    "four_bar",
    "pendulum_two_dependent_constraints",
    "rolling_coin",
    "cart_double_pendulum",
    "chain",
    "van_der_pol",
    "servo_drive",
    "library/ladder_filter",
)
ROWS = 50


def record(**found: Any) -> None:
    """A line of the table in docs/reference/fmi.md, to the file that FMI_RESULTS names."""
    if path := os.environ.get("FMI_RESULTS"):
        with Path(path).open("a", encoding="utf-8") as file:
            file.write(json.dumps(found) + "\n")


# ---- clients in Python -----------------------------------------------------------------------------------------------


@cache
def has(package: str) -> bool:
    if not PEERS.exists():
        return False
    return subprocess.run([PEERS, "-c", f"import {package}"], capture_output=True, check=False).returncode == 0


def ask(client: str, package: str, scratch: Path, **request: Any) -> dict[str, Any]:
    if not has(package):
        pytest.skip(f"{package} is not installed in {PEERS.parents[1]}")
    asked, told = scratch / "asked.json", scratch / "told.json"
    asked.write_text(json.dumps(request))
    done = subprocess.run(
        [PEERS, CLIENTS / f"{client}_client.py", asked, told], capture_output=True, text=True, check=False, timeout=300
    )
    assert done.returncode == 0, (done.stdout + done.stderr)[-3000:]
    answered: dict[str, Any] = json.loads(told.read_text())
    return answered


def scalars(fmu: Exported, name: str) -> list[str]:
    """Real signals that are variables of their own: some of these importers know no arrays."""
    found = [signal for signal in signals(motion(name)) if signal in fmu.variables]
    return [signal for signal in found if fmu.variables[signal].type in ("Real", "Float64")]


def step_of(name: str) -> float:
    """Of a whole number of microseconds: libcosim counts nanoseconds."""
    start, stop, _ = span(name)
    assert start == 0.0
    return round((stop - start) / ROWS * 1e6) * 1e-6


def assert_close(name: str, time: Sequence[float], columns: dict[str, Floats]) -> float:
    """Against a run with a row at each of these times."""
    reference = model(name).simulate(stop=float(time[-1]), interval=step_of(name), tolerance=1e-8)
    off = deviation(reference, np.asarray(time), columns, tuple(columns))
    assert len(off.time) >= ROWS
    assert not off.first(SAME, SAME_NEAR_EVENTS), off.first(SAME, SAME_NEAR_EVENTS)
    return float(np.max(off.error[~off.near], initial=0.0))


@MODELS
def test_libcosim(name: str, tmp_path: Path) -> None:
    fmu = exported(name, 2)
    names = scalars(fmu, name)
    assert names
    told = ask("libcosim", "libcosimpy", tmp_path, fmu=str(fmu.path), variables=names, step=step_of(name), count=ROWS)
    error = assert_close(name, told["time"], dict(zip(names, np.array(told["rows"]).T, strict=True)))
    record(importer="libcosimpy", version=told["version"], fmi=2, kind="cs", model=name, error=error)


@MODELS
@BOTH
def test_ecos(name: str, version: int, tmp_path: Path) -> None:
    fmu = exported(name, version, scalar=version == 3)
    names = scalars(fmu, name)
    told = ask("ecos", "ecospy", tmp_path, fmu=str(fmu.path), variables=names, step=step_of(name), count=ROWS)
    error = assert_close(name, told["time"], dict(zip(names, np.array(told["rows"]).T, strict=True)))
    record(importer="ecospy", version=told["version"], fmi=version, kind="cs", model=name, error=error)


@MODELS
@BOTH
def test_fmuloader(name: str, version: int, tmp_path: Path) -> None:
    fmu = exported(name, version, scalar=version == 3)
    names = scalars(fmu, name)
    told = ask(
        "fmuloader",
        "fmuloader",
        tmp_path,
        fmu=str(fmu.path),
        version=version,
        stem=fmu.description.coSimulation.modelIdentifier,
        token=fmu.description.guid or fmu.description.instantiationToken,
        references=[fmu.variables[signal].valueReference for signal in names],
        step=step_of(name),
        count=ROWS,
    )
    error = assert_close(name, told["time"], dict(zip(names, np.array(told["rows"]).T, strict=True)))
    record(importer="fmuloader", version=told["version"], fmi=version, kind="cs", model=name, error=error)


def of_toolbox(program: str, *arguments: str, folder: Path) -> str:
    """Output of a program of the FMU Manipulation Toolbox."""
    if not has("fmu_manipulation_toolbox"):
        pytest.skip(f"fmu-manipulation-toolbox is not installed in {PEERS.parents[1]}")
    done = subprocess.run(
        [PEERS.parent.absolute() / program, *arguments],
        capture_output=True,
        text=True,
        check=False,
        cwd=folder,
        timeout=300,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout + done.stderr


@MODELS
@BOTH
def test_checks_of_the_manipulation_toolbox(name: str, version: int, tmp_path: Path) -> None:
    said = of_toolbox("fmutool", "-input", str(exported(name, version).path), "-check", folder=tmp_path)
    assert f"This FMU seems to be compliant with FMI-{version}.0" in said
    assert f"No semantic error against the FMI-{version} standard" in said
    assert "ERROR" not in said and "WARNING" not in said


@pytest.mark.parametrize("name", [name for name in NAMES if name not in ("newtons_cradle", "library/parts_with_play")])
def test_a_container_of_the_manipulation_toolbox(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """An FMU that holds ours, in FMPy. Containers of FMI 2 take no arrays, not even those listed entry by entry."""
    fmu = exported(name, 2)
    shutil.copy(fmu.path, tmp_path / "one.fmu")
    options: dict[str, Any] = dict.fromkeys(("mt", "profiling", "sequential", "auto_input", "auto_parameter"), False)
    options |= dict.fromkeys(("auto_link", "auto_output"), True) | {"auto_local": False}
    options |= {key: [] for key in ("input", "output", "drop", "link", "start")}
    described = {"name": "container.fmu", "step_size": step_of(name), "fmu": ["one.fmu"], **options}
    (tmp_path / "container.json").write_text(json.dumps(described))
    of_toolbox("fmucontainer", "-fmu-directory", ".", "-container", "container.json", folder=tmp_path)
    names = [signal for signal in scalars(fmu, name) if fmu.variables[signal].causality == "output"]
    rows = fmpy.simulate_fmu(
        str(tmp_path / "container.fmu"),
        fmi_type="CoSimulation",
        stop_time=ROWS * step_of(name),
        output_interval=step_of(name),
        step_size=step_of(name),
        relative_tolerance=1e-8,
        output=names,
    )
    capsys.readouterr()
    error = assert_close(name, rows["time"], {signal: rows[signal] for signal in names})
    record(importer="fmu-manipulation-toolbox", version="", fmi=2, kind="cs", model=name, error=error)


@pytest.mark.parametrize("name", SMOOTH)
@BOTH
def test_casadi(name: str, version: int, tmp_path: Path) -> None:
    """Right-hand sides, the Jacobian that CasADi assembles from few directions by the pattern, and a motion."""
    fmu = exported(name, version, scalar=version == 3)
    states = [item.variable.derivative.name for item in fmu.description.derivatives]
    rates = [item.variable.name for item in fmu.description.derivatives]
    given = [v for v in fmu.variables.values() if v.causality == "input" and v.variability == "continuous"]
    inputs, values = [v.name for v in given], [float(v.start) for v in given]
    random = np.random.default_rng(1)
    with exchanged(fmu) as one:
        one.initialize()
        one.update()
        start = one.states
        points = [[0.0, (start + k * 0.1 * random.normal(size=len(start))).tolist(), values] for k in range(4)]
        step = step_of(name)
        told = ask(
            "casadi",
            "casadi",
            tmp_path,
            folder=str(fmu.folder),
            states=states,
            inputs=inputs,
            points=points,
            step=step,
            count=ROWS,
        )
        pattern, worst = np.array(told["pattern"]), 0.0
        for (t, x, _), ode, jacobian in zip(points, told["ode"], told["jacobian"], strict=True):
            one.move(t, np.array(x))
            np.testing.assert_array_equal(ode, one.derivatives)
            units = np.eye(len(states) + len(inputs))
            ours = np.array([one.directional(rates, [*states, *inputs], unit) for unit in units]).T
            entries = np.abs(ours) > 1e-18 * np.max(np.abs(ours), axis=1, keepdims=True)  # smaller ones cancel
            assert np.all(pattern[entries] == 1.0)
            error = np.max(np.abs(np.array(jacobian) - ours)) / np.max(np.abs(ours))
            worst = max(worst, float(error))
            assert error <= 1e-12
            if len(states) == 2 * len(model(name).coordinates) and not model(name).constraints:
                n = len(states) // 2
                analytic = model(name).state_jacobian(t, x[:n], x[n:])
                np.testing.assert_allclose(
                    np.array(jacobian)[:, : 2 * n], analytic, atol=1e-11 * np.max(np.abs(analytic))
                )
    found = dict(zip(states, np.array(told["rows"]).T, strict=True))
    error = assert_close(name, told["time"], found)
    record(importer="CasADi", version=told["version"], fmi=version, kind="me", model=name, error=error, jacobian=worst)


# ---- fmi-sim ---------------------------------------------------------------------------------------------------------


def program(name: str) -> str:
    folders = os.pathsep.join([os.environ.get("FMI_CLIENTS", ""), os.environ["PATH"]])
    found = shutil.which(name, path=folders)
    if found is None:
        pytest.skip(f"{name} is not on the path (or in FMI_CLIENTS)")
    return found


def run(command: Sequence[str | Path], **options: Any) -> str:
    done = subprocess.run(
        [str(c) for c in command], capture_output=True, text=True, check=False, timeout=300, **options
    )
    assert done.returncode == 0, (done.stdout + done.stderr)[-3000:]
    return done.stdout


def fmi_sim(fmu: Exported, folder: Path, step: float, count: int, *kind: str) -> tuple[Floats, dict[str, Floats]]:
    """Time, and the outputs that it writes."""
    table = folder / "out.csv"
    arguments = ["--step", repr(step), "--output-interval", repr(step), "-f", repr(step * count), "--tolerance", "1e-8"]
    run([program("fmi-sim"), "--model", readable(fmu, folder), "-o", table, *kind, *arguments])
    header = table.read_text().splitlines()[0].split(",")
    rows = np.loadtxt(table, delimiter=",", skiprows=1)
    return rows[:, 0], dict(zip(header[1:], rows[:, 1:].T, strict=True))


@pytest.mark.parametrize("name", ["clutch", "library/parts_with_play", "bead_on_cosine_wire", "slider_crank"])
@BOTH
@pytest.mark.parametrize("mode", [(), ("--event-mode-used", "--early-return-allowed")], ids=["steps", "event mode"])
def test_fmi_sim(name: str, version: int, mode: tuple[str, ...], tmp_path: Path) -> None:
    if version == 2 and mode:
        pytest.skip("FMI 2 has no event mode in co-simulation")
    time, columns = fmi_sim(exported(name, version), tmp_path, step_of(name), ROWS, "cs", *mode)
    assert columns
    error = assert_close(name, time.tolist(), columns)
    importer = version_of_fmi_sim()
    record(importer="fmi-sim", version=importer, fmi=version, kind="cs", model=name, mode=bool(mode), error=error)


@pytest.mark.parametrize("name", ["bead_on_cosine_wire", "slider_crank"])
@BOTH
def test_fmi_sim_by_eulers_method(name: str, version: int, tmp_path: Path) -> None:
    """Its only method for model exchange: half the step, half the error."""
    fmu, errors = exported(name, version), []
    stop = step_of(name)
    for count in (1000, 2000):
        time, columns = fmi_sim(fmu, tmp_path, stop / count, count, "me")
        assert time[-1] == pytest.approx(stop, rel=1e-9)
        reference = model(name).simulate(stop=stop, tolerance=1e-10)
        errors.append(max(float(np.abs(c[-1] - reference[n][-1]) / _size(reference[n])) for n, c in columns.items()))
    assert errors[0] < 1e-2
    assert 0.9 <= np.log2(errors[0] / errors[1]) <= 1.1
    importer = version_of_fmi_sim()
    record(importer="fmi-sim", version=importer, fmi=version, kind="me", model=name, error=errors[1])


@cache
def version_of_fmi_sim() -> str:
    """It ends with status 1 when it has told its version."""
    done = subprocess.run([program("fmi-sim"), "--version"], capture_output=True, text=True, check=False)
    return (done.stdout + done.stderr).splitlines()[0].split()[-1]


def readable(fmu: Exported, folder: Path) -> Path:
    """For FMI 3 a copy without attributes of the standard that the parser of fmi-sim does not know."""
    if fmu.version == 2:
        return fmu.path
    copy = folder / fmu.path.name
    with zipfile.ZipFile(fmu.path) as given, zipfile.ZipFile(copy, "w") as taken:
        for item in given.infolist():
            data = given.read(item)
            if item.filename == "modelDescription.xml":
                text = re.sub(r"<ModelVariables>.*</ModelVariables>", _known, data.decode(), flags=re.DOTALL)
                data = text.encode()
            taken.writestr(item, data)
    return copy


def _known(variables: re.Match[str]) -> str:
    return re.sub(r' (unit|displayUnit|quantity|nominal|unbounded)="[^"]*"', "", variables[0])


def _size(values: Floats) -> float:
    return float(np.max(np.abs(values)))


# ---- binaries of other platforms -------------------------------------------------------------------------------------

TARGETS = {
    "linux-x86_64": ("x86_64-linux-gnu.2.17", {2: "linux64", 3: "x86_64-linux"}, ".so", ""),
    "linux-aarch64": ("aarch64-linux-gnu.2.17", {2: "aarch64-linux", 3: "aarch64-linux"}, ".so", "qemu-aarch64"),
    "windows-x86_64": ("x86_64-windows-gnu", {2: "win64", 3: "x86_64-windows"}, ".dll", "wine"),
}


@cache
def host(platform: str, folder: Path) -> Path:
    pytest.importorskip("ziglang", reason="ziglang compiles the hosts of other platforms")
    target, _, _, _ = TARGETS[platform]
    headers = Path(fmpy.__file__).parent / "c-code"
    path = folder / f"host-{platform}{'.exe' if 'windows' in platform else ''}"
    libraries = [] if "windows" in platform else ["-ldl"]
    source = CLIENTS / "host.c"
    run(
        [
            sys.executable,
            "-m",
            "ziglang",
            "cc",
            "-target",
            target,
            "-O1",
            f"-I{headers}",
            source,
            "-o",
            path,
            *libraries,
        ]
    )
    return path


def printed(platform: str, fmu: Exported, name: str, folder: Path) -> Floats:
    """Rows of time and values, as the binary for that platform gives them."""
    _, folders, ending, runner = TARGETS[platform]
    before = [program(runner)] if runner else []
    if runner == "qemu-aarch64":
        before += ["-L", os.environ.get("QEMU_LD_PREFIX", "/usr/aarch64-linux-gnu")]
    identifier = fmu.description.coSimulation.modelIdentifier
    library = fmu.folder / "binaries" / folders[fmu.version] / (identifier + ending)
    references = [str(fmu.variables[n].valueReference) for n in scalars(fmu, name)]
    stop, token = span(name)[1], fmu.description.guid or fmu.description.instantiationToken
    arguments = [library, str(fmu.version), token, fmu.folder.as_uri(), repr(stop), "40", *references]
    text = run([*before, host(platform, folder), *arguments], env={**os.environ, "WINEDEBUG": "-all"})
    return np.array([[float.fromhex(word) for word in line.split()] for line in text.split("\n") if line.strip()])


@pytest.mark.parametrize("platform", ["linux-aarch64", "windows-x86_64"])
@pytest.mark.parametrize("name", ["double_pendulum", "four_bar", "ball_on_moving_table", "clutch", "van_der_pol"])
@BOTH
def test_other_platforms(platform: str, name: str, version: int, tmp_path_factory: pytest.TempPathFactory) -> None:
    """The same to 1e-9 of the size of each signal as on this machine."""
    program(TARGETS[platform][-1])
    folder = tmp_path_factory.getbasetemp() / "hosts"
    folder.mkdir(exist_ok=True)
    fmu = exported(name, version, ("linux-x86_64", platform))
    expected, found = (printed(p, fmu, name, folder) for p in ("linux-x86_64", platform))
    assert expected.shape == found.shape == (41, 1 + len(scalars(fmu, name)))
    error = np.max(np.abs(found - expected) / np.maximum(np.max(np.abs(expected), axis=0), 1e-9))
    assert error <= 1e-9
    record(importer=TARGETS[platform][-1], version="", fmi=version, kind="cs", model=name, error=float(error))
