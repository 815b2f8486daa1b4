"""Every feature of `lag lsp`, asked for by an editor of a real process."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from choice import chosen
from lsp_editor import Editor
from lsp_texts import FOUR_BAR, PENDULUM
from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException

from lagdsl.interfaces.lsp.features.tokens import LEGEND


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("workspace")


@pytest.fixture(scope="module")
def editor(folder: Path) -> Iterator[Editor]:
    made = Editor(folder)
    yield made
    made.close()


@pytest.fixture(scope="module")
def pendulum(editor: Editor, folder: Path) -> str:
    (folder / "pendulum.lag").write_text(PENDULUM)
    return editor.open((folder / "pendulum.lag").as_uri(), PENDULUM)


@pytest.fixture(scope="module")
def four_bar(editor: Editor, folder: Path) -> str:
    return editor.open((folder / "four_bar.lag").as_uri(), FOUR_BAR)


def _labels(found: lsp.CompletionList) -> set[str]:
    return {item.label for item in found.items}


def _text(found: lsp.Hover | None) -> str:
    assert found is not None
    assert isinstance(found.contents, lsp.MarkupContent)
    return found.contents.value


# ---- diagnostics -----------------------------------------------------------------------------------------------------


def test_a_sound_text_has_no_diagnostics(editor: Editor, pendulum: str) -> None:
    assert editor.diagnostics_of(pendulum) == []


def test_a_fault_is_told_at_its_place_and_goes_away(editor: Editor, folder: Path) -> None:
    wrong = PENDULUM.replace("mass m at", "mass l at")
    uri = editor.open((folder / "wrong.lag").as_uri(), wrong)
    (found, *_) = [each for each in editor.diagnostics_of(uri) if each.severity == lsp.DiagnosticSeverity.Error]
    assert found.code is not None
    assert found.range.start.line == wrong[: wrong.index("mass l at")].count("\n")
    editor.change(uri, PENDULUM)
    assert editor.diagnostics_of(uri) == []


def test_a_broken_statement_does_not_silence_the_others(editor: Editor, folder: Path) -> None:
    text = PENDULUM.replace("gravity = {0, -9.81 m/s2};", "gravity = {0, -9.81 m/s2;").replace("sin(theta)", "sin(m)")
    uri = editor.open((folder / "broken.lag").as_uri(), text)
    lines = {each.code: each.range.start.line for each in editor.diagnostics_of(uri)}
    assert lines["E0402"] == text[: text.index("sin(m)")].count("\n")
    assert set(lines) == {"E0402", "E0111"}


def test_faults_behind_the_equations_follow(editor: Editor, folder: Path) -> None:
    text = FOUR_BAR.replace("r = {1 m, 0}", "r = {5 m, 0}")
    uri = editor.open((folder / "impossible.lag").as_uri(), text)
    found = editor.diagnostics_of(uri, having="E0602")
    assert all(each.source == "lag" for each in found)


def test_a_version_that_a_key_has_overtaken_is_not_told(editor: Editor, folder: Path) -> None:
    uri = editor.open((folder / "overtaken.lag").as_uri(), "")
    editor.diagnostics_of(uri)
    for length in range(1, 40):
        editor.change(uri, PENDULUM[:length])
    last = editor.change(uri, PENDULUM)
    assert editor.diagnostics_of(uri) == []
    assert [version for (other, version) in editor.times if other == uri] == [1, last]


@pytest.mark.parametrize("before", ["θ̈", "🙂"])
def test_columns_count_units_of_utf_16(editor: Editor, folder: Path, before: str) -> None:
    """Neovim offers UTF-8 first, Emacs UTF-32: all of them know UTF-16."""
    assert editor.offers.position_encoding == lsp.PositionEncodingKind.Utf16
    text = f"model A\n  /* {before} */ parameter Mass m = 1 kgg;\nend A;\n"
    uri = editor.open((folder / f"{ord(before[0])}.lag").as_uri(), text)
    (found,) = [each for each in editor.diagnostics_of(uri) if each.severity == lsp.DiagnosticSeverity.Error]
    ahead = text[text.index("\n") + 1 : text.index("kgg")]
    assert found.range.start == lsp.Position(1, len(ahead.encode("utf-16-le")) // 2)


# ---- hover -----------------------------------------------------------------------------------------------------------


def test_a_hover_has_declaration_value_and_doc(editor: Editor, pendulum: str) -> None:
    editor.diagnostics_of(pendulum)
    text = _text(editor.about("hover", pendulum, PENDULUM, "{|l*sin"))
    assert "parameter Length l = 0.5 m" in text
    assert "`l = 0.5 m`" in text
    text = _text(editor.about("hover", pendulum, PENDULUM, "sin(th|eta"))
    assert "from the downward vertical" in text
    assert "60 deg" in text


def test_a_coordinate_shows_its_equation(editor: Editor, four_bar: str, folder: Path) -> None:
    editor.diagnostics_of(four_bar, having="N0701")
    uri = editor.open((folder / "equation.lag").as_uri(), PENDULUM.replace("Pendulum", "Equation"))
    editor.ask_until(lambda: "equation" in _text(editor.about("hover", uri, PENDULUM, "sin(th|eta")))
    assert "θ̈" in _text(editor.about("hover", uri, PENDULUM, "sin(th|eta"))


def test_a_name_that_connect_merged_tells_the_coordinate_it_is(editor: Editor, folder: Path) -> None:
    text = """model Shaft
  import Lag.Rotational.*;
  Rotor motor(J = 2 kg.m2, phi(start = 5 deg)), load(J = 1 kg.m2);
  Spring shaft(k = 6 N.m/rad);
  connect(motor.phi, shaft.phi_a);
  connect(shaft.phi_b, load.phi);
  output Angle twist = shaft.phi_a - shaft.phi_b;
