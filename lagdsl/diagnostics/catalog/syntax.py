"""Family 01: reading the text."""

from lagdsl.diagnostics.catalog.row import Row, error, note

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
    "E0108": error("`{character}` is no part of the language", label="unexpected character"),
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
        "{name} contains the character NUL (position {position}) and is no model text", help="give a `.lag` file"
    ),
    "E0137": error(
        "the text contains invisible characters that change its direction ({codes})",
        label="here, or beside it",
        help="remove them; they may stand in a string with letters from right to left, each closed in it",
    ),
    "E0138": error(
        "more than {limit} brackets are open",
        label="one more than the limit",
        help="name parts of the expression",
    ),
    "N0106": note("`{literal}` is a number with a unit, not a product with {names}; write `{meant}` for the product"),
    "N0199": note("stopped after {count} errors", help="repair the first ones; later ones often follow from them"),
}

_CHARACTER_HELP = {
    "&&": "write `and`",
    "||": "write `or`",
    "!": "write `not` before a condition, `<>` for unequal",
    "%": "write a percentage as a number: `0.05`; a comment begins with `//`",
    "#": "a comment begins with `//`",
    "?": "write `if condition then a else b`",
    "|": "write `abs(x)` for the amount of a number, `norm(v)` for that of a vector",
    "'": 'text stands in double quotes: "..."; the rate of x is `der(x)`',
    "“": 'text stands in straight double quotes: "..."',
    "”": 'text stands in straight double quotes: "..."',
    "−": "write the minus of the keyboard: `-`",
    "–": "write the minus of the keyboard: `-`",
    "·": "write `*` for a product",
    "×": "write `*` for a product, `cross(a, b)` for a vector product",
    "²": "write `^2`",
    "³": "write `^3`",
    "°": "write the unit `deg`",
    "µ": "write the prefix `u`: `um` is a micrometre",
    "Ω": "write the unit `Ohm`",
    "\ufeff": "remove the byte order mark inside the text",
}


def character_help(text: str) -> str | None:
    """Help of E0108: what to write instead of `text`, which begins with a character that is no part of the language."""
    known = _CHARACTER_HELP.get(text, _CHARACTER_HELP.get(text[0]))
    if known is None and text[0].isalpha():
        return "names consist of the letters a to z, digits and `_`: `theta` instead of a Greek letter"
    return known


def unit_help(suggestion: str | None, number: str, word: str) -> str:
    """Help of E0105."""
    if suggestion is not None:
        return f"did you mean `{suggestion}`?"
    return f"for a product write `{number}*{word}`"


def unexpected_help(after: str, found: str, expected: str) -> str | None:
    """Help of E0100, from the texts of the token before and of the one at fault and from what is expected."""
    match (after, found):
        case (_, ":"):
            return "an equation or binding is written with `=`"
        case ("*", "*"):
            return "a power is written `^`"
        case (("=" | "<" | ">"), "="):
            return "relations are `<=`, `>=`, `==` and `<>`"
        case (_, ("elif" | "elsif")):
            return "write `elseif`"
        case (_, ".") if "expression" in expected:
            return "digits stand before the decimal point: `0.5`"
        case (_, ",") if after.isdigit():
            return "a number has a decimal point, not a comma: `0.5`"
        case _:
            pass
    if "operator" in expected and (found[:1].isalnum() or found[:1] == '"'):
        return "an operator may be missing: a product is written with `*`"
    return None
