"""Models with closed forms that fits are compared with."""

from functools import cache

import lagdsl

# x(t) = a + b t: what is measured is linear in the unknowns.
LINE = """model Line
  coordinate Length x(start = 0.9 m, der(start = 0.2 m/s));
  mass 1 kg at {x, 0};
end Line;
"""

DAMPED = """model Damped "A pendulum with bearing friction"
  parameter Mass m = 1 kg;
  parameter Length l = 50 cm;
  parameter RotationalDamping c(min = 0) = 0.01 N.m.s/rad;
  coordinate Angle theta(start = 40 deg);
  gravity = -g_n*world.y;
  mass m at {l*sin(theta), -l*cos(theta)};
  dissipation 1/2*c*der(theta)^2;
end Damped;
"""

BALL = """model Ball
  parameter Real e(min = 0.1, max = 0.99) = 0.75;
  parameter Acceleration g = 9.6 m/s2;
  coordinate Length h(start = 1 m);
  gravity = -g*world.y;
  mass 0.1 kg at {0, h};
  contact floor: h >= 0 with restitution = e;
  annotation(experiment(StopTime = 4));
end Ball;
"""


@cache
def compiled(text):
    return lagdsl.compile(text)
