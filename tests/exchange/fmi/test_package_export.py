"""Whole FMUs: what is in them, that the same model gives the same bytes, that a failure leaves nothing."""

from __future__ import annotations

import csv
import io
import math
import os
import shutil
import subprocess
import sys
import zipfile
from base64 import b64decode
from pathlib import Path
from xml.etree import ElementTree

import fmpy
import pytest
from fmpy.model_description import read_build_description, read_model_description

from lagdsl.engines.runtime.building.platforms import PLATFORMS
from lagdsl.exchange.fmi import export as exporting
from lagdsl.exchange.fmi.export import export
from lagdsl.exchange.fmi.package import sources as source_texts
from lagdsl.exchange.fmi.package import toolchain as toolchains
from lagdsl.exchange.fmi.package import trial as trials
from lagdsl.exchange.fmi.package.archive import write_archive
from lagdsl.exchange.fmi.package.compile_objects import included
from lagdsl.foundation.diagnostics import CompilationFailed, Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import compile_flat, flatten_file, read

VERSIONS = (2, 3)
SPRING = """model Spring "A mass on a spring"
  parameter Mass m = 2 kg;
  parameter Stiffness k = 8 N/m;
  coordinate Length x(start = 0.5 m);
  gravity = 0;
  mass m at {x, 0};
  potential 1/2*k*x^2;
  annotation(experiment(StopTime = 3, Interval = 0.1, Tolerance = 1e-6));
end Spring;
"""
ROOT = Path(__file__).parents[3]


def compiled(text, name="spring.lag"):
    sink = Sink()
    flat = flatten_file(SourceFile(name, text), sink)
    assert flat is not None, sink.diagnostics
    compilation = compile_flat(flat, sink)
    assert compilation is not None, sink.diagnostics
    return compilation


@pytest.fixture(scope="module")
def spring():
    return compiled(SPRING)


@pytest.fixture(scope="module", params=VERSIONS)
def whole(request, spring, tmp_path_factory):
    path = tmp_path_factory.mktemp("spring") / f"Spring{request.param}.fmu"
    export(spring, path, version=request.param, source=SourceFile("spring.lag", SPRING))
    return request.param, path


def contents(path):
    with zipfile.ZipFile(path) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


# ---- contents --------------------------------------------------------------------------------------------------------


def test_the_folders_are_those_of_the_standards(whole):
    version, path = whole
    files = contents(path)
    expected = {
        "modelDescription.xml",
        "documentation/index.html",
        "documentation/licenses/license.txt",
        {2: "model.png", 3: "terminalsAndIcons/icon.png"}[version],
        "sources/buildDescription.xml",
        "sources/Spring_fmu.c",
        f"sources/lag/fmi{version}/fmi{version}.c",
        "extra/org.fmi-standard.fmi-ls-ref/fmi-ls-manifest.xml",
        "extra/org.fmi-standard.fmi-ls-ref/reference.csv",
        "extra/org.fmi-standard.fmi-ls-ref/reference.opt",
        "extra/org.fmi-standard.fmi-ls-ref/model/spring.lag",
    }
    assert expected <= set(files)
    assert {name.split("/")[0] for name in files} <= {
        *("modelDescription.xml", "model.png", "documentation", "sources", "binaries", "extra", "terminalsAndIcons"),
    }
    assert files["extra/org.fmi-standard.fmi-ls-ref/model/spring.lag"].decode() == SPRING
    assert not [name for name in files if "\\" in name or name.startswith("/") or ".." in name]


def test_the_motion_to_compare_with_is_that_of_the_model(whole):
    files = contents(whole[1])
    folder = "extra/org.fmi-standard.fmi-ls-ref"
    rows = list(csv.DictReader(io.StringIO(files[f"{folder}/reference.csv"].decode())))
    options = dict(line.split(", ") for line in files[f"{folder}/reference.opt"].decode().splitlines())
    assert float(options["StartTime"]) == 0.0
    assert float(options["StopTime"]) == 3.0
    assert float(options["RelTol"]) == 1e-8
    assert len(rows) == 31
    for row in rows:  # omega = sqrt(k/m) = 2
        t = float(row["time"])
        assert float(row["x"]) == pytest.approx(0.5 * math.cos(2 * t), abs=1e-7)
        assert float(row["der(x)"]) == pytest.approx(-math.sin(2 * t), abs=2e-7)


