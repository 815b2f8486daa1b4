"""Family 12: flexible bodies that are imported."""

from lagdsl.foundation.diagnostics.catalog.row import Row, error, note, warning

_CORRECT = "correct the file"
_FREE = "write the matrices of the free body: without boundary conditions, ties and equations"

ROWS: dict[str, Row] = {
    "E1200": error(
        "cannot read `{name}`: {reason}", help="give the path of an input deck, `.inp`, or of a `.SID_FEM` file"
    ),
    "E1201": error("{what} is `{text}`, not {expected}", label="this line", help=_CORRECT),
    "E1202": error(
        "the file ends, or a new part of it begins, before {what}", label="here", help="write the file anew"
    ),
    "E1203": error("`{name}` has no {what}", help="write the file anew, with everything that the import needs"),
    "E1204": error("{what} has more than {limit} {unit}", label="beyond the bound", help="import a coarser body"),
    "E1205": error(
        "the matrices of `{name}` are missing: {files}",
        help="write them with CalculiX, `*FREQUENCY, SOLVER=MATRIXSTORAGE`, or Abaqus, `*MATRIX GENERATE`; "
        "`--matrices` tells the common name of their files",
    ),
    "E1206": error("the {what} `{name}` occurs twice", label="the second one", help=_CORRECT),
    "E1207": error(
        "`*{keyword}` is not read: it makes or moves nodes and elements",
        label="this keyword",
        help="write a flat deck, with all nodes and elements in lines of `*NODE` and `*ELEMENT`",
    ),
    "E1208": error(
        "elements of the type `{type}` are not imported",
        label="this type",
        help="the import takes solid elements: C3D4, C3D6, C3D8, C3D8I, C3D8R, C3D10, C3D15, C3D20, C3D20R",
    ),
    "E1209": error("the file has no {kind} `{name}`", label="unknown", help="the file has {known}"),
    "E1210": error("`{name}` does not belong to this body: {reason}", help=_FREE),
    "E1211": error(
        "node {node} has a rotation, unknown {direction}: beams and shells are not imported", help="use solid elements"
    ),
    "E1212": error("the matrices have no unknown of node {node} in direction {direction}", help=_FREE),
    "E1213": error(
        "the stiffness is singular: a part of the body moves without strain while the interfaces are held",
        help="join loose parts, give each interface three nodes beside one line, and use elements without modes of "
        "zero energy: one row of C3D20R has them, C3D8I and C3D20 have none",
    ),
    "E1214": error(
        "{modes} modes are more than the {most} unknowns between the interfaces", help="ask for fewer `--modes`"
    ),
    "E1215": error(
        "the mass matrix is {reason}",
        help="give every element a density, and write consistent masses of solid elements",
    ),
    "E1216": error(
        "the interface `{name}` {reason}", help="give each interface a set of nodes on a surface of its own"
    ),
    "E1217": error(
        "the unit of length of `{name}` is not known: the file does not tell it",
        help="tell it: `--length-unit m`, `cm` or `mm`; forces are in N, so a file in mm has masses in tonnes",
    ),
    "N1218": note(
        "the body has no geometric stiffening: {reason}",
        help="it bends without stiffening by centrifugal forces and loads; keep rotations slow against its frequencies",
    ),
    "E1219": error(
        "`{name}` needs two interfaces at least: frame_a, frame_b",
        help="name them with `--interface`; the file has {known}",
    ),
    "E1220": error(
        "the numbers of `{name}` are too large or too small to compute with",
        help="check the units of the file, and `--length-unit`",
    ),
    "W1221": warning(
        "mass, mdCM, J, Ct, Cr and Me of `{name}` contradict each other: a motion has a negative kinetic energy",
        help="write the file anew; as it is, the body is right where frame_a stands still",
    ),
    "E1222": error(
        "`*{keyword}` is a keyword of neither CalculiX nor Abaqus",
        label="this keyword",
        help="did you mean `*{meant}`?",
    ),
}
