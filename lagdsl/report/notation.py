"""Names of the model as people write them: Greek letters, indices, dots."""

from __future__ import annotations

import re
from dataclasses import dataclass

from sympy import Symbol

from lagdsl.report.boxes import Box, Dotted, Name, Number, Operator, Row, Subscript, Upright
from lagdsl.textbook.reading import STANDARD_GRAVITY
from lagdsl.textbook.symbols import Symbols

GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ", "eta": "η", "theta": "θ",
    "iota": "ι", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ", "pi": "π", "rho": "ρ", "sigma": "σ",
    "tau": "τ", "upsilon": "υ", "phi": "φ", "chi": "χ", "psi": "ψ", "omega": "ω",
    "Gamma": "Γ", "Delta": "Δ", "Theta": "Θ", "Lambda": "Λ", "Xi": "Ξ", "Pi": "Π", "Sigma": "Σ", "Upsilon": "Υ",
    "Phi": "Φ", "Psi": "Ψ", "Omega": "Ω",
}  # fmt: skip

_PARTS = re.compile(r"[^.\[\],\s]+")
_DIGITS = re.compile(r"^(.*?[^\d_])_?(\d+)$")


def name_box(name: str) -> Box:
    """`theta` θ, `a1` a₁, `m_rod` m with index rod, `q[2]` q₂, `arm.q` q with index arm."""
    scope, _, last = name.rpartition(".") if not name.startswith(".") else ("", "", name)
    pieces = _PARTS.findall(last) or [last]
    base, indices = pieces[0], pieces[1:]
    stem, *words = [word for word in base.split("_") if word] or [base]
    digits = _DIGITS.match(stem)
    if digits is not None:
        stem, words = digits.group(1), [digits.group(2), *words]
    labels = [*_PARTS.findall(scope), *words, *indices]
    if not labels:
        return _word(stem)
    inside: list[Box] = []
    for label in labels:
        inside += [Operator(",")] if inside else []
        inside.append(Number(label) if label.isdigit() else _word(label) if label in GREEK else Upright(label))
    return Subscript(_word(stem), inside[0] if len(inside) == 1 else Row(tuple(inside)))


def _word(text: str) -> Name:
    return Name(GREEK.get(text, text))


def dotted(box: Box, dots: int) -> Box:
    """Dots stand over the letter, not over its index."""
    return Subscript(Dotted(box.base, dots), box.index) if isinstance(box, Subscript) else Dotted(box, dots)


@dataclass(frozen=True)
class Notation:
    """Boxes of all symbols of a derivation."""

    boxes: dict[Symbol, Box]

    def of(self, symbol: Symbol) -> Box:
        return self.boxes[symbol] if symbol in self.boxes else name_box(symbol.name)


def notation(symbols: Symbols, abbreviations: tuple[Symbol, ...], rows: tuple[str, ...]) -> Notation:
    boxes: dict[Symbol, Box] = {STANDARD_GRAVITY: Subscript(Name("g"), Upright("n"))}
    taken = {symbol.name for symbol in (*symbols.p, *symbols.q, *symbols.z, *symbols.u, *abbreviations)}
    boxes[symbols.time] = Upright("time") if "t" in taken else Name("t")
    for q, qd, qdd in zip(symbols.q, symbols.qd, symbols.qdd, strict=True):
        box = name_box(q.name)
        boxes |= {q: box, qd: dotted(box, 1), qdd: dotted(box, 2)}
    for symbol in abbreviations:
        boxes |= {symbol: name_box(symbol.name), Symbol(f"der({symbol.name})"): dotted(name_box(symbol.name), 1)}
    for symbol in symbols.u:
        inner = symbol.name.count("der(")
        bare = symbol.name[4 * inner : len(symbol.name) - inner] if inner else symbol.name
        boxes[symbol] = dotted(name_box(bare), inner) if inner else name_box(bare)
    for symbol in symbols.w:
        if not symbol.name.isidentifier() and set(symbol.name) & set("<>( "):
            boxes[symbol] = Upright(symbol.name)  # the truth of a relation, in its own words
    for multiplier, name in zip(symbols.lam, rows, strict=True):
        boxes[multiplier] = _multiplier(name, len(rows))
    return Notation(boxes)


def _multiplier(name: str, rows: int) -> Box:
    if rows == 1:
        return Name("λ")
    labels = _PARTS.findall(name)
    return Subscript(Name("λ"), Upright(",".join(labels)))