def test_people_read_the_derivation_and_the_licenses(whole):
    version, path = whole
    files = contents(path)
    page = files["documentation/index.html"].decode()
    assert "A mass on a spring" in page
    assert f"FMI {version}.0, Model Exchange and Co-Simulation" in page
    picture = b64decode(page.split("data:image/png;base64,")[1].split('"')[0])
    icon = files[{2: "model.png", 3: "terminalsAndIcons/icon.png"}[version]]
    for png in (picture, icon):
        assert png.startswith(b"\x89PNG")
        assert b"Software" not in png
    words = files["documentation/licenses/license.txt"].decode()
    assert (ROOT / "LICENSE").read_text(encoding="utf-8").strip() in words
    assert "Modelica Association Project" in words
    assert "OF THIS SOFTWARE, EVEN IF\nADVISED OF THE POSSIBILITY OF SUCH DAMAGE." in words


def test_the_build_description_names_every_c_file(whole):
    version, path = whole
    files = contents(path)
    configurations = read_build_description(str(path))
    own = {name.removeprefix("sources/") for name in files if name.endswith(".c")}
    for configuration in configurations:
        assert configuration.modelIdentifier == "Spring"
        (part,) = configuration.sourceFileSets
        read = {name for path in part.sourceFiles for name in included(files[f"sources/{path}"].decode())}
        assert set(part.sourceFiles).isdisjoint(read)
        assert {*part.sourceFiles, *(name for name in read if name.endswith(".c"))} == own
        assert part.language == "C11"
    other = 5 - version
    assert not [name for name in own if f"fmi{other}" in name]
    assert not [
        name for name in files if name.endswith(("Functions.h", "FunctionTypes.h", "Platform.h", "PlatformTypes.h"))
    ]
    root = ElementTree.fromstring(files["sources/buildDescription.xml"])
    platforms = [each.get("platform") for each in root]
    assert len(set(platforms)) == len(platforms) == len(configurations)
    assert None in platforms
    for each in root:
        wanted = (each.get("platform") or "").endswith(("-linux", "-darwin"))
        assert [library.get("name") for library in each.findall("Library")] == (["m"] if wanted else [])


@pytest.mark.skipif(shutil.which("cmake") is None, reason="cmake is not installed")
@pytest.mark.skipif(not os.environ.get("LAGDSL_EXPLORE"), reason="compiles everything anew: with LAGDSL_EXPLORE=1")
def test_an_importer_compiles_the_sources_and_simulates(whole, tmp_path):
    from fmpy.build import build_platform_binary

    _, path = whole
    folder = tmp_path / "unpacked"
    fmpy.extract(str(path), str(folder))
    shutil.rmtree(folder / "binaries")
    (tmp_path / "build").mkdir()
    build_platform_binary(folder, tmp_path / "build", all_warnings=True)
    for kind in ("CoSimulation", "ModelExchange"):
        found = fmpy.simulate_fmu(
            str(folder), fmi_type=kind, stop_time=1.0, output_interval=0.5, relative_tolerance=1e-8
        )
        assert found["x"][-1] == pytest.approx(0.5 * math.cos(2.0), abs=1e-5)


# ---- the same bytes --------------------------------------------------------------------------------------------------


def test_the_same_model_gives_the_same_bytes_in_another_process(whole, tmp_path):
    version, path = whole
    if version == 2:
        pytest.skip("one of the versions will do")
    script = (
        "import sys\nfrom pathlib import Path\n"
        "from lagdsl.foundation.diagnostics import Sink\nfrom lagdsl.exchange.fmi.export import export\n"
        "from lagdsl.exchange.fmi.package import toolchain\n"
        "from lagdsl.motion.pipeline import compile_flat, flatten_file\n"
        "from lagdsl.foundation.source import SourceFile\n"
        "toolchain.COMPILE = tuple(sys.argv[3:])\n"
        "text = SourceFile('spring.lag', sys.argv[1])\n"
        "export(compile_flat(flatten_file(text, Sink()), Sink()), Path(sys.argv[2]), version=3, source=text)\n"
    )
    again = tmp_path / "again.fmu"
    subprocess.run(
        [sys.executable, "-W", "ignore", "-c", script, SPRING, str(again), *toolchains.COMPILE],
        env={**os.environ, "PYTHONHASHSEED": "1", "PYTHONPATH": str(ROOT)},
        check=True,
    )
    assert again.read_bytes() == path.read_bytes()


