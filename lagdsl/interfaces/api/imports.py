"""The model texts of files of other tools."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Literal

from lagdsl.foundation.diagnostics import Sink


def import_robot(
    path: Path | str,
    *,
    limits: Literal["range", "contact", "none"] = "range",
    actuators: Literal["file", "all", "none"] = "file",
    floating: bool = False,
    lenient: bool = False,
    folder: Path | str = ".",
    root: Path | str | None = None,
    sink: Sink | None = None,
) -> str:
    """The text of the model of a robot, from its URDF or MJCF file: for `lagdsl.compile`, or to write to a file.

    `limits` of joints become ranges of their coordinates, contacts, or nothing. `actuators`: the inputs are those of
    the file (of every joint where the file tells none), those of `all` joints, or `none`. With `floating` the base
    moves freely, by a quaternion; else it is fixed to the world. With `lenient` parts that the language has no place
    for, or that no body can have, are left out with a warning. `folder` is that of the text, from which it names files
    of meshes. Names in the robot's file lead to its package, or else to the parent of its folder, and to `root`. Notes
    and warnings go to `sink`. Raises CompilationFailed with the lines of the file that stand in the way.
    """
    from lagdsl.exchange.robots.plan import Style
    from lagdsl.exchange.robots.read import robot_text

    own = Sink() if sink is None else sink
    style = Style(limits=limits, actuators=actuators, floating=floating)
    text = robot_text(Path(path), style, own, Path(folder), lenient, None if root is None else Path(root))
    own.raise_if_errors()
    assert text is not None, "internal error: the import gave up without saying why"
    return text


def import_body(
    path: Path | str,
    interfaces: Sequence[str],
    *,
    length_unit: Literal["m", "cm", "mm"],
    modes: int = 6,
    matrices: Path | str | None = None,
    name: str | None = None,
    sink: Sink | None = None,
) -> str:
    """The text of a class that extends `Lag.Flexible.ModalBody`, from an input deck of CalculiX or Abaqus with the
    matrices of the free body beside it, or from Standard Input Data (`.SID_FEM`).

    `interfaces` are sets of nodes of the deck, or numbers of nodes of the data: the first is frame_a, at which the body
    is held, the second frame_b, others have frames of their names. `modes` is the number of modes with all interfaces
    held, beside six static shapes for each interface but the first. `length_unit` is that of the file; forces are in N,
    times in s. `matrices` is the common name of the files of matrices, where it is not that of the deck. The class has
    the name `name`, or that of the file. Notes go to `sink`. Raises CompilationFailed with the place in the file.
    """
    from lagdsl.exchange.flexible.read import Reading, body_text

    own = Sink() if sink is None else sink
    stem = None if matrices is None else Path(matrices)
    reading = Reading(interfaces=tuple(interfaces), modes=modes, length_unit=length_unit, matrices=stem)
    text = body_text(Path(path), reading, own, name)
    own.raise_if_errors()
    assert text is not None, "internal error: the import gave up without saying why"
    return text
