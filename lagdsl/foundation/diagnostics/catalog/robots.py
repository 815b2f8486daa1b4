"""Family 10: descriptions of robots that are imported."""

from lagdsl.foundation.diagnostics.catalog.row import Row, error, note, warning

_CORRECT = "correct the file"

ROWS: dict[str, Row] = {
    "E1000": error("cannot read `{name}`: {reason}", help="give the path of a URDF or MJCF file"),
    "E1001": error(
        "this is not valid XML: {reason}", label="the reader stops here", help="close every tag, quote every value"
    ),
    "E1002": error(
        "{what} has more than {limit} {unit}",
        label="beyond the bound",
        help="a robot needs less; import a part of the file",
    ),
    "E1003": error(
        "the document type of the file contains declarations",
        label="here",
        help="delete it, and write what each entity stands for in its place; a robot needs no declarations",
    ),
    "E1004": error(
        "a file that begins with `<{tag}>` is not a robot file that lagdsl reads",
        label="`<robot>` begins a URDF file, `<mujoco>` an MJCF file",
        help="translate other formats, for instance xacro, to one of these first",
    ),
    "E1005": error("`<{element}>` has no {what}", label="needs it", help=_CORRECT),
    "E1006": error("`{name}` is `{text}`, not {expected}", label="this value", help="write a value in SI units"),
    "E1007": error(
        "{what} `{name}` occurs twice",
        label="the second one",
        help="give each a name of its own, or delete one of them",
    ),
    "E1008": error("the file has no {what} `{name}`", label="unknown", help="check the spelling of the name"),
    "E1009": error(
        "the lower limit {lower:g} is larger than the upper one, {upper:g}", label="this limit", help=_CORRECT
    ),
    "E1010": error("unknown type of joint `{type}`", label="unknown", help="the types are {known}"),
    "E1011": error("the mass and inertia of link `{name}` are impossible: {reason}", label="given here", help=_CORRECT),
    "E1012": error(
        "the joint `{name}` can move without kinetic energy",
        label="its acceleration is not determined",
        help="give its links a mass, or moments of inertia about the axis, or make the joint `fixed`",
    ),
    "E1013": error("the {kind} `{file}` cannot be used: {reason}", label="named here", help=_CORRECT),
    "E1014": error(
        "MJCF files need the package `mujoco`, which is not installed",
        help="install it: `pip install mujoco`",
    ),
    "E1015": error(
        "MuJoCo rejects this file: {reason}", label="its root", help="correct the element that MuJoCo names"
    ),
    "E1016": error("the language cannot express `{what}`", label="this element", help=_CORRECT),
    "E1017": error(
        "the links do not form a tree: {reason}",
        label="this joint or link",
        help="a robot has one link at its base, and every other link one joint to the link before it",
    ),
    "E1018": error(
        "nothing moves: every joint of this robot is `fixed`",
        label="a robot at rest",
        help="import it with `--floating` (in Python `floating=True`) if its base moves freely",
    ),
    "N1019": note(
        "`<{tag}>` is left out, {times}",
        label="the first one",
        help="the text describes links, joints, actuators and visible shapes",
    ),
    "N1020": note("the {kind} `{old}` is called `{new}` in the text", label="its original name"),
    "N1021": note("a warning of MuJoCo: {text}", label="about this file"),
    "E1022": error(
        "the root link `{name}` has no mass, and a single joint leads from it: it cannot move freely",
        label="the acceleration of its root link is not determined",
        help="give the root link a mass, or import the robot without `--floating`",
    ),
    "N1023": note(
        "the text does not draw the mesh `{file}`: {reason}",
        label="named here",
        help="write the text into the folder `{home}` with `-o` (in Python `folder=`)",
    ),
    "N1024": note(
        "contacts between shapes are left out: MuJoCo lets {bodies} touch others, {friction}",
        label="the first one",
        help="write `SphereOnPlane` or another contact of `Lag.Spatial` for each shape that touches something",
    ),
    "E1025": error(
        "the file is a template of xacro, which is not expanded",
        label="a macro, or a value that has to be computed",
        help="expand it first, `xacro FILE > robot.urdf`, and import the result",
    ),
    "W1026": warning(
        "the {written} of `<{owner}>` is not read{times}",
        label="no known name",
        help="delete it",
    ),
}
