"""Behavior that only a process of its own can show: pipes, interrupts, faults, streams."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from choice import chosen, spread

from lagdsl.interfaces.cli import main as module
from lagdsl.interfaces.cli.main import main

LAG = [sys.executable, "-m", "lagdsl"]
NEVER_READ = ["--help", "explain E0401", "flat models/chain.lag"]


def test_python_dash_m_is_the_command(pendulum: Path) -> None:
    done = subprocess.run([*LAG, "check", str(pendulum)], capture_output=True, text=True, check=False)
    assert done.returncode == 0
    assert done.stdout.startswith("Pendulum:")


def test_a_reader_that_goes_away_is_no_fault(pendulum: Path) -> None:
    command = f"{sys.executable} -m lagdsl run {pendulum} -o /dev/stdout | head -n 1"
    done = subprocess.run(["bash", "-c", command], capture_output=True, text=True, check=False)
    assert done.stdout == "time,theta,der(theta)\n"
    assert "Traceback" not in done.stderr
    assert "Error" not in done.stderr


@pytest.mark.parametrize("command", chosen(NEVER_READ, NEVER_READ[2:]))
def test_a_reader_that_never_reads_is_no_fault(root: Path, command: str) -> None:
    script = f"{sys.executable} -m lagdsl {command} | true; exit ${{PIPESTATUS[0]}}"
    done = subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=False, cwd=root)
    assert done.returncode == 0
    assert done.stderr == ""


@pytest.mark.skipif(os.name != "posix", reason="closes streams as shells of Unix do")
def test_closed_streams_are_no_fault(pendulum: Path, tmp_path: Path) -> None:
    for command, status in ((f"check {pendulum} >&-", 0), (f"check {tmp_path}/none.lag 2>&-", 2)):
        done = subprocess.run(["bash", "-c", f"{sys.executable} -m lagdsl {command}"], capture_output=True, check=False)
        assert done.returncode == status
        assert (done.stdout, done.stderr) == (b"", b"")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a device of Linux")
def test_a_standard_output_that_is_full_is_status_2(pendulum: Path) -> None:
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(
            [*LAG, "check", str(pendulum)], stdout=full, stderr=subprocess.PIPE, text=True, check=False
        )
    assert done.returncode == 2
    assert done.stderr == "cannot write standard output: No space left on device\n"


@pytest.mark.parametrize("moment", spread([0.01, 0.03], 1))
@pytest.mark.skipif(os.name != "posix", reason="signals of Unix")
def test_an_interrupt_while_modules_are_loaded(tmp_path: Path, moment: float) -> None:
    """There was a traceback of the import machinery."""
    (tmp_path / "sitecustomize.py").write_text(
        "import os, signal, sys, threading\nsignal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "class Watch:\n    def find_spec(self, name, path=None, target=None):\n"
        "        if name == 'lagdsl.interfaces.cli.main':\n"
        "            sys.meta_path.remove(self)\n"
        f"            later = threading.Timer({moment}, os.kill, (os.getpid(), signal.SIGINT))\n"
        "            later.daemon = True\n            later.start()\n"
        "sys.meta_path.insert(0, Watch())\n"
    )
    path = os.pathsep.join([str(tmp_path), str(Path(__file__).parents[3])])
    done = subprocess.run(
        [*LAG, "--help"],
        capture_output=True,
        text=True,
        check=False,
        stdin=subprocess.PIPE,
        env={**os.environ, "PYTHONPATH": path},
    )
    assert done.returncode in (0, 130) and "Traceback" not in done.stderr


def test_a_full_disk_leaves_no_part_of_a_new_model(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    def full(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(Path, "write_text", full)
    with pytest.raises(SystemExit) as left:
        main(["new", "Arm"])
    assert left.value.code == 2 and not list(tmp_path.iterdir())


@pytest.mark.skipif(not Path("/dev/stdout").exists(), reason="devices of Unix")
def test_standard_output_may_be_a_file(pendulum: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.txt"
    command = f"{sys.executable} -m lagdsl run {pendulum} --stop 0.1 -o /dev/stdout > {out}"
    assert subprocess.run(["bash", "-c", command], check=False).returncode == 0
    assert out.read_text().startswith("time,theta,der(theta)\n")


def test_no_color_where_nobody_looks(broken: Path) -> None:
    done = subprocess.run([*LAG, "check", str(broken)], capture_output=True, text=True, check=False)
    assert "\x1b" not in done.stderr


@pytest.mark.skipif(os.name != "posix", reason="named pipes of Unix")
def test_an_interrupt_is_status_130_and_leaves_no_file(pendulum: Path, tmp_path: Path) -> None:
    out, pipe = tmp_path / "out.csv", tmp_path / "inputs.csv"
    os.mkfifo(pipe)  # the run waits for its inputs until somebody writes them
    # A shell starts jobs of the background with interrupts ignored, and children inherit that.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    process = subprocess.Popen(
        [*LAG, "run", str(pendulum), "--input", str(pipe), "-o", str(out)],
        stderr=subprocess.PIPE,
        text=True,
    )
    with pipe.open("w"):
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate(timeout=60)
    assert process.returncode == 130
    assert errors.strip() == "interrupted"
    assert not out.exists()


@pytest.mark.skipif(os.name != "posix", reason="signals of Unix")
def test_an_interrupt_behind_the_last_words_changes_nothing(pendulum: Path) -> None:
    """The interpreter takes a moment to end, `lag fmu` two seconds; an interrupt then killed the process."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
    late = f"import atexit, os, signal; atexit.register(os.kill, os.getpid(), signal.SIGINT); {_AS_MAIN}"
    done = subprocess.run(
        [sys.executable, "-c", late, "check", str(pendulum)], capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr) == (0, "") and done.stdout.startswith("Pendulum:")


