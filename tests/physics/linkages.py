"""Linkages that move only because of their special dimensions, as texts: frames and the equations of the cut joint.

Sources: G. T. Bennett, Engineering 76 (1903) 777; R. Bricard, Lecons de cinematique II (1927); Y. Chen, Z. You,
T. Tarnai, Int. J. Solids and Structures 42 (2005) 2287 (threefold-symmetric Bricard linkage).
"""

from __future__ import annotations

from dataclasses import replace
from math import asin, atan, degrees, radians, sin, tan

from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile, Span
from lagdsl.language.flat.model import Closure, FlatModel
from lagdsl.motion.pipeline import Compilation, compile_flat, flatten_unit, parse_file

BENNETT_TWIST = radians(30.0), asin(2.0 * sin(radians(30.0)) * 0.45)
BENNETT_LENGTH = 0.5, 0.5 * sin(BENNETT_TWIST[1]) / sin(BENNETT_TWIST[0])


def bennett_second_angle(q1: float) -> float:
    """tan(q1/2) tan(q2/2) = sin((beta + alpha)/2) / sin((beta - alpha)/2)."""
    alpha, beta = BENNETT_TWIST
    return 2.0 * atan(sin((beta + alpha) / 2.0) / sin((beta - alpha) / 2.0) / tan(q1 / 2.0))


def bennett(q1: float = radians(70.0), rate: float = 3.0, *, length_error: float = 0.0) -> str:
    (a, b), (alpha, beta) = BENNETT_LENGTH, BENNETT_TWIST
    q2 = bennett_second_angle(q1)
    return f"""model Bennett
  parameter Length a = {a!r}, b = {b + length_error!r};
  parameter Angle alpha = {alpha!r}, beta = {beta!r};
  coordinate Angle q1(start = {q1!r}, fixed = true, der(start = {rate!r})), q2(start = {q2 + 0.01!r}),
    q3(start = {-q1 + 0.01!r});
  frame L1 = world.rotz(q1).move({{a, 0, 0}}).rotx(alpha);
  frame L2 = L1.rotz(q2).move({{b, 0, 0}}).rotx(beta);
  frame L3 = L2.rotz(q3).move({{a, 0, 0}}).rotx(alpha);
  frame pin = world.rotx(-beta).move({{-b, 0, 0}});
  gravity = -g_n*world.y;
  body one(m = 1 kg, com = {{-0.2 m, 0, 0}}, I = {{0.01, 0.02, 0.02}}) on L1;
  body two(m = 2 kg, com = {{-0.2 m, 0, 0}}, I = {{0.01, 0.03, 0.03}}) on L2;
  body three(m = 1 kg, com = {{-0.2 m, 0, 0}}, I = {{0.01, 0.02, 0.02}}) on L3;
  constraint origin: L3.origin = pin.origin;
  constraint axis: L3.z = pin.z;
  invariant E: energy() with tol = 1e-7;
  annotation(experiment(StopTime = 3, Tolerance = 1e-9));
end Bennett;
"""


def bricard(theta: float = 100.0) -> str:
    """cos a + cos b + cos a cos b = 0 for alternate joint angles a, b; unit links, twists 90 and -90 deg."""
    links = []
    for i in range(1, 6):
        before = "world" if i == 1 else f"L{i - 1}"
        twist = "90 deg" if i % 2 else "-90 deg"
        links.append(f"  frame L{i} = {before}.rotz(q{i}).move({{1 m, 0, 0}}).rotx({twist});")
    from math import acos, cos

    phi = degrees(acos(-cos(radians(theta)) / (1.0 + cos(radians(theta)))))
    starts = ", ".join(
        f"q{i}(start = {theta if i % 2 else phi!r} deg{', fixed = true' if i == 1 else ''})" for i in range(1, 6)
    )
    bodies = "\n".join(
        f"  body b{i}(m = 1 kg, com = {{-0.5 m, 0, 0}}, I = {{0.01, 0.1, 0.1}}) on L{i};" for i in range(1, 6)
    )
    return f"""model Bricard
  coordinate Angle {starts};
{chr(10).join(links)}
  frame pin = world.rotx(90 deg).move({{-1 m, 0, 0}});
  gravity = -g_n*world.y;
{bodies}
  constraint origin: L5.origin = pin.origin;
  constraint axis: L5.z = pin.z;
  invariant E: energy() with tol = 1e-7;
  annotation(experiment(StopTime = 1, Tolerance = 1e-9));
end Bricard;
"""


