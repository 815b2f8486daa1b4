"""The glossary names every function that users call, and names that exist; other words than the field's are to go."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

import lagdsl
from lagdsl.derivation.program.functions import FUNCTIONS

ROOT = Path(__file__).parents[2]

# A word of ours and the field's word for it. A name is that of a file, a function, a class, a C type or a status,
# without `lag_` and `LAG_`.
BANNED = {
    "typed_bodies": "body_recognition",
    "typed_weights": "gravity_recognition",
    "own_vectors": "body_frame_vectors",
    "own_accelerations": "body_frame_accelerations",
    "stiffening": "mass_augmentation",
    "carriers": "inertial_elements",
    "vanishing": "zero_test",
    "structure_newton": "levenberg_marquardt",
    "descent": "levenberg_marquardt",
    "provided": "builtin_quantities",
    "surplus": "redundant_multipliers",
    "coasting": "bias_rate",
    "minimized": "pivoted",
    "swapped": "exchanged",
    "shallow": "reassociate",
    "roll": "reroll",
    "departure": "singular_crossing",
    "fitted": "singular_crossing",
    "saddle": "branch_point",
    "passes": "event_iteration",
    "happening": "event",
    "happenings": "events",
    "alert": "guard",
    "beginning": "initialization",
    "saving": "serialization",
    "snapshots": "fmu_state",
    "nonnegative": "nnls",
    "radau_turn": "radau_gmres",
    "rarely": "cold",
    "courses": "inputs",
    "faults": "messages",
    "observing": "variables",
    "slopes": "directional_derivatives",
    "moving": "continuous_states",
    "knowledge": "parameter_use",
    "subject": "export_model",
    "refusals": "capability_checks",
    "mentions": "dependencies",
    "switched": "conditional_components",
    "splitting": "array_modifiers",
    "stuck": "step_too_small",
    "off": "projection_failed",
    "happens": "event_pending",
    "torn": "position_jump",
    "foreign": "bad_state_data",
    "timeless": "bad_clock",
}
# Names that still have such a word, until they are renamed. Nothing may be added here.
NOT_YET_RENAMED: frozenset[str] = frozenset()

NAME = re.compile(
    r"^\s*(?:def|class) (\w+)"  # Python
    r"|\b(?:struct|enum) lag_(\w+)"  # C types
    r"|^(?:static )?[a-z_]+ \*?(?:lag_)?(\w+)\("  # C functions
    r"|\bLAG_(\w+)",  # statuses
    re.MULTILINE,
)


@cache
def sources() -> dict[str, str]:
    """Python and C of the package, by path."""
    files = (
        p for p in (ROOT / "lagdsl").rglob("*") if p.suffix in (".py", ".c", ".h", ".lark") and "build" not in p.parts
    )
    return {path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8") for path in files}


def rows() -> list[list[str]]:
    """The rows of the table of terms, cell by cell."""
    text = (ROOT / "docs" / "glossary.md").read_text(encoding="utf-8")
    lines = (line for line in text.splitlines() if line.startswith("|"))
    cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]
    return [row for row in cells if row[0] not in ("term", "---")]


def test_every_row_is_complete() -> None:
    assert all(len(row) == 5 and all(row) for row in rows())


def terms() -> list[str]:
    """First words of the rows, without symbols, in small letters."""
    return [re.sub(r"\$.*?\$", "", row[0]).casefold().strip() for row in rows()]


def test_terms_stand_in_the_order_of_the_alphabet() -> None:
    assert terms() == sorted(set(terms()))


def test_every_row_leads_to_a_page_or_to_another_term() -> None:
    known = {word.strip() for term in terms() for word in term.split(",")}
    other = {row[0]: row[1].removeprefix("see ").casefold() for row in rows() if row[1].startswith("see ")}
    assert {term: word for term, word in other.items() if word not in known} == {}
    assert [row[0] for row in rows() if row[0] not in other and "](" not in row[2]] == []


# Words of headers, doc strings and messages that the hybrid model defines.
HYBRID = """accumulation, approach, armed guard, blow, clause, close, closed contact, corner, dead band, energy jump
at a surface, event, event iteration, gap, guard, held contact, held relation, impact, impulse problem,
instant, kink, mode (of a hybrid model), nonholonomic constraint, open, parting, penetration, position
map, redundant rows, reserve, restitution, reverse, rheonomic constraint, rounding error, row, scan, side,
slip, stick, tick, unilateral contact, wedging"""


def test_the_words_of_the_hybrid_model_are_in_the_glossary() -> None:
    known = {word.strip() for term in terms() for word in term.split(",")}
    assert sorted({" ".join(word.split()) for word in HYBRID.split(",")} - known) == []


def test_names_of_the_code_are_in_the_code() -> None:
    text = "\n".join(sources().values())
    named = {name for row in rows() for name in re.findall(r"`([^`]*)`", row[4])}
    words = set(re.findall(r"\w+", text))
    unknown = [name for name in named if name not in words]
    assert sorted(name for name in unknown if not re.search(rf"\b{re.escape(name)}\b", text)) == []


def test_every_function_that_users_call_is_in_the_glossary() -> None:
    named = {name for row in rows() for name in re.findall(r"`([^`]*)`", row[4])}
    methods = {name for name in dir(lagdsl.Model) if not name.startswith("_") and callable(getattr(lagdsl.Model, name))}
    public = methods | {function.name for function in FUNCTIONS if not function.name.endswith("_tangent")}
    plain = {"evaluate", "over"}  # any function by its name; the constructor of `Model`
    assert sorted(public - plain - named) == []


@cache
def names() -> set[str]:
    """Names of files and of what they define, in small letters."""
    stems = {Path(path).stem for path in sources()}
    defined = {next(filter(None, found)) for text in sources().values() for found in NAME.findall(text)}
    return {name.lower().strip("_") for name in stems | defined}


def test_names_are_the_words_of_the_field() -> None:
    assert sorted((names() & set(BANNED)) - NOT_YET_RENAMED) == []


def test_what_is_renamed_leaves_the_list() -> None:
    """The list shrinks: a word that is in it and no longer a name has to go."""
    assert sorted(NOT_YET_RENAMED - names()) == []


PHRASES = (
    "came to no good end",
    "no end of changes",
    "is told",
    "are told",
    "on two ways",
    "on one by one",
    "without end",
    "begins to",
    "by hand",
    "found with the start",
    "give way",
    "go on with",
    "nothing decides",
    "settles",
)


@pytest.mark.parametrize("phrase", PHRASES)
def test_messages_are_plain(phrase: str) -> None:
    from lagdsl.foundation.diagnostics.catalog import ROWS

    assert [code for code, row in ROWS.items() if phrase in repr(row)] == []


def test_no_sentence_of_the_documents_opens_with_a_clause() -> None:
    """The subject comes first: `What stands here is ...` becomes `Declarations here are ...`."""
    pages = [ROOT / "README.md", *(page for page in (ROOT / "docs").rglob("*.md") if page.parent.name != "adr")]
    opening = re.compile(r"(?:^|[.;:] |^- )(?:What|Whether) [^?\n]*$", re.MULTILINE)
    found = [
        (page.name, sentence)
        for page in pages
        for sentence in opening.findall(
            re.sub(r"^```.*?^```", "", page.read_text("utf-8"), flags=re.DOTALL | re.MULTILINE)
        )
    ]
    assert found == []
