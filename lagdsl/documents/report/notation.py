"""Names of the model as people write them: Greek letters, indices, dots."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

from sympy import Symbol

from lagdsl.derivation.textbook.reading import STANDARD_GRAVITY
from lagdsl.derivation.textbook.symbols import Symbols
from lagdsl.documents.report.boxes import Box, Bracket, Dotted, Name, Number, Operator, Row, Subscript, Sum, Upright
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.expression_text import flat_expression_text
from lagdsl.language.flat.model import Definition, FlatModel
from lagdsl.language.flat.quantity import Quantity, Variability

GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ", "eta": "η", "theta": "θ",
    "iota": "ι", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ", "pi": "π", "rho": "ρ", "sigma": "σ",
    "tau": "τ", "upsilon": "υ", "phi": "φ", "chi": "χ", "psi": "ψ", "omega": "ω",
    "Gamma": "Γ", "Delta": "Δ", "Theta": "Θ", "Lambda": "Λ", "Xi": "Ξ", "Pi": "Π", "Sigma": "Σ", "Upsilon": "Υ",
    "Phi": "Φ", "Psi": "Ψ", "Omega": "Ω",
}  # fmt: skip

# For a model that has the usual letter itself: script for energies and matrices, bold for vectors, Fraktur for numbers.
_OTHER_FORMS = {
    "L": "ℒ", "T": "𝒯", "V": "𝒱", "D": "𝒟", "Q": "𝒬", "M": "ℳ", "J": "𝒥", "P": "𝒫", "N": "𝒩", "B": "ℬ", "K": "𝒦",
    "C": "𝒞", "I": "ℐ", "r": "𝐫", "v": "𝐯", "ω": "𝛚", "F": "𝐅", "x": "ξ", "λ": "Λ", "γ": "Γ",
    "p": "𝔭", "e": "𝔢", "d": "𝔡", "k": "𝔨", "f": "𝔣", "q": "𝐪", "s": "𝔰", "t": "𝔱",
}  # fmt: skip
# Letters that the derivation writes alone and with an index.
_FAMILIES = frozenset("rvωFTMJsλI")
# The letter of a quantity that moves, by its unit.
_KINDS = {
    "rad": "θ", "m": "s", "rad/s": "ω", "m/s": "v", "C": "q", "N": "F", "N.m": "M", "V": "u", "A": "i", "Pa": "p",
    "m3": "V", "K": "T", "kg": "m",
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
    """Boxes of all symbols of a derivation, no two of them alike.

    The model has symbols of the letters `bare`, and of the letters `indexed` with an index. `own` are symbols of the
    derivation with their letters; `renamed` are letters that had to give way, as far as they were asked for.
    """

    boxes: dict[Symbol, Box]
    bare: frozenset[str]
    indexed: frozenset[str]
    own: dict[Symbol, str] = field(default_factory=dict)
    renamed: dict[str, Box] = field(default_factory=dict)

    def of(self, symbol: Symbol) -> Box:
        if symbol in self.own:
            self.letter(self.own[symbol])
        return self.boxes[symbol] if symbol in self.boxes else name_box(symbol.name)

    def letter(self, letter: str, *, indexed: bool = False) -> Box:
        """A letter of the derivation itself, as L or T, in another form where it could be taken for one of the model:
        where both stand alone, or both have an index."""
        taken = self.indexed if indexed else self.bare
        if letter not in (self.bare | self.indexed if letter in _FAMILIES else taken):
            return Name(letter)
        forms = (_OTHER_FORMS.get(letter, letter + "'"), letter + "'", f"{letter}*")
        found = Name(next((form for form in forms if form not in self.bare | self.indexed), f"{letter}*"))
        self.renamed.setdefault(letter, found)
        return found

    def intermediate(self, number: int) -> Symbol:
        """A new symbol, s with that number."""
        symbol = Symbol(f"intermediate {number}")
        self.boxes[symbol] = Subscript(self.letter("s"), Number(str(number)))
        return symbol


def notation(flat: FlatModel, symbols: Symbols, abbreviations: tuple[Symbol, ...], rows: tuple[str, ...]) -> Notation:
    """`rows` are the constraints whose multipliers are printed."""
    boxes = _distinct(_quantities(flat, symbols, abbreviations))
    bare = frozenset(box.text for box in boxes.values() if isinstance(box, Name | Upright))
    indexed = frozenset(b.base.text for b in boxes.values() if isinstance(b, Subscript) and isinstance(b.base, Name))
    made = Notation(boxes, bare, indexed, {symbols.time: "t"} | dict.fromkeys(symbols.lam, "λ"))
    for q, qd, qdd in zip(symbols.q, symbols.qd, symbols.qdd, strict=True):
        boxes |= {qd: dotted(boxes[q], 1), qdd: dotted(boxes[q], 2)}
    for symbol in abbreviations:
        boxes |= {Symbol(f"{'der(' * k}{symbol.name}{')' * k}"): dotted(boxes[symbol], k) for k in (1, 2)}
    for item, symbol in zip(flat.inputs, symbols.u, strict=True):
        if item.derivative_of is not None:
            inner = symbol.name.count("der(")
            bare = Symbol(symbol.name[4 * inner : len(symbol.name) - inner])
            boxes[symbol] = dotted(boxes[bare] if bare in boxes else name_box(bare.name), inner)
    boxes[symbols.time] = made.letter("t")
    boxes |= _delayed(flat, boxes, boxes[symbols.time])
    boxes.setdefault(STANDARD_GRAVITY, Subscript(Name("g"), Upright("n")))
    known = [row for constraint in flat.constraints for row in constraint.rows]
    base = made.letter("λ")
    for multiplier, name in zip(symbols.lam, known, strict=True):
        boxes[multiplier] = _multiplier(base, name, rows)
    made.renamed.clear()
    return made


def _delayed(flat: FlatModel, boxes: Mapping[Symbol, Box], time: Box) -> dict[Symbol, Box]:
    """`delay(x, T)` is x(t − T); what is no name is called as it is written."""
    found: dict[Symbol, Box] = {}
    for each in flat.events.delays:
        value, by = flat_expression_text(each.value), flat_expression_text(each.time)
        of, ago = boxes.get(Symbol(value)), boxes.get(Symbol(by))
        if of is None:
            continue
        ago = Row((Number(by), Upright("s"))) if ago is None and isinstance(each.time, fx.Number) else ago
        inside = Sum((("+", time), ("-", Upright(by) if ago is None else ago)))
        found[Symbol(each.name)] = Row((of, Bracket(inside)))
    return found


def _quantities(flat: FlatModel, symbols: Symbols, abbreviations: tuple[Symbol, ...]) -> dict[Symbol, Box]:
    """Boxes by name alone; what moves and has a word for a name gets the letter of its kind, the word as index."""
    boxes: dict[Symbol, Box] = {symbol: name_box(symbol.name) for symbol in symbols.p}
    kinds: dict[str, Quantity] = {item.name: item for item in flat.named if isinstance(item, Definition)}
    kinds |= {item.name: item for item in (*flat.coordinates, *flat.states, *flat.inputs)}
    names = {item.derivative_of: item for item in flat.inputs if item.derivative_of is not None}
    moving = (*symbols.q, *symbols.z, *(u for u, i in zip(symbols.u, flat.inputs, strict=True) if not i.derivative_of))
    for symbol in moving:
        item = kinds[symbol.name]
        rates = symbol in symbols.q or symbol in symbols.z or symbol.name in names
        boxes[symbol] = _lettered(item) if rates else name_box(symbol.name)
    for symbol in abbreviations:
        known = kinds.get(symbol.name)
        changes = isinstance(known, Definition) and known.variability is Variability.CONTINUOUS
        boxes[symbol] = _lettered(kinds[symbol.name]) if changes else name_box(symbol.name)
    for symbol in symbols.w:
        relation = not symbol.name.isidentifier() and bool(set(symbol.name) & set("<>( "))
        boxes[symbol] = Upright(symbol.name) if relation else name_box(symbol.name)  # a relation in its own words
    return boxes


def _lettered(item: Quantity) -> Box:
    """`lean` of an angle is θ with index lean: dots stand over a letter."""
    box = name_box(item.name)
    base, index = (box.base, box.index) if isinstance(box, Subscript) else (box, None)
    assert isinstance(base, Name)
    if len(base.text) == 1:
        return box
    letter = _KINDS.get(item.unit if item.unit != "1" else item.type_name, "x")
    inside: tuple[Box, ...] = (Upright(base.text),)
    if index is not None:
        inside += (Operator(","), *(index.items if isinstance(index, Row) else (index,)))
    return Subscript(Name(letter), inside[0] if len(inside) == 1 else Row(inside))


def _distinct(boxes: dict[Symbol, Box]) -> dict[Symbol, Box]:
    """Names that would look alike (`a1`, `a[1]`) are set as the model has them."""
    bearers: dict[Box, list[Symbol]] = {}
    for symbol, box in boxes.items():
        bearers.setdefault(box, []).append(symbol)
    return {symbol: box if len(bearers[box]) == 1 else Upright(symbol.name) for symbol, box in boxes.items()}


def _multiplier(base: Box, name: str, rows: tuple[str, ...]) -> Box:
    """`closure(D)[2]` is λ with index D, 2; a multiplier that is alone has no index."""
    if rows == (name,):
        return base
    labels = _PARTS.findall(re.sub(r"closure\((.*?)\)", r"\1", name))
    alone = len(labels) == 1 and labels[0].isdigit()
    return Subscript(base, Number(labels[0]) if alone else Upright(",".join(labels)))
