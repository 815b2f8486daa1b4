"""Words of other languages, Modelica, SymPy, MATLAB, Python, and what this language writes for them."""

from __future__ import annotations

_RATE = "the rate of a quantity is `der({0})`"
_DECLARED = "declare the quantity: `coordinate Angle q;` or `parameter Mass m = 1 kg;`"
_ANGLE = "the unit makes an angle of the number: `{0} deg`"
_PICTURE = "a model prints nothing: declare an `output`; `lag run FILE --plot motion.png` draws it"
_COMMAND = "a model has no commands: `lag run FILE` computes the motion, `--plot motion.png` draws it"
_INTEGRAL = "an integral is a state: `state Real z(start = 0);`, with `der(z) = {0};` in an `equation` section"
_PLACED = "a position is a point, its velocity follows: `point P = world.point({{x, y}});`"
_TURNED = "a frame turns another one: `frame A = world.rotz(theta);`"
_SOLVED = "nothing is solved by hand: the compiler forms and solves the equations of motion"

# Functions by name; {0}, {1} are the texts of the arguments.
_FUNCTIONS = {
    **dict.fromkeys(("diff", "ddt", "D", "Derivative", "deriv", "derivative", "d", "dt", "dot", "rate"), _RATE),
    **dict.fromkeys(("ddot", "der2", "diff2"), "the second derivative is `der(der({0}))`"),
    **dict.fromkeys(("deg", "deg2rad", "radians", "from_deg", "to_rad", "toRad"), _ANGLE),
    **dict.fromkeys(("rad2deg", "degrees", "to_deg"), "results are shown in degrees by `displayUnit`"),
    **dict.fromkeys(("sind", "cosd", "tand"), "the unit makes an angle of the number: `{function}({0} deg)`"),
    "rad": "angles are in radians: write `{0} rad`",
    "ln": "the natural logarithm is `log({0})`",
    **dict.fromkeys(("pow", "power"), "a power is written `{0}^{1}`"),
    **dict.fromkeys(("square", "sqr"), "a power is written `{0}^2`"),
    **dict.fromkeys(("fabs", "Abs"), "write `abs({0})`"),
    **dict.fromkeys(("sgn", "signum"), "write `sign({0})`"),
    **dict.fromkeys(("Heaviside", "heaviside", "step", "stepfun"), "write `if {0} > 0 then 1 else 0`"),
    **dict.fromkeys(("Symbol", "symbols", "dynamicsymbols", "sym", "syms", "Function"), _DECLARED),
    **dict.fromkeys(("Eq", "equation"), "an equation is written `{0} = {1};` in an `equation` section"),
    **dict.fromkeys(("Matrix", "array", "Array", "Vector", "vector"), "components stand in braces: `{{a, b, c}}`"),
    **dict.fromkeys(("print", "disp", "printf", "fprintf", "display", "plot"), _PICTURE),
    **dict.fromkeys(("solve", "dsolve", "ode45", "odeint", "solve_ivp", "fsolve"), _SOLVED),
    **dict.fromkeys(("simplify", "expand", "subs", "lambdify", "LagrangesMethod", "KanesMethod"), _SOLVED),
    **dict.fromkeys(("integral", "integrate", "cumtrapz", "trapz"), _INTEGRAL),
    **dict.fromkeys(("Point", "set_pos", "set_vel", "locatenew"), _PLACED),
    **dict.fromkeys(("ReferenceFrame", "orientnew", "orient", "orient_axis"), _TURNED),
    **dict.fromkeys(("rotx", "roty", "rotz"), "a frame turns another one: `world.{function}({0})`"),
    **dict.fromkeys(("wrapToPi", "wrap_to_pi", "unwrap"), "an angle between -180 and 180 degrees is `wrap({0})`"),
    **dict.fromkeys(("saturate", "saturation", "sat", "clamp", "clip"), "write `limit(x, low, high)`"),
    **dict.fromkeys(("mag", "magnitude", "vecnorm"), "write `norm({0})`"),
    **dict.fromkeys(("rem", "fmod"), "the remainder is `mod({0}, {1})`, with the sign of the divisor"),
    **dict.fromkeys(("round", "rint", "nint"), "write `floor({0} + 0.5)`"),
    **dict.fromkeys(("int", "integer", "Integer", "fix"), "write `floor({0})` for the whole part"),
    "ceiling": "write `ceil({0})`",
    "hypot": "write `norm({{{0}, {1}}})`",
    "cot": "write `1/tan({0})`",
    "log2": "write `log({0})/log(2)`",
    "Rational": "write `{0}/{1}`",
    **dict.fromkeys(("range", "arange"), "a range is written `1:n`"),
}  # fmt: skip

