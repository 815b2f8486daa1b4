"""`lag explain force`: every word of the language has a page, made from the manual."""

from __future__ import annotations

from lagdsl.language.manual.word_page import word_page, words
from lagdsl.language.manual.words import FUNCTIONS, function_of, statement_of
from lagdsl.language.syntax.vocabulary import vocabulary

# Words that no model can hold, or that no text needs so far.
WITHOUT_EXAMPLE = {"record", "stream", "symbol"}


def test_every_word_of_the_language_has_a_page_with_its_place_in_the_reference():
    pages = {word: word_page(word) for word in words()}
    assert [word for word, page in pages.items() if page is None] == []
    lacking = [
        word for word, page in pages.items() if "## Reference\n\ndocs/reference/language.md, section " not in page
    ]
    assert lacking == []
    assert word_page("forse") is None


def test_every_statement_and_function_has_syntax_and_an_example():
    assert [name for name in FUNCTIONS if function_of(name) is None] == []
    named = [word for word in (*vocabulary().words, *FUNCTIONS) if word not in WITHOUT_EXAMPLE]
    assert [word for word in named if "## Example" not in word_page(word)] == []
    begun = [word for word in vocabulary().words if statement_of(word) is not None]
    assert len(begun) > 25
    assert [word for word in begun if "```modelica fragment\n" not in word_page(word)] == []