end Shaft;
"""
    uri = editor.open((folder / "shaft.lag").as_uri(), text)
    editor.diagnostics_of(uri)
    told = _text(editor.about("hover", uri, text, "= shaft.ph|i_a"))
    assert "`shaft.phi_a` is `motor.phi`: `connect` makes them one coordinate" in told
    assert "`motor.phi` [rad], starts at `5 deg`" in told


@pytest.mark.parametrize(
    ("mark", "words"),
    [
        ("coord|inate", "a generalized coordinate"),
        ("Ang|le", "deg"),
        ("si|n(", "sin"),
        ("star|t =", "value at the start"),
        ("mass| m at", "a point mass"),
        ("mod|el Pendulum", "end Name;"),
        ("60 d|eg", "`1 deg = 0.01745329252 rad`"),
    ],
)
def test_words_of_the_language_show_the_manual(editor: Editor, pendulum: str, mark: str, words: str) -> None:
    assert words in _text(editor.about("hover", pendulum, PENDULUM, mark))


def test_a_member_of_a_component_shows_its_value(editor: Editor, four_bar: str) -> None:
    editor.diagnostics_of(four_bar)
    text = _text(editor.about("hover", four_bar, FOUR_BAR, "torque tau on A.|q"))
    assert "turn of frame_b against frame_a" in text
    assert "60 deg" in text


# ---- completion ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("typed", "some", "none"),
    [
        ("  gravity = -g_n*world.", {"x", "y", "origin", "rotz"}, {"m", "parameter"}),
        ("  parameter Length r = 5 ", {"m", "mm", "rad"}, {"theta"}),
        ("  parameter ", {"Mass", "Length", "Link"}, {"theta", "mm"}),
        ("  Link link(", {"l", "m"}, {"frame_c", "theta"}),
        ("  Revolute hinge(q(", {"start", "fixed"}, {"l"}),
        ("  coordinate Angle q(", {"start", "fixed", "der"}, {"l"}),
        ("  import Lag.", {"Planar", "Spatial", "Electrical"}, {"theta"}),
        ("  torque ", {"theta", "m", "sin", "pi"}, {"Planar", "mm"}),
        ("  ", {"coordinate", "mass", "connect", "Mass", "theta"}, {"mm"}),
        ("  torque 1 N.m on hinge.", {"q", "frame_a", "tau"}, {"theta"}),
        ("  annotation(", {"experiment", "page", "units"}, {"start", "theta"}),
        ("  annotation(page(", {"sliders", "curves"}, {"Tolerance", "theta"}),
        ("  annotation(page(sliders = {", {"theta"}, {"curves"}),
        ("  annotation(experiment(StopTime = 3, ", {"Tolerance", "Interval"}, {"start", "theta"}),
        ("  body b(", {"m", "com", "Izz"}, {"start", "theta"}),
        ("  body b(m = ", {"theta"}, {"com", "start"}),
        ("  draw ", {"rod", "sphere", "mesh"}, {"theta", "reaction"}),
        ("  draw box(", {"size", "color"}, {"theta", "radius"}),
        ("  draw rod(radius = 1 cm) from ", {"world", "m"}, {"radius", "rod"}),
        ("  contact c: l >= 0 m with ", {"restitution", "compliance"}, {"theta"}),
        ("  contact c: l >= 0 m with restitution = ", {"theta"}, {"compliance"}),
        ("  friction f: der(theta) with ", {"limit", "sticking"}, {"theta", "restitution"}),
        ("  friction f: der(theta) with limit = ", {"theta"}, {"sticking"}),
        ("  contact c: l >= 0 m with restitution = 0, ", {"friction", "slip", "sticking"}, {"theta", "limit"}),
        (
            "  contact c: l >= 0 with restitution = 0, friction = 1, slip = der(theta);\n"
            "  output Force F = multiplier(c.",
            {"friction"},
            {"theta"},
        ),
        ("  import Lag.Planar.{Link, ", {"Revolute", "Body"}, {"Lag", "theta"}),
        ("  output Force F[3] = reaction(hinge).", {"force", "torque"}, {"theta"}),
        ("  frame A = hinge.frame_b.rotz(theta).", {"move", "origin"}, {"theta"}),
        ("  point P = hinge.frame_b.origin.", {"x", "y", "z"}, {"rotz", "theta"}),
        ('  parameter Real k "', set(), {"theta"}),
        ("  // ", set(), {"theta"}),
    ],
)
def test_completion_offers_what_fits(editor: Editor, folder: Path, typed: str, some: set[str], none: set[str]) -> None:
    known = PENDULUM.replace("  parameter Mass", "  import Lag.Planar.*;\n  Revolute hinge;\n  parameter Mass", 1)
    text = known.replace("end Pendulum;", f"{typed}\nend Pendulum;")
    name = f"complete{abs(hash(typed))}.lag"
    uri = editor.open((folder / name).as_uri(), text)
    found = editor.about("completion", uri, text, f"{typed}|\nend Pendulum;")
    assert some <= _labels(found)
    assert not none & _labels(found)


def test_a_class_of_the_library_is_resolved_with_its_ports(editor: Editor, folder: Path) -> None:
    text = "model A\n  import Lag.Planar.\nend A;\n"
    uri = editor.open((folder / "resolve.lag").as_uri(), text)
    found = editor.about("completion", uri, text, "Planar.|")
    item = next(each for each in found.items if each.label == "Revolute")
    page = editor.ask("completionItem/resolve", item).documentation.value
    assert "frame_a" in page
    assert "coordinate" in page


def test_a_statement_is_a_snippet(editor: Editor, folder: Path) -> None:
    text = "model A\n  \nend A;\n"
    uri = editor.open((folder / "snippet.lag").as_uri(), text)
    found = editor.about("completion", uri, text, "model A\n  |")
    item = next(each for each in found.items if each.label == "coordinate")
    assert item.insert_text_format == lsp.InsertTextFormat.Snippet


def test_signature_help_counts_the_arguments(editor: Editor, folder: Path) -> None:
    text = 'function f(Real x, Real y) -> Real = x*y "a product";\n'
    text += "model A\n  Real z = f(1, 2);\n  Real w = atan2(1, 2);\nend A;\n"
    uri = editor.open((folder / "signature.lag").as_uri(), text)
    found = editor.about("signatureHelp", uri, text, "f(1, |2)")
    assert found.signatures[0].label == "f(Real x, Real y) -> Real"
    assert found.active_parameter == 1
    assert found.signatures[0].documentation.value == "a product"
    assert editor.about("signatureHelp", uri, text, "atan2(|1").signatures[0].label.startswith("atan2(")
    assert editor.about("signatureHelp", uri, text, "model |A") is None


# ---- names -----------------------------------------------------------------------------------------------------------


def test_definition_in_the_text_and_in_the_library(editor: Editor, four_bar: str) -> None:
    own = editor.about("definition", four_bar, FOUR_BAR, "connect(world, A, |crank")
    assert own.uri == four_bar
    assert own.range.start.line == FOUR_BAR[: FOUR_BAR.index("Link crank")].count("\n")
    library = editor.about("definition", four_bar, FOUR_BAR, "Rev|olute A")
    assert library.uri.endswith("/Lag/Planar/Revolute.lag")
    inherited = editor.about("definition", four_bar, FOUR_BAR, "A(|q(start")
    assert inherited.uri.endswith("/Lag/Planar/Revolute.lag")
    kind = editor.about("typeDefinition", four_bar, FOUR_BAR, "connect(world, A, |crank")
    assert kind.uri.endswith("/Lag/Planar/Link.lag")


def test_references_and_rename_go_across_files(editor: Editor, folder: Path) -> None:
    part = "model Arm\n  parameter Length size = 1 m;\n  Length twice = 2*size;\nend Arm;\n"
    user = "model User\n  import Arm;\n  Arm arm(size = 2 m);\n  output Length s = arm.size;\nend User;\n"
    (folder / "Arm.lag").write_text(part)
    (folder / "User.lag").write_text(user)
    arm = editor.open((folder / "Arm.lag").as_uri(), part)
    used = editor.open((folder / "User.lag").as_uri(), user)
    context = lsp.ReferenceContext(include_declaration=True)
    found = editor.about("references", used, user, "arm.si|ze", context=context)
    assert sorted((each.uri, each.range.start.line) for each in found) == [(arm, 1), (arm, 2), (used, 2), (used, 3)]
    assert len(editor.about("documentHighlight", used, user, "arm.si|ze")) == 2
    edit = editor.about("rename", used, user, "arm.si|ze", new_name="length")
    assert {uri: len(edits) for uri, edits in edit.changes.items()} == {arm: 2, used: 2}
    with pytest.raises(JsonRpcException, match="word of the language"):
        editor.about("rename", arm, part, "2*si|ze", new_name="end")
    with pytest.raises(JsonRpcException, match="another meaning"):
        editor.about("rename", arm, part, "2*si|ze", new_name="twice")


def test_what_is_imported_is_read_as_the_editor_holds_it(editor: Editor, folder: Path) -> None:
    """A rename changes two open texts: neither is wrong before both are saved; a broken text is one's own affair."""
    part = "model Leg\n  parameter Length size = 1 m;\n  Length twice = 2*size;\nend Leg;\n"
    user = "model Walker\n  import Leg;\n  Leg leg(size = 2 m);\n  output Length s = leg.twice;\nend Walker;\n"
    (folder / "Leg.lag").write_text(part)
    leg, used = (folder / "Leg.lag").as_uri(), (folder / "Walker.lag").as_uri()
    editor.open(leg, part)
    editor.open(used, user)

    def errors() -> list[str]:
        found = editor.diagnostics_of(used)
        return [str(each.code) for each in found if each.severity == lsp.DiagnosticSeverity.Error]

    before = errors()
    editor.change(leg, part.replace("size", "length"))
    editor.ask_until(lambda: "E0223" in errors())
    editor.change(used, user.replace("size", "length"))
    editor.ask_until(lambda: errors() == before)
    editor.change(leg, part.replace("size", "length").replace("2*", "2**"))
    assert [each.code for each in editor.diagnostics_of(leg)] == ["E0100"]
    assert errors() == before
    editor.tell("textDocument/didClose", lsp.DidCloseTextDocumentParams(lsp.TextDocumentIdentifier(leg)))
    editor.ask_until(lambda: "E0223" in errors())


