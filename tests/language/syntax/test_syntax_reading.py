"""Reading files: what is no model text is told, and nothing more than the limit is read."""

import os
from pathlib import Path

import pytest

from lagdsl.foundation import resources
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.diagnostics.render import render_all
from lagdsl.language.semantics.classes.library import read_source
from lagdsl.language.syntax import limits
from lagdsl.language.syntax.parser import parse


def read(path: Path) -> tuple[str | None, list[str]]:
    sink = Sink()
    file = read_source(path, sink)
    assert str(path).replace("\0", "\\x00")[:40] in render_all(sink.diagnostics) or file is not None
    assert all(d.help for d in sink.diagnostics)
    return (None if file is None else file.text), [d.code for d in sink.diagnostics]


@pytest.mark.parametrize(
    ("content", "text"),
    [
        (b"model M\nend M;\n", "model M\nend M;\n"),
        (b"model M\r\nend M;\r\n", "model M\nend M;\n"),
        (b"model M\rend M;\r", "model M\nend M;\n"),
        (b"\xef\xbb\xbfmodel M end M;", "model M end M;"),
        ("// θ\n".encode(), "// θ\n"),
        (b"", ""),
    ],
)
def test_texts(tmp_path, content, text):
    path = tmp_path / "m.lag"
    path.write_bytes(content)
    assert read(path) == (text, [])


@pytest.mark.parametrize(
    ("content", "code"),
    [
        (b"model M \xff end M;", "E0131"),
        (b"\xff\xfem\0o\0d\0e\0l\0", "E0131"),
        (b"model M\0 end M;", "E0136"),
        (b" " * (4 * limits.MAX_CHARACTERS + 1), "E0130"),
    ],
)
def test_no_texts(tmp_path, content, code):
    path = tmp_path / "m.lag"
    path.write_bytes(content)
    assert read(path) == (None, [code])


def test_places_that_are_no_files(tmp_path):
    assert read(tmp_path) == (None, ["E0132"])
    assert read(tmp_path / "none.lag") == (None, ["E0133"])
    assert read(tmp_path / "none" / "none.lag") == (None, ["E0133"])
    assert read(tmp_path / ("x" * 5000)) == (None, ["E0134"])
    assert read(Path("nul\0byte.lag")) == (None, ["E0134"])
    (tmp_path / "file").write_text("x")
    assert read(tmp_path / "file" / "below.lag") == (None, ["E0134"])


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("pendulun.lag", "pendulum.lag"),
        ("Pendulum.lag", "pendulum.lag"),
        ("pendulum", "pendulum.lag"),
        ("pendulum.mo", "pendulum.lag"),
        ("four_ba.lag", "four_bar.lag"),
        ("crane.lag", None),
        ("notes.lag", None),
    ],
)
def test_a_file_that_does_not_exist_names_the_nearest_one_beside_it(tmp_path, typed, meant):
    for name in ("pendulum.lag", "four_bar.lag", "note.txt"):
        (tmp_path / name).write_text("")
    sink = Sink()
    assert read_source(tmp_path / typed, sink) is None
    [told] = sink.diagnostics
    proposed = f"did you mean `{tmp_path / meant}`?" if meant else "check the name; `lag new NAME` makes a first model"
    assert (told.code, told.help) == ("E0133", proposed)


def test_endless_device():
    assert read(Path("/dev/zero"))[1] == ["E0130"]


def test_unreadable(tmp_path, monkeypatch):
    path = tmp_path / "m.lag"
    path.write_text("model M end M;")

    def refuse(*_args, **_more):
        raise PermissionError(13, os.strerror(13))

    monkeypatch.setattr(Path, "open", refuse)
    assert read(path) == (None, ["E0134"])


def test_text_that_is_short_in_characters_counts_characters(tmp_path):
    """The limit is in characters: a text of two bytes a character is read, then it is the parser that counts."""
    path = tmp_path / "m.lag"
    path.write_text("θ" * (limits.MAX_CHARACTERS + 1), encoding="utf-8")
    sink = Sink()
    file = read_source(path, sink)
    assert file is not None and parse(file, sink) is None
    assert [d.code for d in sink.diagnostics] == ["E0130"]


def test_resources_of_a_checkout():
    assert resources.grammar_file().is_file()
    assert resources.library_folder().name == "stdlib"
    assert resources.diagnostics_folder().parts[-2:] == ("docs", "diagnostics")
    assert resources.c_folder().parts[-2:] == ("runtime", "c")


def test_resources_of_a_wheel(tmp_path, monkeypatch):
    for name in ("grammar", "stdlib", "diagnostics"):
        (tmp_path / "_data" / name).mkdir(parents=True)
    monkeypatch.setattr(resources, "_PACKAGE", tmp_path)
    assert resources.grammar_file() == tmp_path / "_data" / "grammar" / "lagdsl.lark"
    assert resources.library_folder() == tmp_path / "_data" / "stdlib"
    assert resources.diagnostics_folder() == tmp_path / "_data" / "diagnostics"