def test_entries_have_an_order_and_no_time(tmp_path):
    path = tmp_path / "x.fmu"
    write_archive(path, {"b.so": b"2", "modelDescription.xml": b"1", "a.txt": b"3" * 1000})
    with zipfile.ZipFile(path) as archive:
        entries = archive.infolist()
        assert archive.testzip() is None
    assert [entry.filename for entry in entries] == ["modelDescription.xml", "a.txt", "b.so"]
    assert {entry.date_time for entry in entries} == {(1980, 1, 1, 0, 0, 0)}
    assert {entry.compress_type for entry in entries} == {zipfile.ZIP_DEFLATED}
    assert {(entry.extract_version, entry.flag_bits) for entry in entries} == {(20, 0)}  # FMI 3.0, section 2.5
    assert [entry.external_attr >> 16 & 0o777 for entry in entries] == [0o644, 0o644, 0o755]


# ---- choices ---------------------------------------------------------------------------------------------------------


def test_chosen_values_become_the_defaults(spring, tmp_path):
    path, plain = tmp_path / "chosen.fmu", tmp_path / "plain.fmu"
    export(spring, path, parameters={"m": 8.0}, start={"x": -1.0}, documented=False)
    export(spring, plain, documented=False)
    described, before = (read_model_description(str(each)) for each in (path, plain))
    starts = {variable.name: variable.start for variable in described.modelVariables}
    assert (float(starts["m"]), float(starts["k"]), float(starts["x"])) == (8.0, 8.0, -1.0)
    assert described.guid != before.guid
    found = fmpy.simulate_fmu(str(path), fmi_type="CoSimulation", stop_time=1.0, output_interval=1.0)
    assert found["x"][-1] == pytest.approx(-math.cos(1.0), abs=1e-5)  # omega = sqrt(8/8)


@pytest.mark.parametrize(("kind", "has"), [("me", (True, False)), ("cs", (False, True))])
def test_one_kind_alone(spring, kind, has, tmp_path):
    path = tmp_path / "one.fmu"
    export(spring, path, kinds=(kind,), documented=False)
    description = read_model_description(str(path))
    assert (description.modelExchange is not None, description.coSimulation is not None) == has


def test_without_documentation_there_is_the_text_all_the_same(spring, tmp_path):
    path = tmp_path / "bare.fmu"
    export(spring, path, documented=False, source=SourceFile("<text>", SPRING))
    names = set(contents(path))
    assert "extra/org.fmi-standard.fmi-ls-ref/model/model.lag" in names
    assert not [name for name in names if name.startswith("documentation") or name.endswith((".png", ".csv"))]


def test_packages_beside_the_model_go_along(tmp_path):
    package = tmp_path / "Springs"
    package.mkdir()
    (package / "package.lag").write_text('package Springs "Springs" end Springs;\n')
    body = SPRING.replace("model Spring ", "model Soft ").replace("end Spring;", "end Soft;")
    (package / "Soft.lag").write_text("within Springs;\n" + body)
    model = tmp_path / "mine.lag"
    model.write_text("model Mine\n  import Springs.Soft;\n  extends Soft;\nend Mine;\n")
    sink = Sink()
    source = read(model, sink)
    compilation = compile_flat(flatten_file(source, sink), sink)
    assert compilation is not None, sink.diagnostics
    path = tmp_path / "mine.fmu"
    export(compilation, path, documented=False, source=source)
    folder = "extra/org.fmi-standard.fmi-ls-ref/model/"
    found = {name.removeprefix(folder): text for name, text in contents(path).items() if name.startswith(folder)}
    assert set(found) == {"mine.lag", "Springs/Soft.lag", "Springs/package.lag"}
    unpacked = tmp_path / "unpacked"
    for name, text in found.items():
        (unpacked / name).parent.mkdir(parents=True, exist_ok=True)
        (unpacked / name).write_bytes(text)
    again = Sink()
    assert flatten_file(read(unpacked / "mine.lag", again), again) == compilation.flat


