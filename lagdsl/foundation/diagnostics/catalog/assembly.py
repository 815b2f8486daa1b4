"""Family 07: how components are joined."""

from lagdsl.foundation.diagnostics.catalog.row import Row, error, note, warning

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
        "no chain of joints leads from `world` to it",
        "connect it: `connect(world, {name});`; a body that moves freely needs a joint with all coordinates, "
        "`FreeMotion`, between it and `world`",
    ),
    "E0703": error(
        "`{name}` has one port and cannot stand in the middle of a `connect`",
        "its only port is `{port}`",
        "end the list here, or name the frame that the next component joins",
    ),
    "E0704": error(
        "`{name}` has no `{port}`; name one of its frames",
        "several frames",
        "name the frame: {ports}",
    ),
    "E0705": error(
        "`{name}.{port}` is connected already; name the frame of `{name}` to connect",
        "ambiguous",
        "name the frame: {ports}",
    ),
    "E0706": error(
        "the compiler cannot invert this kinematics",
        "gives the second frame from the first only",
        "reverse the component in the `connect`, or write its kinematics with `move` and rotations only",
    ),
    "E0707": error(
        "a closure relates positions, but this equation contains rates or forces",
        "not a geometric condition",
        "write a condition on rates as a `constraint` of the class",
    ),
    "E0708": error(
        "`prefer` is `always` or `never`, not `{found}`",
        "no such choice",
        help="write `prefer = always` or `prefer = never`",
    ),
    "W0709": warning(
        "this `connect` joins items that are connected already",
        "without effect",
        "delete it, or name the frames to connect",
    ),
    "E0710": error(
        "the reaction of `{name}` is not one wrench",
        "several frames",
        "name the frame: {ports}",
    ),
    "E0711": error(
        "`{first}` and `{second}` cannot be one coordinate",
        "of different type or size",
        "`connect` identifies coordinates of equal type, unit and size; relate others by a `constraint`",
    ),
    "E0712": error(
        "`{first}` and `{second}` are one coordinate, but fix its {what} at two values",
        "another value",
        "delete one of the two, or `fixed = true` at one of them",
    ),
    "W0713": warning(
        "`{first}` and `{second}` are one coordinate; its {what} is that of `{first}`",
        "without effect",
        "delete one of the two",
    ),
    "E0714": error(
        "`{first}` and `{second}` are connectors of different kinds",
        "cannot be joined",
        "connectors fit if they have the same members with the same dimensions",
    ),
    "E0715": error(
        "the flows at `{name}` are not rates of coordinates",
        "Kirchhoff's law needs the rate of a coordinate",
        "bind the flow to the rate of a coordinate: `Pin p(i = der(q));` with `coordinate Charge q;`",
    ),
    "W0716": warning(
        "`{name}` is not connected: nothing flows through it",
        "not connected",
        "connect it, or delete the component",
    ),
    "E0717": error(
        "the flow into `{name}` is not defined",
        "no component here gives its flow",
        "bind it to the rate of a coordinate, as in `Pin p(i = der(q));`",
    ),
    "N0718": note(
        "`{name}` follows from the other joints of its loop, as `prefer = never` says; {use}",
        "no initial value",
        "leave out `prefer`, and the start chooses how the loop is assembled",
    ),
    "E0719": error(
        "{what} cannot be connected here",
        "{why}",
        "`connect` joins frames with frames, coordinates with coordinates, and connectors with connectors of one class",
    ),
}
