"""A small picture for each rule of the scene: `python docs/figures/scene.py` writes docs/images/scene.

It also draws the machines of the README and of the front page."""

from __future__ import annotations

import re
from pathlib import Path

from lagdsl.documents.plot.picture.film import write_picture
from lagdsl.documents.plot.picture.wishes import Wishes
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.motion.pipeline import flatten_file, read

FOLDER = Path(__file__).parents[1] / "images" / "scene"
MODELS = Path(__file__).parents[2] / "models"
PIXELS = 360
_PENDULUM = "coordinate Angle q(start = 40 deg); gravity = -g_n*world.y;"
_BOB = "point P = {sin(q), -cos(q)} * (1 m);"
# Name of the picture: statements of a model, and the times [s] that the picture shows.
RULES: dict[str, tuple[str, tuple[float, ...]]] = {
    "mass": (
        "coordinate Length x(start = 0.1 m), y; gravity = 0; mass 1 kg at {x, y}; mass 8 kg at {x + 0.3 m, y};"
        "mass 0.1 kg at {x - 0.2 m, y};",
        (),
    ),
    "cart": (
        f"coordinate Length x(start = 0.3 m); {_PENDULUM} mass 2 kg at {{x, 0}}; mass 1 kg at P;"
        "point P = {x, 0} + {sin(q), -cos(q)} * (1 m); draw rod from {x, 0} to P; potential 0.5*(20 N/m)*x^2;",
        (),
    ),
    "bar": (
        f"parameter Length l = 1 m; {_PENDULUM} frame A = world.rotz(q);"
        "body link(m = 1 kg, com = {0, -l/2, 0}, Izz = (1 kg)*l^2/12) on A;",
        (),
    ),
    "wheel": (
        f"parameter Length r = 0.3 m; {_PENDULUM} frame A = world.rotz(q); torque 2 N.m on q;"
        "body disc(m = 1 kg, Izz = (1 kg)*r^2/2) on A;",
        (),
    ),
    "frame": (
        f"{_PENDULUM} frame A = world.rotz(q); point B = A.point({{0.9 m, -0.3 m, 0}}); force {{2 N, -4 N}} at B;"
        "point C = A.point({0.3 m, -0.6 m, 0}); force {-2 N, 0} at C;"
        "body link(m = 1 kg, com = {0.5 m, -0.3 m, 0}, Izz = 0.1 kg.m2) on A;",
        (),
    ),
    "wire": (
        "coordinate Length x(start = 0.2 m), y; gravity = -g_n*world.y; mass 1 kg at {x, y};"
        "constraint wire: y = (0.2 m)*cos(x/(0.2 m));",
        (),
    ),
    "rod": (f"{_PENDULUM} {_BOB} mass 1 kg at P;", ()),
    "arm": (
        f"{_PENDULUM} frame A = world.rotz(q).move({{0, -1 m, 0}}).rotz(-q);"
        "body plate(m = 1 kg, I = {0.02 kg.m2, 0.02 kg.m2, 0.04 kg.m2}) on A;",
        (),
    ),
    "body": (
        "coordinate Angle q(start = 30 deg); gravity = 0; frame A = world.rotz(q);"
        "body plate(m = 1 kg, I = {0.01 kg.m2, 0.05 kg.m2, 0.055 kg.m2}) on A;",
        (),
    ),
    "component": (
        "import Lag.Spatial.*; Revolute outer(axis = {0, 0, 1}, q(start = 20 deg)); gravity = 0;"
        "Revolute inner(axis = {1, 0, 0}, q(start = 60 deg)); Body weight(m = 0.1 kg, com = {0, 0, 0.15 m});"
        "Body ring(m = 0.4 kg, I = {1e-3, 1e-3, 2e-3}); Body rotor(m = 0.8 kg, I = {5e-4, 5e-4, 9e-4});"
        "connect(world, outer, inner, rotor); connect(outer.frame_b, ring); connect(inner.frame_b, weight);",
        (),
    ),
    "spring": (
        "coordinate Length x(start = 1 m), y; gravity = 0; point P = {x, y}; mass 1 kg at P;"
        "potential V = 0.5*(20 N/m)*(norm(P - world.origin) - 0.5 m)^2;",
        (),
    ),
    "ground": (
        "coordinate Length h(start = 0.6 m), x(start = -0.5 m, der(start = 1 m/s)); gravity = -g_n*world.y;"
        "mass 1 kg at {x, h}; contact floor: h >= 0 with restitution = 0.7;",
        (0.0, 0.2, 0.35, 0.6, 0.8),
    ),
    "force": (f"{_PENDULUM} {_BOB} mass 1 kg at P; force {{5 N, 2 N}} at P;", ()),
    "support": (f"{_PENDULUM} {_BOB} mass 1 kg at P; point R = P + {{0.5 m, 0}}; mass 1 kg at R;", ()),
    "circuit": (
        "import Lag.Electrical.*; VoltageSource source(v = 10 V); Resistor R1(R = 10 Ohm); Inductor L1(L = 1 H);"
        "Capacitor C1(C = 10 mF); Ground ground; connect(source.p, R1.p); connect(R1.n, L1.p); connect(L1.n, C1.p);"
        "connect(source.n, C1.n, ground.p);",
        (0.1,),
    ),
    "gauge": (
        "coordinate Angle phi(start = 50 deg); coordinate Length s(start = 0.2 m); gravity = 0;"
        "kinetic T = 0.5*(1 kg.m2)*der(phi)^2 + 0.5*(1 kg)*der(s)^2;",
        (),
    ),
    "draw": (
        f"{_PENDULUM} {_BOB} frame A = world.rotz(q); mass 1 kg at P;"
        'draw box(length = 0.3 m, width = 0.2 m, color = "orange") on A; draw trace at P;',
        (0.0, 0.4, 0.7),
    ),
}


def main() -> None:
    FOLDER.mkdir(exist_ok=True)
    for name, (statements, times) in RULES.items():
        text = f"model {name.title()}\n{statements}\nannotation(experiment(StopTime = 1));\nend {name.title()};\n"
        draw(SourceFile(f"{name}.lag", text), FOLDER / f"{name}.png", times, PIXELS)
    pendulum = read(MODELS / "double_pendulum.lag", Sink())
    assert pendulum is not None
    draw(pendulum, FOLDER.parent / "double_pendulum_machine.png", (0.0, 0.12, 0.24, 0.36, 0.48), 480)
    front = (FOLDER.parents[1] / "index.md").read_text(encoding="utf-8")
    (linkage,) = re.findall(r"```lag file=four_bar.lag\n(.*?)```", front, re.DOTALL)
    draw(SourceFile("four_bar.lag", linkage), FOLDER.parent / "four_bar.png", (0.0, 0.2, 0.4, 0.6), 640)


def draw(source: SourceFile, path: Path, times: tuple[float, ...], pixels: int) -> None:
    """The machine of `source` at `times` [s]. Raises SystemExit with the errors of a text that is no model."""
    sink = Sink()
    flat = flatten_file(source, sink)
    if flat is None:
        raise SystemExit("\n".join(f"{source.name}: {d.code} {d.message}" for d in sink.diagnostics))
    write_picture(flat, Wishes(), path, times, pixels=pixels)


if __name__ == "__main__":
    main()