# Names by text; what stands in the place of a value.
_NAMES = {
    "t": "the time is `time`",
    "True": "write `true`",
    "False": "write `false`",
    **dict.fromkeys(("M_PI", "PI", "Pi"), "write `pi`"),
    "None": "leave the value out",
    "e": "Euler's number is `exp(1)`; a power of it is `exp(x)`",
    "g": "standard gravity is `g_n`",
    "g0": "standard gravity is `g_n`",
    "Inf": "write `inf`",
    "oo": "write `inf`",
    "infinity": "write `inf`",
    **dict.fromkeys(("d", "dt"), "the rate of x is `der(x)`"),
    **{
        name: f"the unit vectors are `world.x`, `world.y` and `world.z`: write `world.{axis}`"
        for axis, names in {"x": ("i", "ex", "e_x"), "y": ("j", "ey", "e_y"), "z": ("k", "ez", "e_z")}.items()
        for name in names
    },
    "N": "the frame that stands still is `world`",
}

_POWERS = ("pow", "power", "square", "sqr")
_PACKAGES = ("np", "sp", "sy", "sm", "me", "math", "numpy", "sympy", "scipy", "Math")
_NOT_NEEDED = "delete the import: functions such as `sin` and the constants `pi` and `g_n` are known without it"

_REAL = "numbers are `Real`; better, name the quantity: `Length`, `Mass`, `Angle`"
_ARRAY = "an array has its size after the name: `Length v[3] = {x, y, z};`; a position is a `point`"
_ORDER = "equations have no order: write them in an `equation` section, without `algorithm`"

# Words in the place of a type, or of a keyword that begins a statement.
_WORDS = {
    **dict.fromkeys(("float", "double", "real", "number", "scalar"), _REAL),
    **dict.fromkeys(("int", "integer", "long"), "whole numbers are `Integer`"),
    **dict.fromkeys(("bool", "boolean", "logical"), "truth values are `Boolean`"),
    **dict.fromkeys(("str", "string", "char"), "texts are `String`"),
    **dict.fromkeys(("let", "var", "auto", "variable"), "a declaration begins with its type: `Real x = ...;`"),
    **dict.fromkeys(("syms", "sym", "symbols"), "declare each quantity with its type: `coordinate Angle q;`"),
    "const": "write `constant`",
    **dict.fromkeys(("param", "params", "Parameter", "parameters"), "write `parameter`"),
    **dict.fromkeys(("coord", "coords", "coordinates", "dof"), "write `coordinate`"),
    **dict.fromkeys(("Vector", "vector", "vec"), _ARRAY),
    **dict.fromkeys(("Matrix", "matrix"), "an array has its size after the name: `Real A[2,2] = [1, 2; 3, 4];`"),
    "inner": "there is no `inner`: `world` and gravity are known in every component",
    "outer": "there is no `outer`: `world` and gravity are known in every component",
    "algorithm": _ORDER,
    "protect": "write `protected`",
    "while": "loops run over indices: `for i in 1:n loop ... end for;`",
    **dict.fromkeys(("def", "lambda", "fun", "func"), "a function is written `function f(Real x) -> Real = 2*x;`"),
    "encapsulated": "delete it: a class knows what surrounds it",
    "external": "a function is one expression of this language: `function f(Real x) -> Real = 2*x;`",
    **dict.fromkeys(("clear", "clc", "close", "clearvars"), "delete it: a model has no commands"),
    **dict.fromkeys(("struct", "dataclass"), "write `record Name ... end Name;`"),
    **dict.fromkeys(("hinge", "revolute"), "a hinge is a component: `lag explain Revolute`"),
    **dict.fromkeys(("slider", "prismatic"), "a slider is a component: `lag explain Prismatic`"),
    "gear": "a gear is a component: `lag explain Gear`",
    "motor": "a motor is a component: `lag explain DCMotor`",
    "class": "write `model Name ... end Name;`",
    "from": "write `import Package.*;`",
    "spring": "a spring is an energy: `potential 1/2*k*s^2;` of its extension; or a component: `lag explain Spring`",
    "damper": "a damper is a dissipation: `dissipation 1/2*d*der(s)^2;`; or a component: `lag explain Damper`",
    "damping": "viscous friction is a dissipation: `dissipation 1/2*d*der(s)^2;`",
    **dict.fromkeys(("moment", "couple"), "write `torque`: `torque value on angle;`"),
    "load": "write `force` or `torque`: `force vector at point;`",
    "energy": "write `kinetic` or `potential`: `kinetic T = 1/2*m*v^2;`",
    "particle": "write `mass`: `mass m at {x, y};`",
    "rigidbody": "write `body`: `body b(m = 1 kg, Izz = 1 kg.m2) on frame;`",
    "vel": "a velocity is the rate of a position: `der(x)` or `vel(P)`",
}  # fmt: skip