def test_what_the_library_declares_keeps_its_name(editor: Editor, four_bar: str) -> None:
    with pytest.raises(JsonRpcException, match="in the library"):
        editor.about("prepareRename", four_bar, FOUR_BAR, "Rev|olute A")


def test_symbols(editor: Editor, four_bar: str) -> None:
    identifier = lsp.TextDocumentIdentifier(four_bar)
    (model,) = editor.ask("textDocument/documentSymbol", lsp.DocumentSymbolParams(identifier))
    assert model.name == "FourBar"
    assert {"crank", "A", "tau", "pinC"} <= {each.name for each in model.children}
    found = editor.ask("workspace/symbol", lsp.WorkspaceSymbolParams("frbr"))
    assert "FourBar" in {each.name for each in found}


# ---- the text --------------------------------------------------------------------------------------------------------


def test_semantic_tokens_cover_the_words(editor: Editor, pendulum: str) -> None:
    identifier = lsp.TextDocumentIdentifier(pendulum)
    data = editor.ask("textDocument/semanticTokens/full", lsp.SemanticTokensParams(identifier)).data
    lines, line, column, words = PENDULUM.split("\n"), 0, 0, {}
    for down, on, length, kind, _ in zip(*[iter(data)] * 5, strict=True):
        line, column = line + down, on if down else column + on
        words[lines[line][column : column + length]] = LEGEND.token_types[kind]
    assert words["coordinate"] == "keyword"
    assert words["Pendulum"] == "class"
    assert words["theta"] == "property"
    assert words["60 deg"] == "number"
    assert words["sin"] == "function"
    assert words["m"] == "parameter"


