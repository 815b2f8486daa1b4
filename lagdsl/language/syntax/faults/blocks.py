"""Faults of blocks: a class without a name, a block without its `end`, an `end` without its block."""

from __future__ import annotations

from itertools import islice

from lark import Token

from lagdsl.foundation.diagnostics import Edit, Label
from lagdsl.foundation.source import Span
from lagdsl.language.syntax.expected import expected, found
from lagdsl.language.syntax.session import BLOCKS, LONGEST_LOOK, Session
from lagdsl.language.syntax.tokens import END_OF_TEXT, end_of, plain_tokens, start_of
from lagdsl.language.syntax.vocabulary import vocabulary

_SECTIONS = {"EQUATION_SECTION", "VISIBILITY"}


def missing_class_name(session: Session, token: Token) -> bool:
    """`model` without a name: go on as if it had one."""
    if session.previous.type != "CLASS_KIND" or not session.stack.accepts("IDENT"):
        return False
    session.sink.report(
        "E0100", session.span(token), found=found(token), expected=f"the name of the {session.previous.value}"
    )
    session.insert("_")
    if session.starts_line(token) or token.type == "SEMICOLON":
        session.rewind(start_of(token))
    return True


def end_of_text(session: Session, token: Token) -> bool:
    """The text ends inside a statement or inside a block."""
    if token.type != END_OF_TEXT:
        return False
    if session.stack.accepts("SEMICOLON"):
        return False
    block = session.open_block()
    at_statement = session.stack.at_boundary()
    if block is not None and (at_statement or session.previous.value == "end"):
        _report_open(session, block, None)
    else:
        session.sink.report("E0100", session.after_previous(), found=found(token), expected=expected(session.stack))
    session.give_up()
    return True


def end_of_block(session: Session, token: Token) -> bool:
    """An `end` of another kind than the innermost block has, or where no block is open."""
    if token.value == "end" and session.stack.boundary() and session.open_block() is None:
        # Once a class is closed too early, every `end` after it is one too many.
        if ("E0120", 0) not in session.reported.told:
            session.reported.told.add(("E0120", 0))
            ahead = [t.value for t in session.look_ahead(end_of(token))][:1]
            session.sink.report("E0120", session.span(token), found=" ".join(ahead), help=None)
        session.panic(token)
        return True
    if session.previous.value != "end" or session.previous.type != "END":
        return False
    block = session.open_block()
    assert block is not None
    if block.type == "CLASS_KIND":
        return _end_of_nothing(session, token)
    if token.value in BLOCKS:
        session.sink.report(
            "E0120", _ending(session, token), Label(session.span(block), "this is open"), found=token.value
        )
        if _has_own_end(session, block, token):
            return _leave_out(session, token)
        return session.insert(block.value)
    _report_open(session, block, session.previous)
    end = start_of(session.previous)
    session.insert(block.value, ";")
    session.rewind(end)
    return True


def section_in_block(session: Session, token: Token) -> bool:
    """`equation` or `protected` where a loop, a branch or an event is open: that one has no end."""
    block, height = session.open_block(), session.stack.boundary()
    if block is None or block.type == "CLASS_KIND" or height == 0:
        return False
    words = [*session.look_ahead(session.statement_start(token))][:2]
    if not words or not begins_section(session, words[0]) or start_of(token) > start_of(words[-1]):
        return False
    word = words[0]
    session.stack.cut(height)
    _report_open(session, block, word)
    session.insert("end", block.value, ";")
    session.rewind(start_of(word))
    return True


def begins_section(session: Session, token: Token) -> bool:
    """True if a line begins with `equation`, `initial equation`, `protected` or the like."""
    words = [*session.look_ahead(start_of(token))][:2]
    if [word.value for word in words] == ["initial", "equation"]:
        return session.starts_line(token)
    return session.starts_line(token) and not _SECTIONS.isdisjoint(vocabulary().words.get(token.value, ()))


def ends_outer_class(session: Session, token: Token) -> bool:
    """`end Outer` while a class inside of it is open: that one has no end. Close it and read on before `end`."""
    if session.previous.type != "END" or token.type != "IDENT":
        return False
    names = session.open_classes()
    if len(names) < 2 or names[-1] == token.value or token.value not in names:
        return False
    block = session.open_block()
    if block is None or block.type != "CLASS_KIND":
        return False
    end = session.previous
    _report_open(session, block, end)
    session.insert(";")
    session.rewind(start_of(end))
    return True


def _end_of_nothing(session: Session, token: Token) -> bool:
    """`end for;` where the innermost block is a class: leave the whole statement out."""
    if token.value not in BLOCKS:
        return False
    session.sink.report("E0120", _ending(session, token), found=token.value)
    return _leave_out(session, token)


def _has_own_end(session: Session, block: Token, token: Token) -> bool:
    """True if `block` is ended further on, so that the `end` before `token` is one too many and not a wrong one."""
    previous, depth = token, 0
    for ahead in islice(plain_tokens(session.file.text, end_of(token)), LONGEST_LOOK):
        if previous.value == "end":
            if not depth:
                return bool(ahead.value == block.value)
            depth -= 1
        elif ahead.value in BLOCKS and session.starts_line(ahead):
            depth += 1
        previous = ahead
    return False


def _leave_out(session: Session, token: Token) -> bool:
    """Forget an `end` whose word is `token`, with its semicolon."""
    session.stack.cut(len(session.stack.states) - 1)
    session.stack.cut(session.stack.boundary())
    session.previous = token
    ahead = session.skip()
    if ahead.type != "SEMICOLON":
        session.rewind(start_of(ahead))
    return True


def _ending(session: Session, token: Token) -> Span:
    return session.span(session.previous).to(session.span(token))


def _report_open(session: Session, block: Token, end: Token | None) -> None:
    """A block without its end; `end` is the one that was met instead."""
    text = session.file.text
    if block.type == "CLASS_KIND":
        name = next((t for t in session.look_ahead(end_of(block))), block)
        spelled, ending = f"{block.value} {name.value}", name.value
        span = session.span(block).to(session.span(name))
    else:
        spelled, ending, span = block.value, block.value, session.span(block)
    labels = () if end is None else (Label(session.span(end), f"`end {ending};` is expected before this"),)
    edit = None if end is None else Edit(Span(session.file, start_of(end), start_of(end)), f"end {ending};\n")
    if end is None and text.strip():
        place = Span(session.file, len(text.rstrip()), len(text.rstrip()))
        labels, edit = (Label(place, "the file ends here"),), Edit(place, f"\nend {ending};")
    session.sink.report("E0113", span, *labels, edit=edit, block=spelled, ending=ending)
