"""The steel bar of CalculiX, imported, and models that carry it."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import lagdsl

FILES = Path(__file__).parent / "files"
LENGTH, HEIGHT, WIDTH, MODULUS = 0.4, 0.02, 0.01, 210e9
_FOLDER = TemporaryDirectory()


@cache
def carried(modes: int, text: str) -> Path:
    """A file with a model that imports `Bar`, which has so many modes; its model is called `Model`."""
    folder = Path(_FOLDER.name) / str(modes)
    if not folder.exists():
        folder.mkdir()
        text_of_bar = lagdsl.import_body(FILES / "bar.inp", ["ROOT", "TIP"], length_unit="m", modes=modes, name="bar")
        (folder / "Bar.lag").write_text(text_of_bar, encoding="utf-8")
    path = folder / f"model{len(list(folder.iterdir()))}.lag"
    path.write_text(f"model Model\n  import Bar;\n{text}end Model;\n", encoding="utf-8")
    return path


CLAMPED = """  Bar bar(beta = 1 us);
  input Force load = 0;
  gravity = 0;
  connect(world, bar);
  force {0, load, 0} at bar.frame_b;
  output Length w = bar.frame_b.origin*world.y;
"""
FREE = """  Lag.Spatial.FreeQuaternion base;
  Bar bar;
  gravity = 0;
  connect(world, base, bar);
"""
SPUN = """  Bar bar(beta = 0.1 ms);
  Lag.Spatial.Revolute hub;
  parameter AngularVelocity W = 1000 rad/s;
  parameter Time T = 100 ms;
  Angle turn = W/T*(if time < T then time^2/2 + (T/(2*pi))^2*(cos(2*pi*time/T) - 1) else T*(time - T/2));
  constraint hub.q = turn;
  gravity = 0;
  connect(world, hub, bar);
  output Length tip = (bar.frame_b.origin - hub.frame_b.origin)*hub.frame_b.y;
"""
