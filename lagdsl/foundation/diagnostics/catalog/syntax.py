"""Family 01: reading the text."""

from __future__ import annotations

import re

from lagdsl.foundation.diagnostics.catalog.characters import FAHRENHEIT
from lagdsl.foundation.diagnostics.catalog.habits import is_called
from lagdsl.foundation.diagnostics.catalog.row import Row, error, note

ROWS: dict[str, Row] = {
    "E0100": error("{found} does not fit here", label="expected {expected}"),
    "E0101": error("expected `;` after this {what}", label="`;` is missing here", help="insert `;`", fix=";"),
    "E0102": error(
        "unknown statement `{word}`",
        label="no statement begins with this word",
        help="did you mean `{meant}`?",
        fix="{meant}",
    ),
    "E0103": error(
        "a bare equation must be in an `equation` section",
        label="this is an equation, not a declaration",
        help="insert `equation` above line {line}; a new quantity needs its type: `Real x = ...;`",
    ),
    "E0104": error(
        "a unit has one `/`; everything after it divides",
        label="second `/` after the unit `{unit}`",
        help="write the divisor as one group: `m/s2` instead of `m/s/s`; to divide by a variable: `(5 m/s)/s`",
    ),
    "E0105": error("unknown unit `{unit}`", label="not a unit"),
    "E0107": error(
        "comment is not closed", label="this comment runs to the end of the file", help="close it with `*/`"
    ),
    "E0108": error("`{character}` is not part of the language", label="unexpected character"),
    "E0109": error(
        "nested more than {limit} levels deep",
        label="the limit is reached here",
        help="name parts of the expression; a long sum is written `sum(... for i in 1:n)` (each term of a sum written "
        "out counts as a level)",
    ),
    "E0110": error(
        "`{mark}` closes nothing", label="no open bracket before this", help="remove it, or open the bracket"
    ),
    "E0111": error("`{mark}` is never closed", label="opened here", help="insert `{closing}`"),
    "E0112": error(
        "`{mark}` is closed by `{found}`",
        label="`{closing}` is expected here",
        help="write `{closing}`",
        fix="{closing}",
    ),
    "E0113": error("`{block}` has no `end`", label="begins here", help="insert `end {ending};`"),
    "E0114": error(
        "`{kind} {name}` ends with the name `{end_name}`",
        label="expected `{name}`",
        help="write `end {name};`",
        fix="{name}",
    ),
    "E0115": error(
        "`{word}` is a reserved word", label="cannot be used as a name", help="choose another name, such as `{word}_`"
    ),
    "E0116": error(
        "this number is too {extreme}", label="not a number of double precision", help="the range is 5e-324 to 1.7e308"
    ),
    "E0117": error(
        "a statement stands outside of any model",
        label="only models, packages, functions, types and imports stand here",
        help="put it between `model Name` and `end Name;`",
    ),
    "E0118": error(
        "a declaration stands in the `{section}` section",
        label="declared here",
        help="move it above `{section}`; only declarations with a prefix such as `output` may follow",
    ),
    "E0119": error(
        "`{word}` begins a statement here, it is not the variable",
        label="read as the keyword `{word}`",
        help="write the other side first: `... = {word}{rest};`",
    ),
    "E0120": error(
        "`end {found}` closes nothing",
        label="no `{found}` is open here",
        help="delete it, or write the beginning that is missing",
    ),
    "E0121": error("only functions can be called", label="this is not a function", help="for a product write `*`"),
    "E0122": error(
        "the size of an array follows the name", label="after the type", help="write `{type_name} {name}{size}`"
    ),
    "E0123": error("expected `{word}`", label="`{word}` is missing here", help="insert `{word}`", fix=" {word}"),
    "E0124": error("this {what} is longer than {limit} characters", label="too long", help="shorten it"),
    "E0125": error("relations do not chain", label="second relation", help="write `a < b and b < c`"),
    "E0126": error("text in quotes is not closed", label="opened here", help='close it with `"` on the same line'),
    "E0127": error(
        "a number has no members", label="after a number", help="digits must follow the decimal point: `1.0`"
    ),
    "E0130": error(
        "{name} is larger than {limit} characters and is not read",
        help="split the model into several files and `import` them",
    ),
    "E0131": error("{name} is not a text in UTF-8 (byte {position})", help="save it in the encoding UTF-8"),
    "E0132": error("{name} is a directory", help="give the name of a `.lag` file in it"),
    "E0133": error("{name} does not exist", help="check the name; `lag new NAME` makes a first model"),
    "E0134": error("{name} cannot be read: {reason}", help="check the permissions of the file"),
    "E0135": error("{name} contains no model", help="a model is written `model Name ... end Name;`"),
    "E0136": error(
        "{name} contains the character NUL (position {position}) and is not a model text", help="give a `.lag` file"
    ),
    "E0137": error(
        "the text contains invisible characters that change how it is displayed ({codes})",
        label="here, or beside it",
        help="remove them; a string with letters from right to left may contain direction marks, each closed in it",
    ),
    "E0138": error(
        "more than {limit} brackets are open",
        label="one more than the limit",
        help="name parts of the expression",
    ),
    "E0139": error("this statement is not complete", label="expected {expected}", help="complete it or delete it"),
    "N0106": note("`{literal}` is a number with a unit, not a product with {names}; write `{meant}` for the product"),
    "N0199": note("stopped after {count} errors", help="repair the first ones; later ones often follow from them"),
}


