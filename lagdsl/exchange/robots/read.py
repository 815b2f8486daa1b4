"""From a file to a model text: the one way that the command line and Python share."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from lagdsl.exchange.robots.description import Robot
from lagdsl.exchange.robots.drawings import folder_of_all, undrawn
from lagdsl.exchange.robots.findings import Findings
from lagdsl.exchange.robots.mesh_faults import once_for_each_reason
from lagdsl.exchange.robots.plan import Plan, Style, planned, rigid_with_root
from lagdsl.exchange.robots.reach import reach_of
from lagdsl.exchange.robots.text import model_text
from lagdsl.exchange.robots.urdf.read import read_urdf
from lagdsl.exchange.robots.xml_tree import read_xml
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.meshes.files import is_drawable
from lagdsl.foundation.source import SourceFile
from lagdsl.language.syntax.printer import format_text


def robot_text(
    path: Path, style: Style, sink: Sink, folder: Path, lenient: bool = False, root: Path | None = None
) -> str | None:
    """The text of the model of a robot file, formatted; None after errors. `folder` is that of the text, `root`
    one more folder that names in the file may lead to.

    URDF and MJCF are told apart by their root elements. With `lenient` what the language has no place for is left out,
    with warnings.
    """
    top = read_xml(path, sink)
    if top is None:
        return None
    findings, reach = Findings(sink, lenient), reach_of(path, root)
    match top.tag:
        case "robot":
            robot = read_urdf(path, top, reach, findings)
        case "mujoco":
            from lagdsl.exchange.robots.mjcf.read import read_mjcf

            robot = read_mjcf(path, top, reach, findings)
        case _:
            sink.report("E1004", top.head, tag=top.tag)
            return None
    if robot is None or sink.has_errors:
        return None
    if style.floating and _turns_alone(robot):
        findings.error("E1022", robot.span, name=robot.root, instead="the root link is joined to the world")
        style = replace(style, floating=False)
    if sink.has_errors:
        return None
    if not style.floating and all(joint.kind == "fixed" for joint in robot.joints):
        sink.report("E1018", robot.span)
        return None
    plan = planned(robot, style, findings)
    _tell_undrawn(plan, path, folder, findings)
    text = format_text(SourceFile(str(path), model_text(plan, folder)), sink)
    assert text is not None, sink.diagnostics
    return text


def _tell_undrawn(plan: Plan, path: Path, folder: Path, findings: Findings) -> None:
    """N1023 for each reason for which the text draws no mesh, with the folder whose text would."""
    home = folder_of_all(plan, path)
    for mesh, notes in once_for_each_reason(undrawn(plan, folder)):
        help = None if is_drawable(mesh.file) else "convert it to one of these formats"
        findings.note("N1023", mesh.span, notes=notes, help=help, file=mesh.file, reason=mesh.reason, home=home)


def _turns_alone(robot: Robot) -> bool:
    """True if the root link could move along its only joint without moving any mass."""
    rigid = rigid_with_root(robot)
    if any(link.inertial is not None for link in robot.links if link.name in rigid):
        return False
    leading = [joint for joint in robot.joints if joint.kind != "fixed" and joint.parent in rigid]
    return len(leading) <= 1 and not any(joint.passive.armature for joint in leading)
