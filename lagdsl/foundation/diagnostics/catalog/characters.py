"""Characters that are no part of the language, and what is written instead: help of E0108."""

from __future__ import annotations

import re
import unicodedata

FAHRENHEIT = "degrees Fahrenheit are not known: a temperature is `(F - 32)/1.8` in degC, a difference `F/1.8` in K"

_HELP = {
    "&&": "write `and`",
    "&": "write `and`",
    "||": "write `or`; the amount of a vector is `norm(v)`",
    "|": "write `abs(x)` for the amount of a number, `norm(v)` for that of a vector",
    "!": "write `not`",
    "~": "write `not`",
    "!=": "write `<>`",
    "~=": "write `<>`",
    "≠": "write `<>`",
    "≤": "write `<=`",
    "≥": "write `>=`",
    "%": "a comment begins with `//`, the remainder is `mod(a, b)`, a percentage is a number with the unit `%`: `5 %`",
    "‰": "write a number: `0.005`",
    "#": "a comment begins with `//`",
    "?": "write `if condition then a else b`",
    "'": 'text stands in double quotes: "..."; the rate of x is `der(x)`',
    "\\": 'write text as it is meant; `\\` has a meaning inside of "..." only',
    "@": "a place stands behind `at`: `mass m at {x, y};`",
    "$": "names consist of the letters a to z, digits and `_`",
    "`": "write names without quotes",
    "“": 'text stands in straight double quotes: "..."',
    "”": 'text stands in straight double quotes: "..."',
    "„": 'text stands in straight double quotes: "..."',
    "«": 'text stands in straight double quotes: "..."',
    "»": 'text stands in straight double quotes: "..."',
    "−": "write the minus of the keyboard: `-`",
    "–": "write the minus of the keyboard: `-`",
    "—": "write the minus of the keyboard: `-`",
    "·": "write `*` for a product",
    "⋅": "write `*` for a product",
    "∙": "write `*` for a product",
    "•": "write `*` for a product",
    "∗": "write `*` for a product",
    "×": "write `*` for a product, `cross(a, b)` for a vector product",
    "÷": "write `/`",
    "∕": "write `/`",
    "√": "write `sqrt(x)`",
    "²": "write `^2`",
    "³": "write `^3`",
    "¹": "write `^1`",
    "⁻": "write the exponent behind `^`: `x^-1`",
    "½": "write `0.5`",
    "¼": "write `0.25`",
    "¾": "write `0.75`",
    "°": "write the unit `deg`",
    "°C": "write the unit `degC`",
    "°F": FAHRENHEIT,
    "∂": "the derivative by time is `der(x)`; the compiler forms all others itself",
    "∞": "write `inf`",
    "π": "write `pi`",
    "∈": "write `in`",
    "→": "write `->`",
    "\u00a0": "write a plain blank; this one came with copied text",
    "\u200b": "delete the invisible character; it came with copied text",
    "\ufeff": "remove the byte order mark inside the text",
}
_OTHERWISE = "delete it; operators are `+ - * / ^`, relations `< <= > >= == <>`"
_LONGEST = 40  # characters of a text that is shown rewritten
_PRIMES = re.compile(r"['′’´`]+|″")
_QUOTED = re.compile(r"'([^'\n]*)'|[“„«”]([^\n]*)[”“»]|‘([^\n]*)’")
_BARS = re.compile(r"\|([^|\n;]+)\|")
_PERCENT = re.compile(r"%([A-Za-z]\w*)")
_NUMBER_BEFORE = re.compile(r"([0-9]+(?:\.[0-9]+)?)[ \t]*$")
_NAME_BEFORE = re.compile(r"(?<![0-9.A-Za-z_])(?<![0-9] )[A-Za-z_][A-Za-z0-9_]*$")
_UNIT_BEFORE = re.compile(r"[0-9] ?((?:[A-Za-z][A-Za-z0-9./(]*)?[A-Za-z])$")
_PRODUCTS = ("·", "⋅", "∙", "•", "∗")
_EXPONENTS = ("²", "³")
_LATEX = re.compile(r"\\([A-Za-z]+)(?:\{([^{}]*)\}|\\([A-Za-z]+))?(?:\{([^{}]*)\})?")
_LATEX_DOTS = {"dot": 1, "ddot": 2}
_LATEX_MARKS = {"cdot": "*", "times": "*", "le": "<=", "leq": "<=", "ge": ">=", "geq": ">=", "ne": "<>", "neq": "<>"}
_LATEX_MARKS |= {"varphi": "phi", "vartheta": "theta", "infty": "inf", "left": "(", "right": ")", "circ": " deg"}


