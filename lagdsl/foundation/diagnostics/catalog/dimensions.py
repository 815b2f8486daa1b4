"""Family 04: dimensions and units."""

from lagdsl.foundation.diagnostics.catalog.row import Row, error, warning

# Help of E0401 where a factor made of parameters is what is missing.
MISSING_FACTOR = "the {which} term is short by `{unit}`; a factor `{factor}` would make it {words}"

# Phrases for a bare number beside a quantity, by operation.
BESIDE = {
    "add": "added to",
    "subtract": "in a difference with",
    "compare": "compared with",
    "equate": "equated with",
    "": "together with",
}

ROWS: dict[str, Row] = {
    "E0401": error("cannot {verb} {left} and {right}", help="check the formula: both sides need the same dimension"),
    "E0402": error(
        "{function} needs an angle or a number, this is {found}",
        label="this is {found}",
        help="divide it by a reference value of the same dimension",
    ),
    "E0403": error(
        "a {keyword} on {target} must be {expected}, this is {found}",
        label="this is {found}",
        help="check the formula: it must give {expected}",
    ),
    "E0404": error(
        "`{keyword}` must be {expected}, this is {found}",
        label="this is {found}",
        help="check the formula: it must give {expected}",
    ),
    "E0405": error(
        "bare `{number}` {preposition} {words}",
        label="a number without a unit",
        help="write `{number} {unit}`",
        fix="{number} {unit}",
    ),
    "E0406": error(
        "`{unit}` is not a coherent SI unit; values are kept in SI",
        label="not a coherent unit",
        help='write `unit = "{coherent}"`; `displayUnit = "{unit}"` shows values in it',
    ),
    "E0407": error(
        "{what} is declared as {expected}, its value is {found}",
        label="this is {found}",
        help="change the type, or check the formula of the value",
    ),
    "E0408": error(
        "an exponent must be a number, this is {found}",
        label="this is {found}",
        help="divide it by a reference value of the same dimension",
    ),
    "E0409": error(
        '`annotation(units = "none")` switches units off here', label="a unit", help="write the number without a unit"
    ),
    "E0410": error(
        "`{unit}` does not fit `{type}`, which is {words} [{own}]",
        label="another dimension",
        help="write a unit of {words}",
    ),
    "E0411": error(
        "{what} is an angular velocity, and Hz counts turns",
        label="a frequency",
        help="write `rev/s` for turns per second or `rad/s`",
    ),
    "E0412": error("{found} is a `{noun}`, not a `{keyword}`", label="{found}", help="write `{noun} ... on {target}`"),
    "E0413": error("unknown unit `{unit}`", label="not a unit"),
    "E0414": error(
        "a power of {found} needs a fixed exponent",
        label="must be a literal number or ratio",
        help="make the base dimensionless first",
    ),
    "E0415": error(
        "{what} must be {expected}, this is {found}",
        label="this is {found}",
        help="check the formula: it must give {expected}",
    ),
    "E0416": error(
        "a torque acts on a frame or an angle, not at a point", label="a point", help="write `torque ... on F`"
    ),
    "E0417": error(
        "a force on frame `{frame}` needs a point to act at",
        label="a frame",
        help="write `force ... at P on {frame}`, or `torque` for a moment",
    ),
    "E0418": error(
        "`{literal}` is a point on a scale whose zero is not 0 K, and {where} needs an amount",
        label="a point, not an amount",
        help="write `{number} K` for a difference, `{kelvin} K` for the temperature",
    ),
    "E0420": error(
        "{what} is a frequency, and `{unit}` counts angles",
        label="an angular velocity",
        help="write Hz, as 60 rpm are 1 Hz, or declare an `AngularVelocity`",
    ),
    "W0421": warning(
        "`{what}` has no unit: it is {reading}",
        label="a number without a unit",
        help="write {ways}",
    ),
}