_LONGEST = 40  # characters of a number that is shown rewritten
_GROUP = re.compile(r"\d{3}(?:\.\d+)?(?: .*)?")
_ATTRIBUTES = ("start", "fixed", "min", "max", "nominal")
_FOREIGN_UNITS = {
    **dict.fromkeys(("kp", "kgf"), (9.80665, "N")),
    **dict.fromkeys(("lbs", "lbm", "pound", "pounds"), (1.0, "lb")),
    **dict.fromkeys(("oz", "ounce", "ounces"), (28.349523125, "g")),
    **dict.fromkeys(("slug", "slugs"), (14.59390294, "kg")),
    **dict.fromkeys(("lbsf", "lbfs"), (1.0, "lbf")),
    **dict.fromkeys(("feet", "feets", "foot"), (1.0, "ft")),
    **dict.fromkeys(("yard", "yards"), (1.0, "yd")),
    **dict.fromkeys(("mi", "miles"), (1.0, "mile")),
    **dict.fromkeys(("nmi", "NM"), (1.852, "km")),
    **dict.fromkeys(("thou", "mil", "mils"), (0.0254, "mm")),
    "mph": (1.0, "mile/h"),
    **dict.fromkeys(("knot", "knots", "kt", "kts"), (1.0, "kn")),
    "ksi": (1000.0, "psi"),
    **dict.fromkeys(("Torr", "torr", "mmHg"), (133.3223684, "Pa")),
    "PS": (735.49875, "W"),
    **dict.fromkeys(("HP", "horsepower"), (1.0, "hp")),
    "kWh": (3.6, "MJ"),
    "Wh": (3.6, "kJ"),
    **dict.fromkeys(("BTU", "Btu"), (1055.05585262, "J")),
    **dict.fromkeys(("calorie", "calories"), (1.0, "cal")),
    "keV": (1000.0, "eV"),
    "MeV": (1e6, "eV"),
    "dyn": (1e-5, "N"),
    **dict.fromkeys(("arcminute", "arcminutes"), (1.0, "arcmin")),
    **dict.fromkeys(("arcsecond", "arcseconds"), (1.0, "arcsec")),
    "gon": (0.9, "deg"),
    **dict.fromkeys(("U/min", "r/min", "1/min", "rev/min", "RPM", "upm"), (1.0, "rpm")),
    **dict.fromkeys(("gr", "gram", "grams"), (1.0, "g")),
    **dict.fromkeys(("mtr", "meter", "meters", "metre", "metres"), (1.0, "m")),
    **dict.fromkeys(("grad", "Grad", "grd"), (1.0, "deg")),
    **dict.fromkeys(("sec", "secs", "second", "seconds", "Sek", "sek"), (1.0, "s")),
    **dict.fromkeys(("percent", "pct"), (1.0, "%")),
    **dict.fromkeys(("turn", "turns"), (1.0, "rev")),
}
"""Units that the language has not, with what they are."""


_ANNOTATION = "delete it: an annotation stands by itself in its class, `annotation(experiment(StopTime = 5));`"


_FAHRENHEIT = re.compile(r"(?<![A-Za-z])(?:degF|[Ff]ahrenheit)(?![A-Za-z])")


def foreign_unit(number: str, word: str) -> str | None:
    """The quantity in a unit of the language for a number with another one: `98.0665 N` for `10 kp`."""
    if word not in _FOREIGN_UNITS or len(number) > _LONGEST:
        return None
    size, unit = _FOREIGN_UNITS[word]
    return f"{float(number) * size:.10g} {unit}".strip()


def unit_help(suggestion: str | None, number: str, word: str) -> str:
    """Help of E0105."""
    if _FAHRENHEIT.search(word):
        return FAHRENHEIT
    if word == "do":
        return "write `loop` behind a range, `then` behind a condition"
    if word == "annotation":
        return _ANNOTATION
    if word in ("mod", "rem"):
        return f"the remainder is a function: `mod({number}, ...)`" if len(number) <= _LONGEST else "write `mod(a, b)`"
    if word[:1] == "_" and word[1:].replace("_", "").isdigit() and len(number + word) <= _LONGEST:
        return f"digits are not grouped: write `{number}{word.replace('_', '')}`"
    if suggestion is None and len(number + word) > _LONGEST:
        return "for a product write `*`"
    if word == "f" and not number.isdigit():
        return f"a number has no letter for its type: `{number}`"
    product = f"for a product write `{number}*{word}`"
    if suggestion is not None and len(word) == 1:
        return f"{product}; if the unit is meant, `{number} {suggestion}`"
    return product if suggestion is None else f"did you mean `{suggestion}`?"


