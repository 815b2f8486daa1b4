"""Family 02: names."""

from lagdsl.foundation.diagnostics.catalog.row import Row, error, note, warning

ROWS: dict[str, Row] = {
    "E0201": error(
        "unknown name `{name}`", label="not declared in {scope}", help="check the spelling, or declare it with its type"
    ),
    "E0202": error("unknown modifier `{name}` for `{type}`; the attributes are {attributes}", label="not an attribute"),
    "E0203": error(
        "`{name}` is ambiguous: it is imported from {imports}", label="ambiguous name", secondary="contains one, too"
    ),
    "E0204": error(
        "`{name}` is declared twice, as {first} and as {second}",
        label="declared again here",
        help="rename one of the two",
    ),
    "N0205": note("`{name}` hides the built-in {what} of that name"),
    "W0206": warning(
        "{kind} `{name}` is never used",
        label="declared here, read nowhere",
        help="use it or delete it; a misspelt name elsewhere may be the cause",
    ),
    "E0207": error("a declaration cannot hide `{name}`", label="a name of the language", help="choose another name"),
    "E0208": error(
        "unknown type `{name}`",
        label="neither a quantity nor declared in the file",
        help="check the spelling; a component needs the `import` of its package: `import Lag.Planar.*;`",
    ),
    "E0209": error(
        "unknown function `{name}`",
        label="no function of this name",
        help="check the spelling; a function of your own is written `function name ... end name;`",
    ),
    "E0210": error("{what} has no member `{name}`", label="unknown member", help="check the spelling of the member"),
    "E0211": error("`{function}` has no argument `{name}`", label="unknown argument"),
    "E0212": error("`{name}` is given twice", label="given again here", help="keep one of the two"),
    "E0213": error(
        "`{name}` has no effect on a quantity declared as {what}", label="does not fit here", help="delete it"
    ),
    "E0214": error(
        "the prefixes `{prefixes}` do not fit together",
        label="no such kind of quantity",
        help="{hint}",
    ),
    "E0215": error("unknown shape `{shape}`", label="cannot be drawn"),
    "W0216": warning("annotation `{name}` has no effect", label="not known"),
    "E0217": error("the file has no model `{name}`"),
    "E0218": error(
        "the file has no complete model", label="no model to compile", help="write `model Name ... end Name;`"
    ),
    "E0219": error("`{name}` is {what}, not a value", label="a value is expected here"),
    "E0220": error("modifier `{name}` needs a value", label="without a value", help="write `{name} = ...`"),
    "E0221": error(
        'the only value of the annotation `units` is "none"',
        label="not known",
        help='`annotation(units = "none")` takes every dimension in the class as 1',
    ),
    "E0222": error("the model has no structural parameter `{name}`"),
    "E0223": error("{model} has no `{name}`", label="cannot be modified"),
    "E0224": error(
        "`{name}` cannot be given another value from outside",
        label="it is fixed",
        help="leave the value as it is, or delete `final` or `constant` at its declaration",
    ),
    "E0225": error(
        "component `{name}` would contain itself: {path}",
        label="a component of a class that it is part of",
        help="write an array of components in the enclosing class: `Link link[n]`",
    ),
    "E0226": error(
        "a class cannot extend itself: {path}", label="closes the cycle", help="delete one of the `extends`"
    ),
    "E0227": error(
        "component `{name}` cannot be given a value",
        label="a component is not a quantity",
        help="modify its members: `{name}(member = ...)`",
    ),
    "E0228": error("{what} is an array of components", label="needs an index"),
    "E0229": error(
        "`{name}` is protected in {what}",
        label="not visible from outside",
        help="use a public member, or move it above `protected`",
    ),
    "E0230": error(
        "`{name}` does not exist: its condition is false",
        label="used here",
        help="use it under the same condition",
    ),
    "E0231": error(
        "`{name}` is a partial class; it cannot be {what}",
        label="incomplete",
        help="use a class that extends it",
    ),
    "E0232": error(
        "`extends` must stand at the top of a class",
        label="inherited parts cannot depend on conditions",
        help="move the `extends` to the top of the class",
    ),
    "E0233": error(
        "`{name}` is a class, not the type of a quantity",
        label="a quantity has one value",
        help="declare a component, without a prefix: `{name} name;`",
    ),
    "E0234": error(
        "`{name}` is given for {found} components, there are {count}",
        label="one value for each component is needed",
        help="give {count} values, or `each {name} = ...` for the same value everywhere",
    ),
    "E0235": error(
        "{kind} `{name}` is not replaceable",
        label="cannot be redeclared",
        help="declare it as `replaceable` to allow that",
    ),
    "E0236": error("this modifier does not fit the kind of `{name}`", label="does not fit"),
    "E0237": error(
        "the subscripts do not fit: `{name}` is {what}",
        label="there is no such element",
        help="the subscripts of a modifier choose one element of an array of components",
    ),
    "E0238": error(
        "`{prefix}` does not fit a component of a class",
        label="no quantity",
        help="delete it; prefixes of components are `final` and `replaceable`",
    ),
    "E0239": error(
        "`{name}` uses no units, but the model uses units",
        label="used here",
        help='write `annotation(units = "none")` in the model, too, or give the class its units',
    ),
    "E0240": error(
        "only components and classes can be redeclared", label="this is {what}", help="give it another value instead"
    ),
    "E0241": error(
        "one element of `{name}` cannot be modified by itself",
        label="a modifier is for the whole array",
        help="give all elements: `{name} = {{...}}`",
    ),
    "E0242": error("a redeclaration keeps the size of `{name}`", label="gives a size", help="delete the subscripts"),
    "E0243": error(
        "`{name}` is inherited along two paths with conflicting modifiers",
        label="conflicting modifiers",
        help="use the same modifiers on both paths, or modify it where the class is used",
    ),
    "E0244": error("`{new}` cannot replace `{old}`: it has no {missing}", label="replaces it here"),
    "E0245": error(
        "`{name}` stands for several components, {what} needs one class",
        label="several components",
        help="declare a component of it: `{name} name;`",
    ),
    "E0246": error("`{text}` cannot be a {what} of the page", label="no such quantity"),
    "E0250": error(
        "there is no package or class `{name}`",
        label="not found",
        help="check the spelling; packages lie beside the file, in the folders of LAGPATH or in the library",
    ),
    "E0252": error(
        "`{name}` is not a package",
        label="has no names to import",
        help="import the class itself, without the rest of the name",
    ),
    "E0253": error(
        "`{file}` must hold the {what} `{name}` and nothing else",
        label="not of that name",
        help="a package that is a folder has one file for each class; the file has the name of the class",
    ),
    "E0254": error(
        "`{file}` {expected}",
        label="not where the file lies",
        help="write the `within` of its folder, or move the file",
    ),
    "E0255": error(
        "there is no package `{name}` around this file",
        label="not found",
        help="delete the `within`, or move the file into the folder of the package",
    ),
    "W0257": warning("import of `{name}` is never used", label="no name in this {scope} needs it", help="delete it"),
    "E0258": error(
        "`{name}` is imported twice",
        label="imported again",
        help="give one of the two a name of its own: `import X = ...;`",
    ),
    "E0259": error("`{name}` stands in the package twice", label="declared here", help="delete one of the two"),
}
