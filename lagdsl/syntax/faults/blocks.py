"""Faults of blocks: a class without a name, a block without its `end`, an `end` without its block."""

from __future__ import annotations

from lagdsl.diagnostics import Label, Sink
from lagdsl.source import Span
from lagdsl.syntax.automaton import END_OF_TEXT, TERMINAL
from lagdsl.syntax.expected import expected, found
from lagdsl.syntax.lexer import IDENT, Lexer, Token
from lagdsl.syntax.session import BLOCKS, CLASS_KIND, LONGEST_LOOK, SEMICOLON, Session


def missing_class_name(session: Session, token: Token) -> bool:
    """`model` without a name: go on as if it had one."""
    if session.previous.terminal != CLASS_KIND or not session.machine.accepts(IDENT):
        return False
    session.sink.report(
        "E0100", session.span(token), found=found(token), expected=f"the name of the {session.previous.text}"
    )
    session.insert("_")
    if session.starts_line(token) or token.terminal == SEMICOLON:
        session.lexer.rewind(token.start)
    return True


def end_of_text(session: Session, token: Token) -> bool:
    """The text ends inside a statement or inside a block."""
    if token.terminal != END_OF_TEXT:
        return False
    if session.machine.accepts(SEMICOLON):
        return False
    block = session.open_block()
    at_statement = len(session.machine.states) == session.machine.boundary()
    if block is not None and (at_statement or session.previous.text == "end"):
        _report_open(session, block, None)
    else:
        session.sink.report("E0100", session.after_previous(), found=found(token), expected=expected(session.machine))
    session.give_up()
    return True


def end_of_block(session: Session, token: Token) -> bool:
    """An `end` of another kind than the innermost block has, or where no block is open."""
    if token.text == "end" and session.machine.boundary() and session.open_block() is None:
        if ("E0120", 0) not in session.told:  # once a class is closed too early, every `end` after it is one too many
            session.told.add(("E0120", 0))
            ahead = [t.text for t in session.look_ahead(token.end)][:1]
            session.sink.report("E0120", session.span(token), found=" ".join(ahead), help=None)
        session.panic(token)
        return True
    if session.previous.text != "end" or session.previous.terminal != TERMINAL["END"]:
        return False
    block = session.open_block()
    assert block is not None
    if block.terminal == CLASS_KIND:
        return _end_of_nothing(session, token)
    if token.text in BLOCKS:
        session.sink.report(
            "E0120", _ending(session, token), Label(session.span(block), "this is open"), found=token.text
        )
        if _has_own_end(session, block, token):
            return _leave_out(session, token)
        return session.insert(block.text)
    _report_open(session, block, session.previous)
    end = session.previous.start
    session.insert(block.text, ";")
    session.lexer.rewind(end)
    return True


def ends_outer_class(session: Session, token: Token) -> bool:
    """`end Outer` while a class inside of it is open: that one has no end. Close it and read on before `end`."""
    if session.previous.terminal != TERMINAL["END"] or token.terminal != IDENT:
        return False
    names = session.open_classes()
    if len(names) < 2 or names[-1] == token.text or token.text not in names:
        return False
    block = session.open_block()
    if block is None or block.terminal != CLASS_KIND:
        return False
    end = session.previous
    _report_open(session, block, end)
    session.insert(";")
    session.lexer.rewind(end.start)
    return True


def _end_of_nothing(session: Session, token: Token) -> bool:
    """`end for;` where the innermost block is a class: leave the whole statement out."""
    if token.text not in BLOCKS:
        return False
    session.sink.report("E0120", _ending(session, token), found=token.text)
    return _leave_out(session, token)


def _has_own_end(session: Session, block: Token, token: Token) -> bool:
    """Whether `block` is ended further on, so that the `end` before `token` is one too many and not a wrong one."""
    lexer = Lexer(session.file, Sink())
    lexer.position = token.end
    previous, depth = token, 0
    for _ in range(LONGEST_LOOK):
        ahead = lexer.next()
        if previous.text == "end":
            if not depth:
                return ahead.text == block.text
            depth -= 1
        elif ahead.text in BLOCKS and session.starts_line(ahead):
            depth += 1
        if ahead.terminal == END_OF_TEXT:
            return False
        previous = ahead
    return False


def _leave_out(session: Session, token: Token) -> bool:
    """Forget an `end` whose word is `token`, with its semicolon."""
    session.machine.cut(len(session.machine.states) - 1)
    session.machine.cut(session.machine.boundary())
    session.previous = token
    ahead = session.lexer.next()
    if ahead.terminal != SEMICOLON:
        session.lexer.rewind(ahead.start)
    return True


def _ending(session: Session, token: Token) -> Span:
    return session.span(session.previous).to(session.span(token))


def _report_open(session: Session, block: Token, end: Token | None) -> None:
    """A block without its end; `end` is the one that was met instead."""
    text = session.file.text
    if block.terminal == CLASS_KIND:
        name = next((t for t in session.look_ahead(block.end)), block)
        spelled, ending = f"{block.text} {name.text}", name.text
        span = session.span(block).to(session.span(name))
    else:
        spelled, ending, span = block.text, block.text, session.span(block)
    labels = () if end is None else (Label(session.span(end), f"`end {ending};` is expected before this"),)
    if end is None and text.strip():
        place = len(text.rstrip())
        labels = (Label(Span(session.file, place, place), "the file ends here"),)
    session.sink.report("E0113", span, *labels, block=spelled, ending=ending)
