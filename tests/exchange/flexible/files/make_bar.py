"""Writes the deck of a steel bar: `make_bar.py COUNT NAME free` for its matrices, or `clamped`."""

import sys
from pathlib import Path

LENGTH, HEIGHT, WIDTH = 0.4, 0.02, 0.01  # m
count, name, task = int(sys.argv[1]), sys.argv[2], sys.argv[3]
corners = [(-HEIGHT / 2, -WIDTH / 2), (HEIGHT / 2, -WIDTH / 2), (HEIGHT / 2, WIDTH / 2), (-HEIGHT / 2, WIDTH / 2)]
lines = ["*HEADING", "Steel bar of 400 mm x 20 mm x 10 mm, in m, kg, s", "*NODE, NSET=ALL"]
for i in range(count + 1):
    lines += [f"{4 * i + k}, {LENGTH * i / count:.10g}, {y:g}, {z:g}" for k, (y, z) in enumerate(corners, 1)]
lines += ["*ELEMENT, TYPE=C3D8I, ELSET=BAR"]
for i in range(count):
    a, b = 4 * i, 4 * i + 4
    lines.append(f"{i + 1}, " + ", ".join(str(n) for n in [a + 1, b + 1, b + 2, a + 2, a + 4, b + 4, b + 3, a + 3]))
lines += ["*NSET, NSET=ROOT", "1, 2, 3, 4", "*NSET, NSET=TIP, GENERATE", f"{4 * count + 1}, {4 * count + 4}"]
lines += ["*NSET, NSET=MIDDLE, GENERATE", f"{2 * count + 1}, {2 * count + 4}"]
lines += [
    "*MATERIAL, NAME=STEEL",
    "*ELASTIC",
    "2.1e11, 0.3",
    "*DENSITY",
    "7850.",
    "*SOLID SECTION, ELSET=BAR, MATERIAL=STEEL",
]
if task == "clamped":
    lines += ["*NODE, NSET=REFERENCE", f"1001, {LENGTH}, 0, 0", f"1002, {LENGTH}, 0, 0", "*BOUNDARY", "ROOT, 1, 3"]
    lines += ["*RIGID BODY, NSET=TIP, REF NODE=1001, ROT NODE=1002", "*STEP", "*FREQUENCY", "8", "*END STEP"]
else:
    lines += ["*STEP", "*FREQUENCY, SOLVER=MATRIXSTORAGE", "*END STEP"]
Path(name + ".inp").write_text("\n".join(lines) + "\n")
