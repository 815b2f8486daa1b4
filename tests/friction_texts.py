"""Small models with dry friction, contacts of rates and loads that depend on multipliers."""

BLOCK = """
model Block
  coordinate Length s(start = 0 m);
  input Force push = 0 N;
  mass 2 kg at {s, 0 m, 0 m};
  force push on s;
  friction dry: der(s) with limit = 0.3*2 kg*g_n*(1 + (der(s)/(1 m/s))^2), sticking = 9 N;
  output Force f = multiplier(dry);
end Block;
"""
PUCK = """
model Puck
  coordinate Length x(start = 0 m), y(start = 0 m), h(start = 0 m);
  gravity = {0, 0, -g_n};
  mass 2 kg at {x, y, h};
  contact floor: h >= 0 with restitution = 0.5;
  friction pad: {der(x), der(y)} with limit = 0.3*multiplier(floor), sticking = 0.4*multiplier(floor);
  output Force f[2] = multiplier(pad);
end Puck;
"""
FREEWHEEL = """
model Freewheel
  coordinate Angle a(start = 0 rad), b(start = 0 rad);
  input Torque drive = 1 N.m;
  kinetic 1/2*(2 kg.m2)*der(a)^2 + 1/2*(3 kg.m2)*der(b)^2;
  torque drive on a;
  contact wheel: der(b) - 2*der(a) >= 0;
end Freewheel;
"""
BEARING = """
model Bearing
  coordinate Angle phi(start = 0 rad);
  gravity = {0, -g_n, 0};
  frame arm = world.rotz(phi);
  mass 2 kg at arm.origin + 0.5 m*arm.x;
  friction journal: der(phi) with limit = 0.01 m*norm(reaction(arm).force);
  output Force pin = norm(reaction(arm).force);
  output Torque held = reaction(arm).torque.z;
end Bearing;
"""
SLOPE = """
model Slope
  parameter Real mu = 0.3;
  coordinate Length x(start = 0 m), h(start = 0 m);
  gravity = {0, -g_n, 0};
  mass 2 kg at {x, h, 0};
  contact floor: h >= 0 with restitution = 0.5, friction = mu, sticking = 2*mu, slip = der(x);
end Slope;
"""
GEAR = """
model Gear "A worm whose loss is a part of the force between its wheels"
  coordinate Angle a(start = 0 rad), b(start = 0 rad);
  input Torque drive = 1 N.m;
  kinetic 1/2*(2 kg.m2)*der(a)^2 + 1/2*(3 kg.m2)*der(b)^2;
  constraint mesh: a = 4*b;
  torque drive on a;
  torque -0.2*abs(multiplier(mesh))*tanh(der(a)/(1 rad/s)) on a;
end Gear;
"""
ALL = {"block": BLOCK, "puck": PUCK, "freewheel": FREEWHEEL, "bearing": BEARING, "slope": SLOPE, "gear": GEAR}
