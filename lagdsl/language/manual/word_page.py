"""The page of a word of the language: syntax, meaning, an example, its place in the reference. `lag explain force`."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache

from lagdsl.foundation.resources import diagnostics_folder, language_reference, library_folder, models_folder
from lagdsl.language.manual.words import (
    ATTRIBUTES,
    FUNCTIONS,
    KEYWORDS,
    VARIABLES,
    constant_text,
    function_of,
    keyword_text,
    paragraph_on,
    row_with,
    statement_of,
    type_text,
)
from lagdsl.language.semantics.scope.prelude import CONSTANTS, TYPES
from lagdsl.language.syntax.vocabulary import vocabulary

_FENCE = re.compile(r"^```[^\n]*\n(.*?)^```", re.MULTILINE | re.DOTALL)
_ACCEPTED = re.compile(r"^```lag accept\n(.*?)^```", re.MULTILINE | re.DOTALL)
_HEADING = re.compile(r"^(##+) (.*)$", re.MULTILINE)
_CODE = re.compile(r"`([^`]+)`")
_STATEMENT = re.compile(r"[(=;:]")
_PAGE = re.compile(r"\]\(([a-z_]+\.md)")
_TEXT = re.compile(r'"[^"]*"')
_MOST_LINES = 10
_LONGEST = 110
# Sections that name many words and explain none.
_OVERVIEWS = ("Statements", "A model", "Text, numbers and units")
_OF_FUNCTIONS = "Names"
_BLOCKS = ("when", "for", "if")


def words() -> tuple[str, ...]:
    """All words of the language, by the alphabet."""
    return tuple(sorted({*vocabulary().words, *FUNCTIONS, *ATTRIBUTES, *VARIABLES, *TYPES, *CONSTANTS}))


def word_page(word: str) -> str | None:
    """The page of a word of the language as Markdown; None for other words."""
    kinds = list(_kinds(word))
    if not kinds:
        return None
    lines = [f"# {word}", ""]
    for title, text in kinds:
        lines += [f"## {title}", "", text, ""]
    example = _example(word)
    if example is not None:
        lines += ["## Example", "", "```modelica fragment", *example, "```", ""]
    return "\n".join([*lines, "## Reference", "", _places(word), ""])


def _kinds(word: str) -> Iterator[tuple[str, str]]:
    """Everything that the word is in the language."""
    if word in vocabulary().words:
        row = statement_of(word) or row_with(word)
        meanings = [f"`{word}`: {KEYWORDS[word]}."] if word in KEYWORDS else []
        shown = [_shown(*row)] if row is not None and (word not in KEYWORDS or statement_of(word)) else []
        text = "\n\n".join([*meanings, *shown]) or keyword_text(word)
        if text is not None:
            yield "Statement" if statement_of(word) else "Word", text
    if word in FUNCTIONS:
        called = function_of(word)
        yield "Function", _shown(*called) if called is not None else paragraph_on(word) or f"`{word}(...)`"
    if word in ATTRIBUTES and word not in vocabulary().words:
        yield "Attribute", f"`{word}`: {ATTRIBUTES[word]}."
    if word in VARIABLES:
        yield "Name", f"`{word}`: {VARIABLES[word]}."
    if (text := type_text(word)) is not None:
        yield "Type", f"`{word}` is {text}."
    if (text := constant_text(word)) is not None:
        yield "Constant", f"{text}."


def _shown(syntax: str, meaning: str) -> str:
    return f"```modelica fragment\n{syntax}\n```\n\n{meaning[:1].upper()}{meaning[1:]}."


# ---- examples --------------------------------------------------------------------------------------------------------


@cache
def _texts() -> list[list[str]]:
    """Lines of the model texts of the manual, then of the models that come with the compiler, of the library and of the
    pages of diagnostics; at last the pieces of code in the manual."""
    manual = language_reference().read_text(encoding="utf-8")
    files = [*sorted(models_folder().glob("*.lag")), *sorted(library_folder().rglob("*.lag"))]
    pages = sorted(diagnostics_folder().glob("*.md"))
    texts = [*_FENCE.findall(manual), *(file.read_text(encoding="utf-8") for file in files)]
    texts += [text for page in pages for text in _ACCEPTED.findall(page.read_text(encoding="utf-8"))]
    spans = [span for span in _CODE.findall(_FENCE.sub("", manual)) if _STATEMENT.search(span)]
    return [text.splitlines() for text in (*texts, *spans)]


def _example(word: str) -> list[str] | None:
    """The first statement that the word begins, else one that holds it; of a function the first one that calls it."""
    called = word in FUNCTIONS and word not in vocabulary().words
    begins = re.compile(rf"\s*{re.escape(word)}\b(?!\[).")
    holds = re.compile(rf"(?<![\w.]){re.escape(word)}" + (r"\(" if called else r"\b"))
    for found in (holds.search,) if called else (begins.match, holds.search):
        for lines in _texts():
            for place, line in enumerate(lines):
                code = _TEXT.sub("", line.partition("//")[0])
                if found(code) and (statement := _statement(lines, place)) is not None:
                    return statement
    return None


def _statement(lines: list[str], place: int) -> list[str] | None:
    """The statement that begins in a line, without the indentation; None where it is long."""
    first = lines[place].strip()
    opening = first.split(None, 1)[0]
    end = f"end {opening};" if opening in _BLOCKS else ";"
    found: list[str] = []
    for line in lines[place : place + _MOST_LINES]:
        found.append(line)
        stripped = line.partition("//")[0].rstrip()
        if stripped.endswith(end) or (end == ";" and "end " in first):
            indent = len(found[0]) - len(found[0].lstrip())
            kept = [each[indent:] if each[:indent].isspace() else each for each in found]
            return kept if all(len(each) <= _LONGEST for each in kept) else None
    return [first] if opening not in _BLOCKS and len(first) <= _LONGEST else None


# ---- places ----------------------------------------------------------------------------------------------------------


def _places(word: str) -> str:
    """The section of the manual on the word, and the pages to which that section leads."""
    sections = _sections()
    begins = re.compile(rf"\s*{re.escape(word)}\b")
    holds = re.compile(rf"(?<![\w.]){re.escape(word)}\b")
    counts = {
        title: (
            re.search(rf"\b{re.escape(word)}", title, re.IGNORECASE) is not None,
            sum(begins.match(code) is not None for code in _codes(text)),
            sum(holds.search(code) is not None for code in _codes(text)),
        )
        for title, text in sections.items()
        if title not in _OVERVIEWS and not (title == _OF_FUNCTIONS and word in vocabulary().words)
    }
    best = max(counts, key=lambda title: counts[title])
    if not any(counts[best]):
        return f"docs/reference/language.md, section {_OVERVIEWS[0]}"
    further = "".join(f"; docs/reference/{page}" for page in dict.fromkeys(_PAGE.findall(sections[best])))
    return f"docs/reference/language.md, section {best}{further}"


def _codes(text: str) -> list[str]:
    """Pieces of code in a text: spans and lines of model texts."""
    fenced = [line for block in _FENCE.findall(text) for line in block.splitlines()]
    return [*_CODE.findall(_FENCE.sub("", text)), *fenced]


@cache
def _sections() -> dict[str, str]:
    """Texts of the sections of the manual by their titles."""
    text = language_reference().read_text(encoding="utf-8")
    heads = list(_HEADING.finditer(text))
    ends = [*(head.start() for head in heads[1:]), len(text)]
    return {head[2]: text[head.end() : end] for head, end in zip(heads, ends, strict=True)}