def test_folding_and_formatting(editor: Editor, folder: Path) -> None:
    text = "model A\n coordinate Angle q;\n   mass 1 kg at {1 m*sin(q),\n   0};\nend A;\n"
    uri = editor.open((folder / "format.lag").as_uri(), text)
    identifier = lsp.TextDocumentIdentifier(uri)
    ranges = editor.ask("textDocument/foldingRange", lsp.FoldingRangeParams(identifier))
    assert {(each.start_line, each.end_line) for each in ranges} == {(0, 3), (2, 3)}
    options = lsp.FormattingOptions(tab_size=2, insert_spaces=True)
    (edit,) = editor.ask("textDocument/formatting", lsp.DocumentFormattingParams(identifier, options))
    assert edit.new_text == "  coordinate Angle q;\n  mass 1 kg at {1 m*sin(q), 0};\n"
    assert (edit.range.start.line, edit.range.end.line) == (1, 4)


def test_hints_tell_freedom_redundancy_and_units(editor: Editor, folder: Path) -> None:
    text = FOUR_BAR.replace("output Force pinC", "output Real power = tau*der(A.q);\n  output Force pinC")
    uri = editor.open((folder / "hints.lag").as_uri(), text)
    editor.diagnostics_of(uri, having="N0701")
    whole = lsp.Range(lsp.Position(0, 0), lsp.Position(99, 0))
    found = editor.ask("textDocument/inlayHint", lsp.InlayHintParams(lsp.TextDocumentIdentifier(uri), whole))
    labels = {each.label: each.position for each in found}
    assert labels["1 degree of freedom"] == lsp.Position(0, len("model FourBar"))
    assert "3 redundant rows" in labels
    assert "[W]" in labels


