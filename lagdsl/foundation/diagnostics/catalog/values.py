"""Family 03: values, types and variability."""

from lagdsl.foundation.diagnostics.catalog.row import Row, error, note, warning

ROWS: dict[str, Row] = {
    "E0301": error(
        "array sizes and loop ranges must be structural: `{name}` {kind}",
        label="must be known when the model is compiled",
        help="declare it, or what it is made of, as `structural parameter Integer`",
    ),
    "E0302": error(
        "`{name}` is a coordinate; give its start value, not a binding",
        label="a coordinate is an unknown of the motion",
        help="write `{name}(start = {value})`; for a prescribed motion declare it without `coordinate`",
    ),
    "E0303": error(
        "parameter `{name}` has no value and no default",
        label="needs a value",
        help="write `{name} = ...` here",
    ),
    "E0304": error(
        "input `{name}` {what} and must be {times} differentiable",
        label="its time derivatives occur in the equations",
        help="declare `input {type} {name}(smooth = {count})`",
    ),
    "E0305": error(
        "circular definition: {path}", label="depends on itself", help="define one of them independently of the others"
    ),
    "E0306": error(
        "expected a point, found {found}",
        label="not a position",
        help="a point has two or three components: `{{x, y}}`",
    ),
    "E0307": error(
        "`{name}` is given two values at the same event",
        label="and here again",
        help="use the branches of one `when ... elsewhen`, or an `if` in one clause",
    ),
    "E0308": error(
        "{what} depends on an acceleration, which depends on it in turn",
        label="an acceleration is known only after the equations are solved",
        help="write the inertia term as an energy or a mass",
    ),
    "N0309": note(
        "jumps of `{name}` trigger no events",
        label="the first place",
        help="write a relation, `if x > ... then ...`, for a jump that is an event, or `noEvent(...)` if it is none",
    ),
    "E0311": error("{what} is not supported yet", label="comes with a later release", help="{hint}"),
    "E0312": error("expected {expected}, found {found}", label="this is {found}", help="write {expected} here"),
    "E0313": error(
        "the shapes do not fit together: {left} and {right}",
        label="shapes differ",
        help="use operands of the same size",
    ),
    "E0314": error(
        "function `{name}` calls itself",
        label="recursion",
        help="functions are expanded in place and cannot be recursive",
    ),
    "E0315": error(
        "`{function}` takes {expected}, found {found}", label="wrong number of arguments", help="check the arguments"
    ),
    "E0316": error(
        "index {index} is out of range: there are {extent} elements",
        label="must be 1 to {extent}",
        help="use an index from 1 to {extent}",
    ),
    "E0317": error(
        "{what} may depend on {allowed} only", label="varies more than that", help="replace the parts that vary more"
    ),
    "E0318": error(
        "`{name}` has no value",
        label="nothing defines it",
        help="write `{name} = ...` here or in an `equation` section",
    ),
    "E0319": error("`{name}` is defined twice", label="a second definition", help="delete one of the two definitions"),
    "E0320": error(
        "state `{name}` has no equation",
        label="needs an equation",
        help="write `der({name}) = ...` in an `equation` section",
    ),
    "E0321": error(
        "`der({name}) = ...` needs a state, and `{name}` is declared as {kind}",
        label="not a state",
        help="declare `state {name}`; motion of coordinates follows from energies and forces",
    ),
    "E0322": error(
        "this equation defines nothing",
        label="neither side is a variable without a value",
        help="write `y = ...`, `der(x) = ...` of a state, or a `constraint`; implicit equations are not supported yet",
    ),
    "E0323": error(
        "this has no value: {reason}", label="cannot be computed", help="check the values that it is computed from"
    ),
    "E0324": error(
        "{what} cannot depend on reactions, multipliers, momenta or energies of the solved motion",
        label="known only after the equations are solved",
        help="use them in loads, limits of friction, outputs, invariants and assertions",
    ),
    "E0325": error("gravity is given twice", label="a second time here", help="keep one `gravity` statement"),
    "E0326": error("{what} is too large", label="at most {most}", help="use a smaller size"),
    "E0327": error(
        "`{name}` is {what}, not a function",
        label="read as a call of `{name}`",
        help="write `{name}*{arguments}` for a product",
    ),
    "W0328": warning(
        "`{name}` is {value}, outside its {which} of {limit}",
        label="out of bounds",
        help="choose a value within the bounds, or change the bounds",
    ),
    "E0329": error(
        "{subject} has no finite value{conditions}",
        label="infinite, or not a number",
        help="change the parameters that it is made of, or choose another expression where they are zero: "
        "`if k > 0 then 1/k else 0`",
    ),
    "E0330": error(
        "the condition of {what} must be known when the model is compiled",
        label="depends on a parameter",
        help="use a `structural parameter Boolean`",
    ),
    "E0331": error("`draw {shape}` needs a place: {ways}", label="no such place", help="write {ways} after the shape"),
    "E0332": error(
        "{what} is given in the frame's own axes, this is a vector in world axes",
        label="a world vector",
        help="write its components in the frame: `{{a, b, c}}`; `.at(P)` takes world positions",
    ),
    "E0333": error(
        "an index must be known when the model is compiled",
        label="not structural",
        help="use a number, a loop variable or a `structural parameter Integer`",
    ),
    "E0334": error("{what} must be {expected}, found {found}", label="this is {found}", help="write {expected} here"),
    "E0335": error(
        "one value for a whole array needs `each`",
        label="one value, several elements",
        help="write `each {text}`",
        fix="each {text}",
    ),
    "E0336": error(
        "the size of `{name}` comes from its binding, and it has none",
        label="needs a size",
        help="write the size as a number, `{name}[3]`, or give a binding",
    ),
    "E0337": error("{kind} `{name}` has no value", label="needs a value", help="write `{name} = ...` here"),
    "E0338": error(
        "`{name}` is a state; give its start value and an equation, not a binding",
        label="a state has an equation `der({name}) = ...`",
        help="write `{name}(start = ...)`",
    ),
    "E0339": error(
        "{what} cannot contain accelerations",
        label="positions and velocities only",
        help="state the same condition for positions or velocities",
    ),
    "E0340": error(
        "`{name}` cannot be declared inside a loop",
        label="the loop would declare it several times",
    ),
    "E0341": error(
        "there is no dimension {index}: the number of dimensions is {extent}",
        label="one subscript each",
        help="use one subscript for each dimension",
    ),
    "E0342": error(
        "the derivative of an acceleration, reaction or multiplier is not known",
        label="known only after the equations are solved",
        help="`der` may be taken twice of coordinates",
    ),
    "E0343": error(
        "`draw {shape}` needs {what}",
        label="no `{name}`",
        help="write `draw {example}`",
    ),
    "E0344": error(
        "`each` does not fit {what}: there is one only", label="`each` without an array", help="delete `each`"
    ),
    "E0345": error(
        "the rates of `{name}` are given twice, as `omega` and as `der`",
        label="given again here",
        help="keep one of the two",
    ),
    "E0346": error(
        "the free parameter `{name}` has no guess",
        label="initialization solves for it",
        help="write `{name}(fixed = false, start = ...)` with an approximate value",
    ),
    "E0347": error(
        "initialization solves for `{name}`, so it cannot have a value",
        label="a value of a free parameter",
        help="write the value as the guess, `start = ...`, or delete `fixed = false`",
    ),
    "E0348": error(
        "`{name}` cannot be a free parameter: {reason}",
        label="initialization cannot solve for it",
        help="delete `fixed = false` and give it a value",
    ),
    "E0349": error(
        "{free} and {equations}: the values are not determined",
        label="initialization solves for it",
        help="write one equation for each free parameter in an `initial equation` section",
    ),
    "E0350": error(
        "the fixed start of `{name}` depends on a free parameter",
        label="depends on an unknown of the initialization",
        help="delete `fixed = true` and write the condition as an `initial equation`",
    ),
    "W0351": warning(
        "the mesh `{file}` is not drawn: {reason}",
        label="named here",
        help="put the file into the folder of this text, or correct its name",
    ),
    "W0352": warning(
        "the color `{color}` is not drawn: no color of CSS has this name",
        label="the shape keeps its own color",
    ),
    "W0353": warning(
        "the start of `{name}` is computed with the guess of a free parameter",
        label="not with the value that the initial equations give it",
        help="write the relation as an initial equation, or give the start a value of its own",
    ),
    "E0354": error(
        "`der({name})` cannot depend on an acceleration",
        label="a blow would let `{name}` jump",
        help="integrate it: not `der(a) = -k*a + k*der(v)`, but `der(w) = -k*a` with a state w, and `a = w + k*v`",
    ),
    "E0360": error("the enumeration lists `{name}` twice", label="each value once", help="delete one of the two"),
    "E0361": error(
        "the {which} must be known while compiling",
        label="a parameter may change later",
        help="write numbers, or use `structural parameter`",
    ),
    "E0362": error(
        "the points of a table must increase, but {second} follows {first}",
        label="not in increasing order",
        help="sort the points; each may occur once",
    ),
    "E0363": error(
        "`{text}` cannot be measured: {why}",
        label="not among the columns",
        help="coordinates, rates, states, outputs and contacts are measured: write `output Length x = ...;` and "
        "measure `x`",
    ),
    "E0364": error(
        "two measurements have the name `{name}`",
        label="a column of data has one meaning",
        help="delete one, or give it a name of its own: `measure name: x;`",
    ),
}
