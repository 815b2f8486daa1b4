"""Family 07: how components are joined."""

from lagdsl.diagnostics.catalog.row import Row, error, note, warning

ROWS: dict[str, Row] = {
    "E0700": error(
        "this equation places no frame",
        "neither side is a frame to be placed",
        "a kinematics section holds equations like `frame_b = frame_a.rotz(q);`",
    ),
    "N0701": note(
        "{count} of the {total} closure equations of {joint} are redundant and are left out of the solve",
        "this closes the loop {loop}",
    ),
    "E0702": error(
        "`{name}` is not connected to `world`",
        "no joint leads here from the world",
        "connect it; a body that moves freely needs a joint of six coordinates, `FreeMotion`, between it and `world`",
    ),
    "E0703": error(
        "`{name}` has one port and cannot stand in the middle of a `connect`",
        "nothing leads on from its `{port}`",
        "end the list here, or name the frame that the next one joins, too",
    ),
    "E0704": error(
        "`{name}` has no `{port}`; name one of its frames",
        "several frames",
        "name the frame: {ports}",
    ),
    "E0705": error(
        "`{name}.{port}` is connected already; name the frame of `{name}` to connect",
        "ambiguous",
        "name the frame that is meant: {ports}",
    ),
    "E0706": error(
        "this kinematics cannot be followed backward",
        "the frame that it starts from would have to be known before",
        "turn the component around in the `connect`, or give its kinematics by `move` and turns alone",
    ),
    "E0707": error(
        "a closure holds for positions, this equation contains rates or forces",
        "no geometric condition",
        "what holds for rates is a `constraint` of the class",
    ),
    "E0708": error("`prefer` is `always` or `never`, not `{found}`", "no such choice"),
    "W0709": warning(
        "this `connect` joins items that are connected already",
        "without effect",
        "delete it, or name the frames that are meant",
    ),
    "E0710": error(
        "the reaction of `{name}` is not one wrench",
        "several frames",
        "name the frame: {ports}",
    ),
    "E0711": error(
        "`{first}` and `{second}` cannot be one coordinate",
        "of different type or size",
        "`connect` makes coordinates of one type, unit and size one; others are related by a `constraint`",
    ),
    "E0712": error(
        "`{first}` and `{second}` are one coordinate, with two values of its fixed {what}",
        "another value",
        "drop one of the two, or `fixed = true` at one",
    ),
    "W0713": warning(
        "`{first}` and `{second}` are one coordinate; its {what} is that of `{first}`",
        "without effect",
        "drop one of the two",
    ),
    "E0714": error(
        "`{first}` and `{second}` are connectors of different kinds",
        "cannot be joined",
        "connectors fit if they have the same members with the same dimensions",
    ),
    "E0715": error(
        "the flows at `{name}` are not rates of coordinates",
        "no law for rates can be made of them",
        "a flow is bound to the rate of a coordinate: `Pin p(i = der(q));` with `coordinate Charge q;`",
    ),
    "W0716": warning(
        "`{name}` is not connected: nothing flows through it",
        "alone",
        "connect it, or leave the component out",
    ),
    "E0717": error(
        "the flow into `{name}` is not defined",
        "no component here gives its flow",
        "bind it to the rate of a coordinate, as in `Pin p(i = der(q));`",
    ),
    "N0718": note(
        "`{name}` follows from the other joints of its loop; its start value only selects the turn of the angle",
        "no initial value",
        "`prefer = always` keeps the coordinate, with its start",
    ),
    "E0719": error(
        "{what} cannot be connected here",
        "{why}",
        "`connect` joins frames with frames, coordinates with coordinates, and connectors with connectors of one class",
    ),
}