ROW = """model Row
  gravity = 0;
  coordinate Length x[2](each start = 0.1 m);
  mass 1 kg at {x[1], x[2]};
end Row;
"""


@pytest.mark.parametrize(
    ("sound", "right", "wrong", "title"),
    [
        (PENDULUM, "l*sin(theta)", "l*sin(thet)", "write `theta`"),
        (PENDULUM, "at {l*sin", "at {1 + l*sin", "write `1 m`"),
        (PENDULUM, "kg;", "kg, n = 2 kg;", "delete `, n = 2 kg`"),
        (PENDULUM, "kg;", "kg", "insert `;`"),
        (PENDULUM, "m = 1 kg", "m = 1,0 kg", "write `1.0 kg`"),
        (PENDULUM, "m = 1 kg", "m := 1 kg", "write `=`"),
        (ROW, "each start", "start", "write `each start = 0.1 m`"),
    ],
)
def test_an_action_writes_what_the_help_proposes(
    editor: Editor, folder: Path, sound: str, right: str, wrong: str, title: str
) -> None:
    text = sound.replace(right, wrong)
    uri = editor.open((folder / f"action{wrong.encode().hex()}.lag").as_uri(), text)
    (found, *_) = editor.diagnostics_of(uri)
    params = lsp.CodeActionParams(
        lsp.TextDocumentIdentifier(uri), found.range, lsp.CodeActionContext(diagnostics=[found])
    )
    (action,) = editor.ask("textDocument/codeAction", params)
    assert action.title == title
    (edit,) = action.edit.changes[uri]
    start, end = (_offset(text, each) for each in (edit.range.start, edit.range.end))
    editor.change(uri, text[:start] + edit.new_text + text[end:])
    assert editor.diagnostics_of(uri) == []