def unexpected_help(before: str, found: str, after: str, expected: str) -> str | None:
    """Help of E0100, from the texts of the token before, of the one at fault and of the next, and what is expected."""
    told = _WORDS.get(found) or _PAIRS.get((before, found))
    if told is not None:
        return told
    if found == "in" and re.fullmatch(r"\d[\d.]*", before) and len(before) <= _LONGEST:
        return f"write `{before} inch`"
    if found in ("**", ".^"):
        return f"a power is written `^`: `{before}^{after}`" if _short(before, after) else "a power is written `^`"
    if found == "." and "expression" in expected:
        return f"digits stand before the decimal point: `0.{after if after[:1].isdigit() else 5}`"
    if before.isdigit() and _GROUP.fullmatch(found) and len(before) <= 3:
        return f"digits are not grouped: `{before}{found}`"
    if found in _ATTRIBUTES and before.isidentifier():
        value = after if after not in ("", "=") and len(after) <= _LONGEST and after.isprintable() else "..."
        return f"attributes stand in brackets: `{before}({found} = {value})`"
    if is_called(before) and after != ")":
        return f"call it: `{before}({found})`"
    return _equals_help(before, found, after, expected) or _missing_mark(before, found, after, expected)


def _equals_help(before: str, found: str, after: str, expected: str) -> str | None:
    """Help around `=`, and for brackets that are none."""
    whole = "a description in quotes" in expected
    match (before, found):
        case (_, ":") if after == "=" or "`=`" in expected:
            labels = whole and after != "="
            ending = "; labels stand in `constraint` and `contact` only" if labels else ""
            return f"an equation or binding is written with `=`{ending}"
        case ("==", "="):
            return "equality of two values is written `==`"
        case ("^", "^"):
            return "a power has one `^`"
        case (("=" | "<" | ">"), "="):
            return "an equation or binding has one `=`; relations are `<=`, `>=`, `==` and `<>`"
        case (("+" | "-" | "*" | "/"), "="):
            return "an equation is no assignment; in a `when` clause a counter is written `n = pre(n) + 1`"
        case (_, ":") if "`]`" in expected:
            return "a range stands in an index or behind `in`; an array is `{1, 2, 3}`"
        case (_, "=") if whole:
            return "an equation has one `=`: write two equations"
        case ("{", "}"):
            return "an array has elements; delete what needs none"
        case (_, "{") if before[-1:] == "_" and after.isalnum():
            return f"write the index as a part of the name: `{before}{after}`"
        case (_, "<") if "expression" in expected:
            return "components stand in braces: `{x, y}`"
        case (_, ";") if expected.startswith("`else`"):
            return "a value needs both branches: `if condition then a else b`"
        case _:
            return None


def _missing_mark(before: str, found: str, after: str, expected: str) -> str | None:
    """Help where a mark may be missing between two operands."""
    operand = found[:1].isalnum() or found[:1] == '"'
    if "operator" in expected and before[-1:] == "%" and operand:
        return f"`{before}` is a percentage: the remainder is `mod(a, b)`, a comment begins with `//`"
    if "operator" in expected and before[:1].isdigit() and found[:1].isdigit():
        return "a comma or an operator stands between two numbers"
    if "operator" in expected and operand:
        if _short(before, found) and before not in _PLACES and found[:1].isalpha():
            call = "(...)" if after == "(" else ""
            return f"an operator may be missing: a product is written `{before}*{found}{call}`"
        return "an operator may be missing: a product is written with `*`"
    if "`=`" in expected and before in _DECLARATIONS and found[:1].isupper():
        return f"a declaration ends with `;`: write `; {before} {found}`"
    if before in _PREFIXES and "`=`" in expected:
        return f"`{before}` stands before the type: `{before} Length {found}`" if _short(found) else None
    if "`=`" in expected and operand and before.isidentifier() and found not in _PLACES:
        return f"`=` may be missing: `{before} = {found}`"
    return None


_DECLARATIONS = ("parameter", "constant", "structural", "input", "output", "coordinate", "state", "discrete")
_WORDS = {
    "elif": "write `elseif`",
    "elsif": "write `elseif`",
    "else": "an expression is written `if condition then a else b`",
    "annotation": _ANNOTATION,
}
_COUNTER = "a value follows; in a `when` clause a counter is written `n = pre(n) + 1`"
_PAIRS = {
    ("+", ";"): _COUNTER,
    ("-", ";"): _COUNTER,
    ("-", ">"): "a member stands behind a dot: `a.b`",
    (")", "{"): "blocks have words: `if condition then ... end if;`, `for i in 1:n loop ... end for;`",
    (";", "<"): "this is no statement; `lag import FILE` makes a model of a URDF or MJCF file",
}
"""Help by the token before and the one at fault."""
_PLACES = ("at", "on", "from", "to", "with")
_PREFIXES = ("parameter", "constant", "input", "output", "discrete")


def _short(*words: str) -> bool:
    """True if the words are names or numbers that fit into a message."""
    return all(word.replace(".", "").isalnum() and word.isascii() and len(word) <= 20 for word in words)