_SPEED = "write `Velocity`, for a rotation `AngularVelocity`"
_STIFF = "write `Stiffness`, for a rotation `RotationalStiffness`"
_DAMPED = "write `Damping`, for a rotation `RotationalDamping`"

# Words in the place of a type, for the types that need no import.
_TYPES = {
    **dict.fromkeys(("Float", "Double", "Number", "Scalar"), _REAL),
    "Speed": _SPEED,
    **dict.fromkeys(("AngularSpeed", "RotationalSpeed", "RotationSpeed"), "write `AngularVelocity`"),
    **dict.fromkeys(("SpringConstant", "SpringStiffness", "SpringRate", "LinearStiffness"), _STIFF),
    **dict.fromkeys(("DampingConstant", "TranslationalDamping", "LinearDamping"), _DAMPED),
    "TranslationalStiffness": _STIFF,
    "Gravity": "write `Acceleration`; what acts on all masses is a statement: `gravity = -g_n*world.y;`",
    "Moment": "write `Torque`; of masses `Inertia`",
    "Displacement": "write `Length`",
    **dict.fromkeys(("Friction", "FrictionCoefficient"), "write `CoefficientOfFriction`"),
    **dict.fromkeys(("TorqueConstant", "MotorConstant"), "write `ElectricalTorqueConstant`"),
}

# Forms of statements, for those that are written in another order.
_FORMS = {
    "mass": "`mass m at {x, y};`",
    "body": "`body b(m = 1 kg, Izz = 2 kg.m2) on frame;`",
    "force": "`force vector at point;`, or for a coordinate `force value on x;`",
    "torque": "`torque value on theta;`, or for a frame `torque vector on frame;`",
    "gravity": "`gravity = -g_n*world.y;`",
    "coordinate": "`coordinate Angle theta(start = 30 deg);`",
    "input": "`input Torque tau;`",
    "output": "`output Length x = ...;`",
    "state": "`state Real x(start = 0);`",
    "parameter": "`parameter Mass m = 1 kg;`",
    "constant": "`constant Real k = 2;`",
    "discrete": "`discrete Real n(start = 0);`",
    "constraint": "`constraint x^2 + y^2 = l^2;`",
    "contact": "`contact y >= 0 with restitution = 0.8;`",
    "point": "`point P = {x, y};`",
    "frame": "`frame A = world.rotz(theta);`",
    "kinetic": "`kinetic T = 1/2*m*der(x)^2;`",
    "potential": "`potential V = m*g_n*y;`",
    "dissipation": "`dissipation 1/2*d*der(x)^2;`",
    "lagrangian": "`lagrangian L = ...;`",
    "draw": "`draw rod(radius = 1 cm) from A to B;`",
    "connect": "`connect(a, b);`",
    "function": "`function f(Real x) -> Real = 2*x;`",
    "for": "`for i in 1:3 loop ... end for;`",
    "when": "`when condition then ... end when;`",
    "import": "`import Lag.Planar.*;`",
    "assert": '`assert(condition, "text");` in an `equation` section',
    "initial": "`initial equation`, with equations below it; a start is an attribute: `Angle q(start = 30 deg)`",
}

_COMMANDS = ("plot", "simulate", "sim", "solve", "run", "print", "disp", "display", "animate", "show")
_RATE_MEMBERS = ("dot", "d", "dt", "diff", "der", "prime")
_ENERGIES = {"T": "kinetic", "K": "kinetic", "V": "potential", "U": "potential", "L": "lagrangian", "D": "dissipation"}
_FUNCTIONS_CALLED = frozenset(("der", "sin", "cos", "tan", "asin", "acos", "atan", "sqrt", "exp", "log", "abs", "sign"))

_RATES = {"_ddot": 2, "ddot": 2, "_dot": 1, "dot": 1, "Dot": 1, "_p": 1, "_d": 1, "_prime": 1, "_t": 1}


