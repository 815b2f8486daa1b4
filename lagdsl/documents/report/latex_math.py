"""Formulas in LaTeX, with amsmath. Every letter that comes from a model passes through `escape`."""

from __future__ import annotations

from string import ascii_letters
from typing import Literal, assert_never

from lagdsl.documents.report import boxes
from lagdsl.documents.report.notation import GREEK
from lagdsl.documents.report.unit_text import readable_unit

_SPECIAL = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "$": r"\$", "&": r"\&", "#": r"\#", "%": r"\%", "_": r"\_",
    "^": r"\textasciicircum{}", "~": r"\textasciitilde{}", "<": r"\textless{}", ">": r"\textgreater{}",
    "|": r"\textbar{}", '"': r"\textquotedbl{}", "`": r"\textasciigrave{}", "'": "'",
    "·": r"\ensuremath{\cdot}", "−": r"\ensuremath{-}", "–": "--", "—": "---", "°": r"\ensuremath{^\circ}",
    "×": r"\ensuremath{\times}",
    "∂": r"\ensuremath{\partial}", "≤": r"\ensuremath{\le}", "≥": r"\ensuremath{\ge}", "∞": r"\ensuremath{\infty}",
    "½": r"\ensuremath{\tfrac12}", "²": r"\ensuremath{^2}", "³": r"\ensuremath{^3}", "…": r"\dots{}",
    "“": "``", "”": "''", "‘": "`", "’": "'", "ω": r"\ensuremath{\omega}",
}  # fmt: skip
_LETTERS = {letter: f"\\{name}" for name, letter in GREEK.items()} | {"Υ": r"\Upsilon", "υ": r"\upsilon"}
_SPECIAL |= {letter: rf"\ensuremath{{{command}}}" for letter, command in _LETTERS.items()}
_FUNCTIONS = ("sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "exp", "ln", "min", "max")
_OPERATORS = {
    "=": "=", ",": ",",
    "<": "<", "≤": r"\le", "≥": r"\ge", ">": ">", "·": r"\cdot", "×": r"\times", "and": r"\text{ and }",
    "or": r"\text{ or }", "→": r"\to", "≈": r"\approx",
}  # fmt: skip
_OTHER_FORMS = {letter: rf"\mathcal{{{plain}}}" for plain, letter in zip("LTVDQMJPNBKCI", "ℒ𝒯𝒱𝒟𝒬ℳ𝒥𝒫𝒩ℬ𝒦𝒞ℐ", strict=True)}
_OTHER_FORMS |= {letter: rf"\mathfrak{{{plain}}}" for plain, letter in zip("pedkfts", "𝔭𝔢𝔡𝔨𝔣𝔱𝔰", strict=True)}
_OTHER_FORMS |= {letter: rf"\mathbf{{{plain}}}" for plain, letter in zip("rvFqg", "𝐫𝐯𝐅𝐪𝐠", strict=True)}
_OTHER_FORMS["𝛚"] = r"\boldsymbol{\omega}"
_SPECIAL |= {letter: rf"\ensuremath{{{command}}}" for letter, command in _OTHER_FORMS.items()}
_SPECIAL |= {letter: rf"\ensuremath{{_{digit}}}" for digit, letter in enumerate("₀₁₂₃₄₅₆₇₈₉")}
_RAISED = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-", strict=True))
_SPECIAL |= {letter: rf"\ensuremath{{^{{{plain}}}}}" for letter, plain in _RAISED.items() if letter not in "²³"}
_IN_UNITS = {letter: f"^{{{plain}}}" for letter, plain in _RAISED.items()}
_IN_UNITS |= {"·": r"{\cdot}", "Ω": r"\Omega", "°": r"{}^\circ "}
_SIGNS = {"∞": r"\infty", "Σ": r"\sum", "·": r"\cdot", "±": r"\pm", "δ": r"\delta", "-∞": r"-\infty"}
_SYMBOLS = _OTHER_FORMS | _LETTERS | _SIGNS


def escape(text: str) -> str:
    """Plain words for text mode; characters a LaTeX installation may lack are named by their code."""
    return "".join(_SPECIAL.get(c) or (c if " " <= c < "\x7f" or "\xa1" <= c <= "\xff" else _named(c)) for c in text)


def _named(character: str) -> str:
    return " " if character.isspace() else f"[U+{ord(character):04X}]"


def tex(box: boxes.Box) -> str:  # noqa: C901, PLR0912
    """The box for math mode."""
    match box:
        case boxes.VectorName(text):
            return rf"\boldsymbol{{{_SYMBOLS.get(text, text)}}}"
        case boxes.Name(text):
            return _SYMBOLS.get(text) or (text if len(text) == 1 and text in ascii_letters else _word(text, "it"))
        case boxes.Upright(text):
            return _SYMBOLS.get(text) or (f"\\{text}" if text in _FUNCTIONS else _word(text, "rm"))
        case boxes.Number(text):
            return text.replace("·", r" \cdot ")
        case boxes.Operator(text):
            return f" {_OPERATORS[text]} "
        case boxes.Row(items):
            return _row(items)
        case boxes.Sum(terms):
            first, *others = terms
            head = f"-{_term(first[1])}" if first[0] == "-" else tex(first[1])
            return head + "".join(f" {sign} {_term(term)}" for sign, term in others)
        case boxes.Fraction(above, below):
            small = isinstance(above, boxes.Number) and isinstance(below, boxes.Number)
            return rf"\{'t' if small else ''}frac{{{tex(above)}}}{{{tex(below)}}}"
        case boxes.Power(base, exponent):
            return f"{_base(base)}^{{{tex(exponent)}}}"
        case boxes.Subscript(base, index):
            return f"{_base(base)}_{{{tex(index)}}}"
        case boxes.Root(inside):
            return rf"\sqrt{{{tex(inside)}}}"
        case boxes.Dotted(base, dots):
            return rf"\{'d' * dots}ot{{{tex(base)}}}"
        case boxes.Derivative(letter, of, by):
            d = r"\partial " if letter == "∂" else r"\mathrm{d}"
            return rf"\frac{{{d}{'' if of is None else tex(of)}}}{{{d}{tex(by)}}}"
        case boxes.Call(function, arguments):
            listed = ", ".join(tex(argument) for argument in arguments)
            simple = len(arguments) == 1 and isinstance(arguments[0], boxes.Name | boxes.Subscript)
            return f"{_function(function)} {listed}" if simple else rf"{_function(function)}\left({listed}\right)"
        case boxes.Bracket(inside, left, right):
            return rf"\left{'(' if left else '.'}{tex(inside)}\right{')' if right else '.'}"
        case boxes.Marked(inside):
            return tex(inside)
        case boxes.Cases(value, condition, otherwise):
            rows = rf"{tex(value)} & \text{{if }} {tex(condition)} \\ {tex(otherwise)} & \text{{otherwise}}"
            return rf"\begin{{cases}} {rows} \end{{cases}}"
        case boxes.Column(components):
            lines = r" \\ ".join(tex(x) for x in components)
            return rf"\begin{{pmatrix}} {lines} \end{{pmatrix}}"
        case boxes.Unit(text):
            return rf"\quad[{_unit(text)}]"
        case boxes.Joined(items):
            return " ".join(tex(item) for item in items)
        case boxes.Matrix(rows):
            lines = r" \\ ".join(" & ".join(tex(x) for x in row) for row in rows)
            return rf"\begin{{bmatrix}} {lines} \end{{bmatrix}}"
        case _:
            assert_never(box)


def _word(text: str, shape: Literal["rm", "it"]) -> str:
    """A name of several letters, or words."""
    plain = text.isascii() and text.isalnum()
    return rf"\math{shape}{{{text}}}" if plain else rf"\text{shape}{{{escape(text)}}}"


def _unit(text: str) -> str:
    """`kg.m2/s` upright, with dots and exponents."""
    return rf"\mathrm{{{''.join(_IN_UNITS.get(c) or escape(c) for c in readable_unit(text))}}}"


def _base(box: boxes.Box) -> str:
    """Base of an exponent or an index."""
    return tex(box) if isinstance(box, boxes.Name | boxes.Dotted | boxes.Bracket | boxes.Number) else f"{{{tex(box)}}}"


def _function(box: boxes.Box) -> str:
    return (
        rf"\operatorname{{{box.text}}}" if isinstance(box, boxes.Upright) and box.text not in _FUNCTIONS else tex(box)
    )


def _row(items: tuple[boxes.Box, ...]) -> str:
    """Factors with a thin space, where words of several letters would run together."""
    pieces: list[str] = []
    for previous, item in zip((None, *items), items, strict=False):
        if previous is not None and not isinstance(item, boxes.Operator) and not isinstance(previous, boxes.Operator):
            pieces.append(r"\, ")
        pieces.append(tex(item))
    return "".join(pieces)


def _term(box: boxes.Box) -> str:
    return rf"\left({tex(box)}\right)" if isinstance(box, boxes.Sum) else tex(box)
