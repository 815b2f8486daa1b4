"""Kinds of characters as the parser reads a text: the reference of all that colours it."""

from __future__ import annotations

from pathlib import Path

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.highlight.rules import Kind
from lagdsl.language.syntax.builder import TooDeep
from lagdsl.language.syntax.session import Session
from lagdsl.language.syntax.tokens import comments, end_of, start_of, unit_of
from lagdsl.language.syntax.vocabulary import vocabulary

ROOT = Path(__file__).parents[3]
GAP = " "
"""Kind of blanks."""

TRAPS = (
    """model A
  Real at = 3, on, to;
  point from = {1 m, at};
  Mass mass = 1 kg;
  force on*at on q;
  force mass*g on on;
  potential mass*g_n*point;
equation
  state = force;
  force = k*x;
end A;
""",
    """model M
  Length at if n > 1;
  Real model1 = 5 m/s2 /* 5 m at P */;
  force F
    at P
    from Q;
  when x > 0 then
    reinit(der(force), 0);
  elsewhen sample(0, 1) then
    n = pre(n) + 1;
  end when;
  if n > 2 then
    mass m at P;
  else
    mass m at Q;
  end if;
  for i in 1:3 loop
    body b(m = 1 kg) on F[i];
  end for;
end M;
""",
    """within A.B;
type E = enumeration(a, b) "at x";
function f(Real x = 5 /s) -> Real = if x > 1 then x^2 else 2*x;
partial model M = N(redeclare model X = Y(a = 3), each final b = 2, redeclare Z force(a = 3)) "doc\\"x at y";
""",
    """model Q
  Link a(l = 0.4 m, m = 1 kg) "coordinate x /* no */ at
    5 m", b;
  draw rod(radius = 1 cm) from A to B if on;
  contact c: gap >= 0 with restitution = e, damping = 3 N.s/m;  // force at P
  friction f: der(friction) with limit = 2 N.m, sticking = friction if at "friction";
  Real r = 5 m/x + 5/s + 5 /s - 3e-2 kg.m2 + 4 m2 + 4 m^2 + 2*m/s;
  initial equation
  output = 3;
  theta = 1;
end;
""",
)
"""Texts in which words of the language are names, and units are beside names of the same letters."""


def as_the_parser_reads(text: str) -> list[str] | None:
    """For each character the kind of its token, from Lark's contextual lexer; None if the text is refused."""
    sink = Sink()
    session = Session(SourceFile("text.lag", text), sink, "start")
    kinds = [GAP] * len(text)
    try:
        while not session.finished:
            token = session.take()
            if not session.shift(token) or sink.has_errors:
                return None
            _paint(kinds, start_of(token), end_of(token), token.type, token.value)
    except TooDeep:
        return None
    for comment in comments(text):
        kinds[comment.start : comment.end] = [Kind.COMMENT] * (comment.end - comment.start)
    return kinds


def _paint(kinds: list[str], start: int, end: int, terminal: str, value: str) -> None:
    match terminal:
        case "IDENT":
            kind = Kind.NAME
        case "STRING":
            kind = Kind.STRING
        case "NUMBER":
            kind = Kind.NUMBER
        case "QUANTITY":
            kinds[start:end] = [Kind.NUMBER] * (end - start)
            unit = len(unit_of(value))
            kinds[end - unit : end] = [Kind.UNIT] * unit
            return
        case _ if value in vocabulary().words:
            kind = Kind.LITERAL if value in ("true", "false") else Kind.KEYWORD
        case _:
            kind = Kind.MARK if value in "()[]{},;" else Kind.OPERATOR
    kinds[start:end] = [kind] * (end - start)


def texts() -> dict[str, str]:
    """All model texts of the project that the parser accepts or that announce faults after it, by their paths."""
    tests = [f"tests/{name}" for name in ("corpus", "library", "physics", "exchange/robots")]
    folders = ("models", "stdlib", "benchmarks", *tests)
    paths = sorted(path for folder in folders for path in (ROOT / folder).rglob("*.lag"))
    return {path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8") for path in paths}


def difference(text: str, expected: list[str], found: list[str]) -> str | None:
    """The first place at which kinds differ, blanks aside; a TYPE is a name, too."""
    for position, (one, two) in enumerate(zip(expected, found, strict=True)):
        if one != GAP and not text[position].isspace() and one != (Kind.NAME if two == Kind.TYPE else two):
            line = text.count("\n", 0, position) + 1
            start = text.rfind("\n", 0, position) + 1
            around = text[start : text.find("\n", position)]
            return f"line {line}, column {position - start + 1}: `{around}`: {one}, not {two}"
    return None
