"""Names that every model has without import: the types of quantities by their Modelica names, and a few constants.

Names and units of the types are those of Modelica.Units.SI (Modelica Standard Library 4.0); the short mechanical ones
(`Stiffness`, `Damping` and their rotational sisters) are ours.
"""

from __future__ import annotations

import math
from typing import TypeAlias

from lagdsl.foundation.record import record
from lagdsl.foundation.units.dimension import Dimension
from lagdsl.foundation.units.parse import parse_unit

BaseType: TypeAlias = str
"""`Real`, `Integer`, `Boolean`, `String` or the name of an enumeration."""


@record()
class PreludeType:
    """A type by its name. `unit` is coherent SI, `display_unit` what a report shows, `shape` () for a scalar."""

    name: str
    base: BaseType
    unit: str = "1"
    display_unit: str | None = None
    minimum: float | None = None
    shape: tuple[int, ...] = ()

    @property
    def dimension(self) -> Dimension:
        return parse_unit(self.unit).dimension


@record()
class PreludeConstant:
    """A constant with its coherent SI unit. `doc` says what it is and where the value comes from."""

    name: str
    value: float
    unit: str
    doc: str

    @property
    def dimension(self) -> Dimension:
        return parse_unit(self.unit).dimension


_SPACE_AND_TIME = """
Angle                            rad        deg
SolidAngle                       rad2
Length                           m
PathLength                       m
Position                         m
Distance                         m          -          0
Breadth                          m          -          0
Height                           m          -          0
Thickness                        m          -          0
Radius                           m          -          0
Diameter                         m          -          0
Wavelength                       m
WaveNumber                       1/m
Area                             m2
Volume                           m3
Time                             s
Duration                         s
Period                           s
Velocity                         m/s
Acceleration                     m/s2
Jerk                             m/s3
AngularVelocity                  rad/s
AngularAcceleration              rad/s2
AngularJerk                      rad/s3
Frequency                        Hz
AngularFrequency                 rad/s
DampingCoefficient               1/s
Curvature                        1/m
SecondMomentOfArea               m4
"""

_MECHANICS = """
Mass                             kg         -          0
Density                          kg/m3      g/cm3      0
RelativeDensity                  1          -          0
SpecificVolume                   m3/kg      -          0
LinearDensity                    kg/m       -          0
SurfaceDensity                   kg/m2      -          0
Inertia                          kg.m2
MomentOfInertia                  kg.m2
Momentum                         kg.m/s
Impulse                          N.s
AngularMomentum                  kg.m2/s
AngularImpulse                   N.m.s
Force                            N
Weight                           N
Torque                           N.m
MomentOfForce                    N.m
Energy                           J
Work                             J
KineticEnergy                    J
PotentialEnergy                  J
Action                           J.s
Power                            W
EnergyFlowRate                   W
Pressure                         Pa         bar
AbsolutePressure                 Pa         bar        0
PressureDifference               Pa         bar
Stress                           Pa
NormalStress                     Pa
ShearStress                      Pa
ModulusOfElasticity              Pa
ShearModulus                     Pa
BulkModulus                      Pa
Strain                           1
LinearStrain                     1
ShearStrain                      1
PoissonNumber                    1
Stiffness                        N/m
RotationalStiffness              N.m/rad
Damping                          N.s/m
RotationalDamping                N.m.s/rad
TranslationalSpringConstant      N/m
TranslationalDampingConstant     N.s/m
RotationalSpringConstant         N.m/rad
RotationalDampingConstant        N.m.s/rad
SurfaceTension                   N/m
CoefficientOfFriction            1
Efficiency                       1          -          0
DynamicViscosity                 Pa.s       -          0
KinematicViscosity               m2/s       -          0
MassFlowRate                     kg/s
VolumeFlowRate                   m3/s
GravitationalField               m/s2
"""

_ELECTRICITY = """
Current                          A
ElectricCurrent                  A
CurrentDensity                   A/m2
Charge                           C
ElectricCharge                   C
ChargeDensity                    C/m3
Voltage                          V
ElectricPotential                V
PotentialDifference              V
ElectromotiveForce               V
ElectricField                    V/m
ElectricFieldStrength            V/m
ElectricFlux                     C
ElectricDipoleMoment             C.m
Permittivity                     F/m
Permeability                     H/m
Capacitance                      F          -          0
Inductance                       H
MutualInductance                 H
Resistance                       Ohm
Conductance                      S
Impedance                        Ohm
Reluctance                       1/H
Resistivity                      Ohm.m
Conductivity                     S/m
MagneticFlux                     Wb
MagneticFluxDensity              T
MagneticFieldStrength            A/m
MagneticPotentialDifference      A
MagneticMoment                   A.m2
MagneticDipoleMoment             Wb.m
ElectricalTorqueConstant         N.m/A
ElectricalForceConstant          N/A
"""

_HEAT_AND_MATTER = """
Temperature                      K          degC       0
ThermodynamicTemperature         K          degC       0
TemperatureDifference            K
TemperatureSlope                 K/s
Heat                             J
HeatFlowRate                     W
HeatFlux                         W/m2
HeatCapacity                     J/K
SpecificHeatCapacity             J/(kg.K)
SpecificEnergy                   J/kg
SpecificEnthalpy                 J/kg
Entropy                          J/K
SpecificEntropy                  J/(kg.K)
ThermalConductivity              W/(m.K)
ThermalConductance               W/K
ThermalResistance                K/W
CoefficientOfHeatTransfer        W/(m2.K)
LinearExpansionCoefficient       1/K
CubicExpansionCoefficient        1/K
AmountOfSubstance                mol        -          0
MolarMass                        kg/mol     -          0
MolarVolume                      m3/mol     -          0
Concentration                    mol/m3
LuminousIntensity                cd
"""


def _rows(table: str) -> dict[str, PreludeType]:
    types = {}
    for line in table.split("\n")[1:-1]:
        name, unit, *rest = line.split()
        display_unit = rest[0] if rest and rest[0] != "-" else None
        types[name] = PreludeType(name, "Real", unit, display_unit, float(rest[1]) if len(rest) > 1 else None)
    return types


TYPES: dict[str, PreludeType] = {
    "Real": PreludeType("Real", "Real"),
    "Integer": PreludeType("Integer", "Integer"),
    "Boolean": PreludeType("Boolean", "Boolean"),
    "String": PreludeType("String", "String"),
    # Scalar first; as a coordinate it brings its unit-length constraint along.
    "Quaternion": PreludeType("Quaternion", "Real", shape=(4,)),
    **_rows(_SPACE_AND_TIME),
    **_rows(_MECHANICS),
    **_rows(_ELECTRICITY),
    **_rows(_HEAT_AND_MATTER),
}

# Few on purpose: a short name here would hide a forgotten declaration (`c`, `e`, `G`, `R` belong to the user).
CONSTANTS: dict[str, PreludeConstant] = {
    constant.name: constant
    for constant in (
        PreludeConstant("pi", math.pi, "1", "ratio of circumference to diameter of a circle"),
        PreludeConstant("g_n", 9.80665, "m/s2", "standard gravity; 3rd CGPM (1901), BIPM SI Brochure"),
        PreludeConstant("inf", math.inf, "1", "no bound; fits any unit, as `0` does"),
    )
}