def test_progress_ends_with_all(spring, tmp_path):
    parts = []
    export(spring, tmp_path / "x.fmu", documented=False, progress=parts.append)
    assert parts == sorted(parts)
    assert parts[-1] == 1.0


def test_a_platform_that_there_is_not(spring, tmp_path):
    with pytest.raises(ValueError, match="there is no platform `atari`; there are linux-x86_64"):
        export(spring, tmp_path / "x.fmu", platforms=("atari",))


# ---- failures --------------------------------------------------------------------------------------------------------


def refused(spring, path, **options):
    """What is told, after looking that the file there was is still there, alone."""
    path.write_bytes(b"of yesterday")
    with pytest.raises(CompilationFailed) as failed:
        export(spring, path, documented=False, **options)
    assert path.read_bytes() == b"of yesterday"
    assert [each.name for each in path.parent.iterdir()] == [path.name]
    (diagnostic,) = failed.value.diagnostics
    return diagnostic


def with_texts(monkeypatch, change):
    """The description and the sources as `change` leaves them."""
    before = exporting.texts
    monkeypatch.setattr(exporting, "texts", lambda export_model: change(*before(export_model)))


def appended(sources, text):
    return {**sources, "Spring_fmu.c": sources["Spring_fmu.c"] + text}


def test_a_compiler_that_fails(spring, monkeypatch, tmp_path):
    with_texts(monkeypatch, lambda description, sources: (description, appended(sources, "\nnot C at all\n")))
    assert refused(spring, tmp_path / "x.fmu").code == "E0906"


def test_an_fmu_that_is_not_valid(spring, monkeypatch, tmp_path):
    with_texts(monkeypatch, lambda description, sources: (description.replace('name="x"', 'name="m"'), sources))
    diagnostic = refused(spring, tmp_path / "x.fmu")
    assert diagnostic.code == "E0907"
    assert any('"m"' in note for note in diagnostic.notes)


def test_an_fmu_that_does_not_start(spring, monkeypatch, tmp_path):
    def another_token(description, sources):
        return description.replace('guid="{', 'guid="{another'), sources

    with_texts(monkeypatch, another_token)
    diagnostic = refused(spring, tmp_path / "x.fmu")
    assert diagnostic.code == "E0908"
    assert "model exchange" in diagnostic.message


def test_an_fmu_that_crashes(spring, monkeypatch, tmp_path):
    crash = "\n__attribute__((constructor)) static void crash(void) { *(volatile int *)0 = 1; }\n"
    with_texts(monkeypatch, lambda description, sources: (description, appended(sources, crash)))
    diagnostic = refused(spring, tmp_path / "x.fmu")
    assert diagnostic.code == "E0908"
    assert "SIG" in diagnostic.message


def test_an_fmu_that_does_not_end(spring, monkeypatch, tmp_path):
    hang = "\n__attribute__((constructor)) static void hang(void) { for (volatile int i = 0;; i++) {} }\n"
    with_texts(monkeypatch, lambda description, sources: (description, appended(sources, hang)))
    monkeypatch.setattr(trials, "_PATIENCE", 0.5)
    diagnostic = refused(spring, tmp_path / "x.fmu")
    assert diagnostic.code == "E0908"
    assert "0.5 s" in diagnostic.message


def test_without_the_headers_of_the_standard(spring, monkeypatch, tmp_path):
    monkeypatch.setattr(source_texts.importlib.util, "find_spec", lambda name: None)
    diagnostic = refused(spring, tmp_path / "x.fmu")
    assert diagnostic.code == "E0904"
    assert "fmpy" in diagnostic.message


def test_without_a_compiler_for_the_platform(spring, monkeypatch, tmp_path):
    monkeypatch.setattr(toolchains, "zig_program", lambda: None)
    other = next(name for name in PLATFORMS if name != exporting.this_machine())
    assert refused(spring, tmp_path / "x.fmu", platforms=(other,)).code == "E0905"


def test_a_folder_that_is_not_there(spring, tmp_path):
    with pytest.raises(OSError, match="nowhere"):
        export(spring, tmp_path / "nowhere" / "x.fmu", documented=False)