CARDAN = """model DoubleCardan "Z arrangement: both bends 25 deg, forks of the middle shaft in one plane"
  parameter Angle bend = 25 deg;
  coordinate Angle turn(der(start = 8 rad/s)), a, b(start = 25 deg), c, d(start = -25 deg);
  frame input_ = world.rotx(turn);
  frame middle = input_.rotz(a).roty(b);
  frame second = middle.move({0.4 m, 0, 0});
  frame output_ = second.roty(d).rotz(c);
  frame bearing = world.roty(bend).move({0.4 m, 0, 0}).roty(-bend);
  gravity = 0;
  body one(I = {2e-3, 1e-3, 1e-3}) on input_;
  body two(m = 0.5 kg, com = {0.2 m, 0, 0}, I = {2e-4, 1e-3, 1e-3}) on middle;
  body three(I = {2e-3, 1e-3, 1e-3}) on output_;
  constraint origin: output_.origin = bearing.origin;
  constraint axis: output_.x = bearing.x;
  output Real turned[2] = {output_.y*bearing.y, output_.y*bearing.z};
  invariant E: energy() with tol = 1e-7;
  annotation(experiment(StopTime = 2, Tolerance = 1e-10));
end DoubleCardan;
"""

THREE_BARS = """model ThreeBars "Parallelogram with a third bar: one bar too many, and yet it moves"
  parameter Length r = 0.4 m;
  coordinate Angle A(start = 60 deg, fixed = true, der(start = 2 rad/s)), B(start = -60 deg), C(start = 55 deg),
    D(start = 55 deg);
  frame bar = world.rotz(A).move({r, 0, 0});
  frame plate = bar.rotz(B);
  frame second = plate.move({1 m, 0, 0}).rotz(C).move({-r, 0, 0});
  frame third = plate.move({0.5 m, 0, 0}).rotz(D).move({-r, 0, 0});
  gravity = -g_n*world.y;
  mass 1 kg at bar;
  body coupler(m = 2 kg, com = {0.5 m, 0, 0}, Izz = 0.2 kg.m2) on plate;
  mass 0.5 kg at second.point({r/2, 0, 0});
  mass 0.5 kg at third.point({r/2, 0, 0});
  constraint outer: second.origin = {1 m, 0, 0};
  constraint inner: third.origin = {0.5 m, 0, 0};
  invariant E: energy() with tol = 1e-7;
  annotation(experiment(StopTime = 2, Tolerance = 1e-9));
end ThreeBars;
"""


def flat_model(text: str, *, loops: dict[str, tuple[str, tuple[str, ...]]] | None = None) -> FlatModel:
    """Checked and expanded; the constraints named in `loops` close the loop of these joints, cut at the first."""
    sink = Sink()
    unit = parse_file(SourceFile("linkage.lag", text), sink)
    assert unit is not None
    flat = flatten_unit(unit, sink)
    assert flat is not None, [d.message for d in sink.diagnostics]
    if loops is None:
        return flat
    closed = tuple(
        replace(c, closure=_closure(loops[c.name], flat.constraints[0].spans[0])) if c.name in loops else c
        for c in flat.constraints
    )
    return replace(flat, constraints=closed)


def _closure(loop: tuple[str, tuple[str, ...]], span: Span) -> Closure:
    return Closure(joint=loop[0], loop=loop[1], span=span)


def compiled(flat: FlatModel) -> tuple[Compilation | None, Sink]:
    sink = Sink()
    return compile_flat(flat, sink), sink