def character_help(text: str, before: str) -> str:
    """Help: the text to write instead of `text`, which begins with a character that is not part of the language.

    `before` is what stands before it on its line.
    """
    if len(text) > _LONGEST:
        return _HELP.get(text[0]) or _OTHERWISE
    if match := _LATEX.fullmatch(text):
        return _latex(match)
    if not text.isprintable():
        return _HELP.get(text) or _letters(text) or _OTHERWISE
    if (way := _inside_of_word(text, before)) is not None:
        return way
    operand = re.search(r"[A-Za-z_][A-Za-z0-9_.]*(?:\[[^\]]*\])?$|der\([^()]*\)$", before)
    if _PRIMES.fullmatch(text) and operand is not None:
        return f"write `{_rate(operand[0], 2 if text == '″' else len(text))}`"
    if match := _QUOTED.fullmatch(text):
        return f'text stands in straight double quotes: "{match[1] or match[2] or match[3] or ""}"'
    if match := _BARS.fullmatch(text):
        return f"write `abs({match[1].strip()})` for the amount of a number, `norm(v)` for that of a vector"
    if match := _PERCENT.fullmatch(text):
        return _of_percent(match[1], before)
    if text[0] == "°" and text not in ("°C", "°F") and (number := _NUMBER_BEFORE.search(before)):
        return f"write the unit `deg{text[1:]}`: `{number[1]} deg{text[1:]}`"
    if text == "'" and _NUMBER_BEFORE.search(before):
        return "digits are not grouped: write the number without marks"
    if text == "%" and (number := _NUMBER_BEFORE.search(before)):
        return f"the remainder is `mod({number[1]}, b)`; a percentage ends with its unit: `{number[1]} %`"
    return _HELP.get(text) or _HELP.get(text[0]) or _letters(text) or _OTHERWISE


def _of_percent(name: str, before: str) -> str:
    """`a %b`: a remainder behind an operand, else a name with a mark."""
    number = _NUMBER_BEFORE.search(before)
    return f"the remainder is `mod({number[1]}, {name})`" if number else f"write `{name}`"


def _inside_of_word(text: str, before: str) -> str | None:
    """`Länge`, `N·m`, `m²`: the rest of a name or of a unit that has begun."""
    word = _NAME_BEFORE.search(before)
    if word is not None and text[0].isalpha() and (spelled := _umlauts(text)).isascii():
        return f"names consist of the letters a to z, digits and `_`: write `{word[0]}{spelled}`"
    unit = _UNIT_BEFORE.search(before)
    if unit is None:
        return None
    if text[0] in _EXPONENTS:
        return f"write the unit `{unit[1]}{unicodedata.normalize('NFKC', text)}`"
    return "units of a product are joined by `.`, as in `N.m`" if text in _PRODUCTS else None


def _latex(match: re.Match[str]) -> str:
    r"""`\theta`, `\dot{x}`, `\frac{a}{b}`."""
    word, argument, second = match[1], match[2] or match[3] or "x", match[4] or "y"
    if word in _LATEX_DOTS:
        return f"write `{_rate(argument, _LATEX_DOTS[word])}`"
    if word in ("frac", "tfrac", "dfrac"):
        return f"write a quotient: `({argument})/({second})`"
    if word == "sqrt":
        return f"write `sqrt({argument})`"
    return f"names and functions stand without `\\`: write `{_LATEX_MARKS.get(word, word)}`"


def _rate(operand: str, times: int) -> str:
    return "der(" * times + operand + ")" * times


def _letters(text: str) -> str | None:
    """Letters that are not those of the keyboard: dotted, Greek, of full width."""
    plain = unicodedata.normalize("NFKC", text)
    if plain.isascii() and plain.isprintable() and plain.strip():
        return f"write `{plain}` as the keyboard has it"
    if plain.isspace():
        return "write a plain blank; this one came with copied text"
    if not text[0].isalpha():
        return None
    decomposed = unicodedata.normalize("NFD", text)
    if dots := {"\u0307": 1, "\u0308": 2}.get(decomposed[1:2]):
        return f"write `{_rate(_latin(decomposed[0] + decomposed[2:]), dots)}`"
    spelled = _latin(plain)
    if plain == "Ω":
        return "write the unit `Ohm`; a name such as `Omega` for the letter"
    if plain[0] == "μ" and plain[1:] in ("m", "s", "g", "A", "C", "F", "H"):
        return f"write the unit `u{plain[1:]}`; a name such as `mu` for the letter"
    if spelled == plain:
        return "names consist of the letters a to z, digits and `_`"
    return f"names consist of the letters a to z, digits and `_`: write `{spelled}`"


def _umlauts(text: str) -> str:
    """`aenge` for `änge`, as German writes it without dots; other letters without their accents."""
    decomposed = unicodedata.normalize("NFD", text.replace("ß", "ss")).replace("\u0308", "e")
    return "".join(_latin(letter) for letter in decomposed if not unicodedata.combining(letter))


def _latin(text: str) -> str:
    """The names of Greek letters instead of them; letters without their accents."""
    found = []
    for character in text:
        name = unicodedata.name(character, "")
        greek = re.match(r"GREEK (SMALL|CAPITAL) LETTER ([A-Z]+)|GREEK ([A-Z]+) SYMBOL$", name)
        if greek is None:
            plain = unicodedata.normalize("NFD", character)[0]
            found.append(plain if plain.isascii() else character)
        else:
            letter = (greek[2] or greek[3]).lower().replace("lamda", "lambda")
            found.append(letter.capitalize() if greek[1] == "CAPITAL" else letter)
    return "".join(found)
