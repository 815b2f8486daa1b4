"""Point masses on a light elastic frame: Standard Input Data by sums, and a model that writes down each mass."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

rng = np.random.default_rng(7)
MASSES = np.array([0.4, 0.3, 0.5, 0.2, 0.6])
PLACES = rng.uniform(-1, 1, (5, 3)).round(3)
SHAPES = rng.uniform(-1, 1, (5, 3, 2)).round(3)
TURNS = rng.uniform(-1, 1, (5, 3, 2)).round(3)
STIFFNESS = np.array([[50.0, 7.0], [7.0, 90.0]])
DAMPING = np.array([[0.3, 0.1], [0.1, 0.2]])


def taylor(name: str, m0: np.ndarray, m1: np.ndarray | None = None, structure: int = 3) -> Iterator[str]:
    """A block; m1 [rows, modes, columns]."""
    rows, columns = m0.shape
    yield name
    yield f" order = {0 if m1 is None else 1}"
    yield from (f" nrow = {rows}", f" ncol = {columns}", " nq = 2", " nqn = 0", f" structure = {structure}")
    for (i, j), value in np.ndenumerate(m0):
        if structure != 2 or i <= j:
            yield f" m0( {i + 1}, {j + 1}) = {value:.15E}".replace("E", "D")
    for (i, k, j), value in np.ndenumerate(np.zeros((0, 0, 0)) if m1 is None else m1):
        yield f" m1( {i + 1}, {k + 1}, {j + 1}) = {value:.15E}"
    yield f"end {name}"


def tilde(vector: np.ndarray) -> np.ndarray:
    """The matrix of the product vector x ..."""
    x, y, z = vector
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def sid_text() -> str:
    """The integrals of Schwertassek and Wallrapp as sums, matrix by matrix."""
    parts = list(zip(MASSES, PLACES, SHAPES, strict=True))
    modes = range(2)
    ct = sum(m * shape.T for m, _, shape in parts)
    cr = sum(m * (tilde(r) @ shape).T for m, r, shape in parts)
    cr1 = np.array([[sum(m * np.cross(s[:, q], s[:, k]) for m, _, s in parts) for q in modes] for k in modes])
    inertia = sum(-m * tilde(r) @ tilde(r) for m, r, _ in parts)
    inertia1 = np.stack(
        [sum(-m * (tilde(r) @ tilde(s[:, k]) + tilde(s[:, k]) @ tilde(r)) for m, r, s in parts) for k in modes], axis=1
    )
    squares = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)]

    def rotation(shape: np.ndarray, place: np.ndarray) -> list[float]:
        """Factors of the products of angular velocities in shape . (w x (w x place))."""
        found = []
        for i, j in squares:
            total = 0.0
            for a, b in {(i, j), (j, i)}:
                total += shape @ (tilde(np.eye(3)[a]) @ tilde(np.eye(3)[b]) @ place)
            found.append(total)
        return found

    oe = np.array([sum(m * np.array(rotation(s[:, k], r)) for m, r, s in parts) for k in modes])
    oe1 = np.array([[sum(m * np.array(rotation(s[:, k], s[:, q])) for m, _, s in parts) for q in modes] for k in modes])
    me = sum(m * shape.T @ shape for m, _, shape in parts)
    lines = [f"{len(MASSES)} 2", "part", "new modal", "refmod", f" mass = {MASSES.sum()}", " nelastq = 2"]
    lines += [" ielastq ( 1) = Eigenmode 1 : 1.0 Hz", "end refmod", "frame"]
    for k, (_, r, shape) in enumerate(parts):
        lines += [f"new node = {k + 1}", " rframe = body ref"]
        lines += taylor("origin", r[:, None], shape[:, :, None])
        lines += [*taylor("phi", shape), *taylor("psi", TURNS[k]), *taylor("AP", np.eye(3), structure=4), "end node"]
    lines += ["end frame", *taylor("mdCM", (MASSES @ PLACES)[:, None], ct.T[:, :, None])]
    lines += [*taylor("J", inertia, inertia1, structure=2), *taylor("Ct", ct), *taylor("Cr", cr, cr1)]
    lines += [*taylor("Me", me, structure=2), *taylor("Oe", oe, oe1), *taylor("Ke", STIFFNESS, structure=2)]
    lines += [*taylor("De", DAMPING), "end modal", "end part"]
    return "\n".join(lines) + "\n"


def direct_model() -> str:
    """Every mass at its place in the floating frame, which turns and moves against node 1 as the modes say."""

    def at(k: int, sign: str = "") -> str:
        rows = [
            f"{sign}({PLACES[k][i]} m + {SHAPES[k][i][0]}*eta[1] + {SHAPES[k][i][1]}*eta[2])".replace("+ -", "- ")
            for i in range(3)
        ]
        return "{" + ", ".join(rows) + "}"

    half = [f"({TURNS[0][i][0]}*eta[1] + ({TURNS[0][i][1]})*eta[2])/(2 m)" for i in range(3)]
    masses = "\n".join(f"  mass {m} kg at floating.point({at(k)});" for k, m in enumerate(MASSES))
    (a, b), (_, c) = STIFFNESS
    (d, e), (_, f) = DAMPING
    return f"""
model Direct
  Lag.Spatial.FreeMotion base;
  coordinate Length eta[2];
  frame floating;
  gravity = {{1 m/s2, 2 m/s2, -3 m/s2}};
  connect(world, base);
{masses}
  potential (1/2*{a}*eta[1]^2 + {b}*eta[1]*eta[2] + 1/2*{c}*eta[2]^2)*(1 N/m);
  dissipation (1/2*{d}*der(eta[1])^2 + {e}*der(eta[1])*der(eta[2]) + 1/2*{f}*der(eta[2])^2)*(1 N.s/m);
kinematics
  floating = base.frame_b.quat({{1, -{half[0]}, -{half[1]}, -{half[2]}}}).move({at(0, "-")});
end Direct;
"""