def function_help(name: str, arguments: tuple[str, ...]) -> str | None:
    """Help: the text to write for a call of a function of another language, with the texts of its arguments."""
    found = _FUNCTIONS.get(name)
    if found == _RATE and arguments[-1:] == ("2",):
        found = _FUNCTIONS["der2"]
    elif name == "dot" and len(arguments) == 2:
        found = "a scalar product is written `{0}*{1}`; the rate of a quantity is `der(q)`"
    if found is None and arguments in (("t",), ("time",)):
        return (
            f"quantities depend on time by themselves: `input Torque {name};` declares one, and `{name}` is its value"
        )
    arguments = tuple(text if text.isalnum() else f"({text})" for text in arguments) if name in _POWERS else arguments
    return None if found is None else found.format(*arguments, "x", "y", function=name.rstrip("d"))


def count_help(name: str, arguments: tuple[str, ...]) -> str | None:
    """Help: the text to write for a call with another number of arguments than the function takes."""
    match (name, arguments):
        case ("atan", (y, x)):
            return f"the angle of a point is `atan2({y}, {x})`"
        case ("der", (q, ("t" | "time" | "1"))):
            return f"the rate is `der({q})`"
        case ("der", (q, "2")):
            return f"the second derivative is `der(der({q}))`"
        case (("max" | "min"), (_, _, _, *_)):
            return f"it takes two numbers or an array: `{name}({{{', '.join(arguments)}}})`"
        case ("log", (x, base)):
            return f"write `log({x})/log({base})`"
        case ("norm", (_, _, *_)):
            return f"components stand in braces: `norm({{{', '.join(arguments)}}})`"
        case ("atan2", (x,)):
            return f"the angle of one value is `atan({x})`"
        case _:
            return None


def name_help(name: str, after: str) -> str | None:
    """Help: the text to write for a name of another language; `after` is the text behind it: `.sin(x)`."""
    if name in _PACKAGES and after[:1] == "." and after[1:2].isalpha():
        return f"functions and constants have no package: write `{after[1:]}`"
    return _NAMES.get(name)


def word_help(word: str, name: str = "x") -> str | None:
    """Help: the text to write for a word of another language that begins a statement and declares `name`."""
    found = _WORDS.get(word)
    return None if found is None else found.replace("{name}", name)


def quantity_help(name: str) -> str | None:
    """Help: the type to write for `name`, which other languages and the field call it."""
    return _TYPES.get(name)


def package_help(package: str) -> str | None:
    """Help: the text to write for the import of a package of another language."""
    return _NOT_NEEDED if package in _PACKAGES else None


def rate_of(name: str) -> tuple[tuple[str, str], ...]:
    """Pairs of a name and of the text of its rate that `name` may mean: `theta` and `der(theta)` of `theta_dot`."""
    found = [(name[: -len(end)], times) for end, times in _RATES.items() if name.endswith(end)]
    found += [(name[2:], 2)] * name.startswith("dd") + [(name[1:], 1)] * name.startswith("d")
    return tuple((quantity, "der(" * times + quantity + ")" * times) for quantity, times in found if quantity)


def member_help(name: str, target: str) -> str | None:
    """Help: the text to write for a member of a quantity in another language: `theta.dot`."""
    return f"the rate is `der({target})`" if name in _RATE_MEMBERS else None


def form_help(word: str) -> str | None:
    """The form of the statement that begins with `word`."""
    form = _FORMS.get(word)
    return None if form is None else f"the form is {form}"


def call_help(name: str, argument: str) -> str | None:
    """Help: the text to write for `simulate(10);` or `theta(0) = ...;` among the declarations."""
    if name in _COMMANDS:
        return _COMMAND
    if name == "experiment":
        return "the experiment is an annotation: `annotation(experiment(StopTime = 10));`"
    is_start = argument in ("0", "0.0", "t0")
    return f"a start is an attribute: `coordinate Angle {name}(start = 30 deg);`" if is_start else None


OF_MOTION = "equations of motion follow from energies and forces: write `mass`, `kinetic`, `force`; delete this one"


def constraint_help(equation: str) -> str:
    """Help: the text to write for an equation between coordinates."""
    return f"an equation between coordinates is a constraint: `constraint {' '.join(equation.rstrip(' ;').split())};`"


def value_help(name: str) -> str:
    """Help for an equation of what has its value already."""
    return f"give `{name}` its value where it is declared"


def energy_help(name: str) -> str | None:
    """Help: the text to write for `T = ...;` among the declarations."""
    word = _ENERGIES.get(name)
    return None if word is None else f"an energy is declared by its keyword: `{word} {name} = ...;`"


def is_called(word: str) -> bool:
    """True for a function that is often written without brackets."""
    return word in _FUNCTIONS_CALLED
