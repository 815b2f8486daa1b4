"""From a file to a model text: the one way that the command line and Python share."""

from __future__ import annotations

from pathlib import Path

from lagdsl.diagnostics import Sink
from lagdsl.robots.findings import Findings
from lagdsl.robots.plan import Style, planned
from lagdsl.robots.text import model_text
from lagdsl.robots.urdf import read_urdf
from lagdsl.robots.xml_tree import read_xml
from lagdsl.source import SourceFile
from lagdsl.syntax.printer import format_text


def robot_text(path: Path, style: Style, sink: Sink, lenient: bool = False) -> str | None:
    """The text of the model of a robot file, formatted; None after errors.

    URDF and MJCF are told apart by their root elements. With `lenient` what the language has no place for is left out,
    with warnings.
    """
    root = read_xml(path, sink)
    if root is None:
        return None
    findings = Findings(sink, lenient)
    match root.tag:
        case "robot":
            robot = read_urdf(path, root, findings)
        case "mujoco":
            from lagdsl.robots.mjcf import read_mjcf

            robot = read_mjcf(path, root, findings)
        case _:
            sink.report("E1004", root.head, tag=root.tag)
            return None
    if robot is None or sink.has_errors:
        return None
    if not style.floating and all(joint.kind == "fixed" for joint in robot.joints):
        sink.report("E1018", robot.span)
        return None
    text = format_text(SourceFile(str(path), model_text(planned(robot, style, findings))), sink)
    assert text is not None, sink.diagnostics
    return text
