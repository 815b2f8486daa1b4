"""Names of the Modelica Standard Library, and those of this library."""

from __future__ import annotations

from functools import cache

from lagdsl.foundation.resources import library_folder

# Last part of the name there: package and class here.
_CLASSES = {
    "IdealGear": "Lag.Rotational.Gear",
    "IdealPlanetary": "Lag.Rotational.Planetary",
    "Inertia": "Lag.Rotational.Rotor",
    "BearingFriction": "Lag.Rotational.CoulombFriction",
    "ElastoBacklash": "Lag.Rotational.Backlash",
    "Torque": "Lag.Rotational.TorqueSource",
    "Torque2": "Lag.Rotational.TorqueBetween",
    "ConstantTorque": "Lag.Rotational.TorqueSource",
    "Speed": "Lag.Rotational.SpeedSource",
    "Position": "Lag.Rotational.PositionSource",
    "IdealRollingWheel": "Lag.Rotational.RackAndPinion",
    "Mass": "Lag.Translational.SlidingMass",
    "Force": "Lag.Translational.ForceSource",
    "Force2": "Lag.Translational.ForceBetween",
    "SupportFriction": "Lag.Translational.CoulombFriction",
    "ConstantVoltage": "Lag.Electrical.VoltageSource",
    "SineVoltage": "Lag.Electrical.VoltageSource",
    "StepVoltage": "Lag.Electrical.VoltageSource",
    "SignalVoltage": "Lag.Electrical.VoltageSource",
    "ConstantCurrent": "Lag.Electrical.CurrentSource",
    "SignalCurrent": "Lag.Electrical.CurrentSource",
    "EMF": "Lag.Electrical.RotationalEMF",
    "Transformer": "Lag.Electrical.CoupledInductors",
    "FixedRotation": "Lag.Spatial.FixedTranslation",
    "BodyBox": "Lag.Spatial.BoxBody",
    "BodyCylinder": "Lag.Spatial.CylinderBody",
    "FreeMotionScalarInit": "Lag.Spatial.FreeMotion",
    "RevolutePlanarLoopConstraint": "Lag.Spatial.Revolute",
    "LimPID": "Lag.Blocks.LimitedPID",
    "Tanh": "Lag.Blocks.SmoothStep",
    "CombiTimeTable": "Lag.Blocks.TimeTable",
    "CombiTable1Ds": "Lag.Blocks.Table",
    "CombiTable2Ds": "Lag.Blocks.Table2D",
}

# Longer beginnings stand first: the packages there and here.
_PACKAGES = (
    ("Modelica.Mechanics.MultiBody", "Lag.Spatial"),
    ("Modelica.Mechanics.Rotational", "Lag.Rotational"),
    ("Modelica.Mechanics.Translational", "Lag.Translational"),
    ("Modelica.Electrical", "Lag.Electrical"),
    ("Modelica.Blocks", "Lag.Blocks"),
)

_WRITTEN = {
    "World": "nothing is declared: the frame `world` is known, and gravity is written `gravity = -g_n*world.y;`",
    "RealInput": "an input is declared with its quantity: `input Torque tau;`",
    "RealOutput": "an output is declared with its quantity: `output Length x = ...;`",
    "BooleanInput": "an input is declared with its type: `input Boolean on;`",
    "Gain": "write the product: `y = k*u;`",
    "Add": "write the sum: `y = u1 + u2;`",
    "Feedback": "write the difference: `e = r - y;`",
    "Product": "write the product: `y = u1*u2;`",
    "Constant": "write `constant Real k = 2;`",
    "Flange_a": "a flange is an angle or a length: connect the coordinates, `connect(a.phi, b.phi_a);`",
    "Flange_b": "a flange is an angle or a length: connect the coordinates, `connect(a.phi, b.phi_b);`",
    "Frame_a": "a frame is declared `frame frame_a;`",
    "Frame_b": "a frame is declared `frame frame_b;`",
}

_QUANTITIES = ("Modelica.SIunits", "Modelica.Units", "SI", "SIunits", "Modelica.Units.SI")


@cache
def library_classes() -> dict[str, list[str]]:
    """Full names of the classes of this library by their last part."""
    found: dict[str, list[str]] = {}
    root = library_folder()
    for path in sorted(root.glob("*/*/*.lag")):
        if path.stem != "package":
            found.setdefault(path.stem, []).append(".".join(path.relative_to(root).with_suffix("").parts))
    return found


def class_help(name: str) -> str | None:
    """Help: the text to write for a class of the Modelica Standard Library, or for one of ours that is not imported.

    `name` may be the full name, or its last part alone.
    """
    first, _, last = name.rpartition(".")
    if "Conversions" in first:
        return "a conversion is the unit behind the number: `30 deg`, `100 rpm`"
    if first.startswith("Modelica.Icons"):
        return "delete it: icons have no meaning here"
    if first in _QUANTITIES or first.startswith(_QUANTITIES[:2]):
        return f"quantities are known by their plain name: `{last}`"
    if first.startswith("Modelica.Constants"):
        return f"constants have no package: write `{last}`"
    if last in _WRITTEN and (first.startswith("Modelica") or not first):
        return _WRITTEN[last]
    package = next((here for there, here in _PACKAGES if first.startswith(there)), None)
    choices = library_classes().get(last, [])
    fitting = [choice for choice in choices if package is not None and choice.startswith(package)]
    meant = fitting or ([_CLASSES[last]] if last in _CLASSES else choices)
    if not meant:
        return None
    others = f"; the same in {', '.join(other.rpartition('.')[0] for other in meant[1:])}" if len(meant) > 1 else ""
    new = meant[0].rpartition(".")[2]
    return f"write `import {meant[0]};`, and `{new}` for its type{others}"


def import_help(name: str) -> str | None:
    """Help: the text to write for the import of a package or a class of the Modelica Standard Library."""
    if name.partition(".")[0] != "Modelica":
        return None
    if name in _QUANTITIES or name.startswith(_QUANTITIES[:2]):
        return "delete the import: quantities are known by their plain name, such as `Length`"
    if name.startswith(("Modelica.Constants", "Modelica.Math", "Modelica.Icons")):
        return "delete the import: `pi`, `g_n` and functions such as `sin` are known without it"
    found = class_help(name)
    if found is not None:
        return found
    package = next((here for there, here in _PACKAGES if name.startswith(there)), None)
    if package is None:
        return "the library of this language is `Lag`: `import Lag.Spatial.*;` makes a package of it known"
    return f"write `import {package}.*;`"