_AS_MAIN = "from lagdsl.__main__ import main; main()"


@pytest.mark.skipif(os.name != "posix", reason="sizes of files as Unix limits them")
def test_a_full_disk_leaves_the_text_as_it_was(tmp_path: Path) -> None:
    text = tmp_path / "m.lag"
    terms = "".join(f"  potential (1 N)*x*{k};\n" for k in range(300))
    written = f"model M\n   coordinate Length x;\nkinetic 1/2*(1 kg)*der(x)^2;\n{terms}end M;\n"
    text.write_text(written)
    command = f"ulimit -f 2; exec {sys.executable} -B -m lagdsl fmt {text}"
    done = subprocess.run(["bash", "-c", command], capture_output=True, text=True, check=False)
    assert done.returncode == 2 and done.stderr.startswith(f"Error: cannot write {text}: ")
    assert text.read_text() == written and list(tmp_path.iterdir()) == [text]


def _status(arguments: list[str]) -> int:
    with pytest.raises(SystemExit) as leaving:
        main(arguments)
    assert isinstance(leaving.value.code, int)
    return leaving.value.code


def test_statuses_of_the_whole_program(
    pendulum: Path, broken: Path, failing: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert _status(["check", str(pendulum)]) == 0
    assert _status(["check", str(broken)]) == 1
    assert _status(["check"]) == 2
    assert _status(["run", str(failing)]) == 3
    assert "Traceback" not in capsys.readouterr().err


@pytest.mark.parametrize(
    ("fault", "status", "words"),
    [
        (KeyboardInterrupt(), 130, "interrupted"),
        (RuntimeError("boom"), 70, "internal error: RuntimeError: boom"),
        (SystemExit(1), 0, ""),
        (OSError(28, "No space left on device"), 2, "cannot write standard output: No space left on device"),
        (OSError(13, "Permission denied", "x"), 70, "internal error"),
    ],
)
def test_what_goes_wrong_inside(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    fault: BaseException,
    status: int,
    words: str,
) -> None:
    def fail(**_: object) -> None:
        raise fault

    monkeypatch.setattr(module.lag, "main", fail)
    monkeypatch.setattr(module, "_silence_standard_output", lambda: None)
    assert _status([]) == status
    assert words in capsys.readouterr().err


def test_a_closed_pipe_inside(monkeypatch: pytest.MonkeyPatch) -> None:
    silenced: list[bool] = []

    def fail(**_: object) -> None:
        raise BrokenPipeError

    monkeypatch.setattr(module.lag, "main", fail)
    monkeypatch.setattr(module, "_silence_standard_output", lambda: silenced.append(True))
    assert _status([]) == 0
    assert silenced


@pytest.mark.skipif(os.name != "posix", reason="pseudo-terminals of Unix")
def test_a_terminal_gets_a_sketch(pendulum: Path) -> None:
    import pty

    master, slave = pty.openpty()
    environment = {**os.environ, "TERM": "xterm", "COLUMNS": "100"}
    process = subprocess.Popen(
        [*LAG, "run", str(pendulum), "--stop", "20"],
        stdout=slave,
        stderr=slave,
        env=environment,
    )
    os.close(slave)
    written = b""
    try:
        while chunk := os.read(master, 65536):
            written += chunk
    except OSError:  # Linux says so when the other end is closed
        pass
    os.close(master)
    assert process.wait() == 0
    text = written.decode("utf-8", "replace")
    assert any("\u2801" <= character <= "\u28ff" for character in text)
    assert text.count(f"lag show {pendulum} opens the machine") == 1