def _offset(text: str, place: lsp.Position) -> int:
    return sum(len(line) + 1 for line in text.split("\n")[: place.line]) + place.character


LENSES = {"run": "der(theta)", "derive": "<math", "verify": "order of the steps"}


@pytest.mark.parametrize("word", chosen(LENSES, ["run", "derive"]))
def test_lenses_do_what_they_say(editor: Editor, pendulum: str, word: str) -> None:
    found = editor.ask("textDocument/codeLens", lsp.CodeLensParams(lsp.TextDocumentIdentifier(pendulum)))
    assert [each.command.title for each in found] == ["run", "show", "derive", "verify"]
    (command,) = (each.command for each in found if each.command.title == word)
    address = editor.ask(
        "workspace/executeCommand", lsp.ExecuteCommandParams(command.command, arguments=command.arguments)
    )
    assert address in [each.uri for each in editor.shown_documents]
    said = Path(address.removeprefix("file://")).read_text()
    assert "Pendulum" in said
    assert LENSES[word] in said
    assert "error" not in said


def test_files_beside_a_text_are_read_when_they_are_asked_for(editor: Editor, folder: Path) -> None:
    """A library of wrong files in the folder costs nothing and says nothing, until a text names it."""
    library = folder / "Wrong"
    library.mkdir()
    (library / "package.lag").write_text("package Wrong\nend Wrong;\n")
    (library / "Broken.lag").write_text("component Broken coordinate end")
    uri = editor.open((folder / "lazy.lag").as_uri(), PENDULUM)
    assert editor.diagnostics_of(uri) == []
    editor.change(uri, PENDULUM.replace("end Pendulum", "  Wrong.Broken b;\nend Pendulum"))
    assert [each.severity for each in editor.diagnostics_of(uri)][:1] == [lsp.DiagnosticSeverity.Error]
