"""Rows that repeat are told once; a beam of many elements fits a page."""

from __future__ import annotations

import re
from functools import cache
from math import cos, sin

import numpy as np
import pytest

import lagdsl
from lagdsl.derivation.textbook.steps.assembled import Assembled, assembled
from lagdsl.documents.report.sections.families import rolled
from lagdsl.foundation.diagnostics import Sink
from lagdsl.foundation.source import SourceFile
from lagdsl.language.flat import expression as fx
from lagdsl.language.flat.evaluate import Evaluator, Values
from lagdsl.language.flat.model import FlatModel
from lagdsl.motion.pipeline import flatten_file

BEAM = """model Many
  Lag.Flexible.%sL = 1 m, A = 1 cm^2);
  gravity = -g_n*world.y;
  connect(world, beam);
end Many;
"""


@pytest.mark.parametrize(
    ("rows", "shown"),
    [
        ([("a[1]", "x[1]"), ("a[2]", "x[2] - x[1]"), ("a[3]", "x[3] - x[2]")], ["a[1]", "a[k], k = 2…3 x[k] - x[k-1]"]),
        ([(f"p[{i},{j}]", f"m[{j + 2}]") for i in (1, 2, 3) for j in (1, 2)], ["p[k,j], k = 1…3, j = 1…2 m[j+2]"]),
        ([("p[1,1]", ""), ("p[2,1]", ""), ("p[2,2]", "")], ["p[k,1], k = 1…2", "p[2,2]"]),
        ([("a[1]", "b"), ("a[4]", "b")], ["a[k], k = 1, 4 b"]),
        ([("a", "b"), ("a[1]", "c[7]"), ("a[2]", "d")], ["a b", "a[1] c[7]", "a[2] d"]),
    ],
)
def test_rows_with_like_indices_are_one(rows: list[tuple[str, ...]], shown: list[str]) -> None:
    found = [" ".join(row).strip() for row in rolled(rows)]
    assert len(found) == len(shown)
    assert all(one.startswith(other) for one, other in zip(found, shown, strict=True)), found


@cache
def _told(beam: str) -> str:
    return str(lagdsl.compile(BEAM % beam).derive())


ALL = {
    "Beam": "I = 100 mm^4",
    "ExactBeam": "n = 6, I = 100 mm^4",
    "SpatialExactBeam": "n = 6, Iy = 100 mm^4",
    "Cable": "n = 6",
}


@pytest.mark.parametrize("kind", ALL)
def test_an_element_fits_a_page_however_many_there_are(kind: str) -> None:
    """A page has 60 lines of 100 characters."""
    told = _told(f"{kind} beam({ALL[kind]}, ")
    assert len(" ".join(told.split())) < 60 * 100
    assert told.count("potential of beam") == 1
    assert "Equations of the coordinates" in told
    assert not re.search(r"\d\.\d{13}|e[+-]\d\d\d|more\.|…$", told)


def test_more_elements_have_the_same_page() -> None:
    six, nine = (_told(f"ExactBeam beam(n = {n}, I = 100 mm^4, ").partition("Coordinates")[2] for n in (6, 9))
    for one, other in {"L/6": "L/9", "1…6": "1…9", "1…5": "1…8"}.items():
        six = six.replace(one, other)
    assert six.split() == nine.split()


def _line(told: str) -> str:
    return " ".join(told.split())


def test_strains_of_a_beam_are_told_once() -> None:
    """The strains of E. Reissner, J. Appl. Math. Phys. 23 (1972) 795; what is before the first node is zero."""
    told = _line(_told("ExactBeam beam(n = 6, I = 100 mm^4, "))
    assert told.count("stretch[k]^2") == told.count("potential of beam, k = 1…6") == 1
    for strain in (
        "stretch[k] = (cos(middle[k])*dx[k] + sin(middle[k])*dy[k])/l - 1",
        "slide[k] = (cos(middle[k])*dy[k] - sin(middle[k])*dx[k])/l",
        "middle = q - turn/2;",
        "• beam, k = 1…6: turn[k] = q[k] - q[k-1]; dx[k] = x[k] - x[k-1]; dy[k] = y[k] - y[k-1];",
    ):
        assert told.count(strain) == 1, strain


def test_a_typical_element_of_a_beam_has_a_share_at_both_nodes() -> None:
    """The mass matrix of linear shape functions: O. C. Zienkiewicz and R. L. Taylor, Finite Element Method, 16.2;
    forces N cos - Q sin of the stresses in axes of frame_a: J. C. Simo and L. Vu-Quoc, J. Appl. Mech. 53 (1986) 849."""
    told = _line(_told("ExactBeam beam(n = 6, I = 100 mm^4, "))
    own, next_one = told.split("Share of element")[1:]
    assert own.startswith(" k, k = 1…6, in the words of beam:") and next_one.startswith(" k+1, k = 1…5,")
    inertia = "density*A*l*(der(der(x[k-1]))/6 + der(der(x[k]))/3 - gravity[1]/2)"
    assert f"x[k]: {inertia} + S(stretch[k])*cos(middle[k]) - S(slide[k])*sin(middle[k])" in own
    assert "- S(stretch[k+1])*cos(middle[k+1]) + S(slide[k+1])*sin(middle[k+1])" in next_one
    assert "S(stretch[k]) = E*A*(stretch[k] + stretching*der(stretch[k]))" in told
    assert "S(turn[k]) = E*I*(turn[k] + bending*der(turn[k]))/l" in told


def test_a_weight_at_a_node_is_in_the_share_of_its_element() -> None:
    text = (BEAM % "ExactBeam beam(n = 4, I = 100 mm^4, ").replace(
        "connect(world, beam);",
        "Lag.Planar.Body weight(m = 1 kg); connect(world, beam); connect(beam.node[2], weight);",
    )
    told = _line(str(lagdsl.compile(text).derive()))
    share = told.partition("Share of element 2:")[2].partition("Share of")[0]
    assert "+ weight.m*der(der(beam.x[2]))" in share and "- weight.m*gravity[2]" in share


def test_a_beam_of_modes_has_the_masses_of_its_shapes() -> None:
    """The integrals of x^4/4, of x^2/2 (-x^2/2 + x^3/3) and of the square of this bracket: 1/20, -1/45 and 13/1260."""
    told = _line(_told("Beam beam(I = 100 mm^4, "))
    for part in (
        "density*A*L^2*(L*der(der(q[1]))/20 - L*der(der(q[2]))/45 - gravity[2]/6)",
        "- 0.01031746032*L*der(der(q[2])) - gravity[2]/12)",
        "density*I*L*(der(der(q[1]))/3 - der(der(q[2]))/12)",
        "E*I*(q[1] + beta*der(q[1]))/L",
        "density*A*L*d(part[i].shortening)/d(q[1])*der(der(part[i].shortening)) for i in 1:4)",
    ):
        assert part in told, part


SHORT = """model Short
  frame clamp = world.move({0.1 m, 0.2 m, 0}).rotz(40 deg);
  Lag.Flexible.%s;
  gravity = -g_n*world.y;
  connect(clamp, beam);
end Short;
"""
BEAMS = {
    "planar": "ExactBeam beam(n = 5, L = 1 m, zeta = 0.1, A = 1 cm^2, I = 100 mm^4)",
    "cable": "Cable beam(n = 3, dim = 2, clamped = true, L = 1 m, zeta = 0.1, A = 1 cm^2, E = 1 MPa)",
    "by modes": "Beam beam(L = 1 m, zeta = 0.1, A = 1 cm^2, I = 100 mm^4)",
    "in space": "SpatialExactBeam beam(n = 3, L = 1 m, zeta = 0.1, A = 1 cm^2, Iy = 100 mm^4, Iz = 300 mm^4)",
    "cable in space": "Cable beam(n = 2, L = 1 m, zeta = 0.1, A = 1 cm^2, E = 1 MPa)",
}


@pytest.mark.parametrize("beam", BEAMS.values(), ids=BEAMS)
def test_rows_vanish_with_the_accelerations_of_the_motion(beam: str) -> None:
    """Forces that the runtime computes by another derivation; the only load is the weight, which the rows have. What
    holds a quaternion at its length is along it."""
    text = SHORT % beam
    model, sink = lagdsl.compile(text), Sink()
    flat = flatten_file(SourceFile("beam.lag", text), sink)
    assert flat is not None
    rng = np.random.default_rng(2)
    start = model.initial_state().q
    q, qd = start + rng.uniform(-0.05, 0.05, len(start)), rng.uniform(-1, 1, len(start))
    names = [name for name in model.coordinates if name.startswith("beam.e[")]
    units = np.array([model.coordinates.index(name) for name in names], dtype=int).reshape(-1, 4)
    for unit in units:
        q[unit] /= np.linalg.norm(q[unit])
        qd[unit] -= q[unit] * (q[unit] @ qd[unit])
    qdd = model.forward_dynamics(0.0, q, qd)
    whole, shares = assembled(flat)
    assert [row.coordinate for row in whole.rows] == model.coordinates
    for found in (whole, shares):
        terms = _Terms(flat, found, dict(zip(model.coordinates, q.tolist(), strict=True)), qd.tolist())
        rest, size = np.zeros(len(q)), np.zeros(len(q))
        for row in found.rows:
            place = model.coordinates.index(row.coordinate)
            rest[place] += terms.value(row.left, qdd.tolist())
            size[place] += terms.value(row.left, np.zeros(len(q)).tolist())
        for unit in units:
            rest[unit] -= q[unit] * (q[unit] @ rest[unit])
        assert np.all(np.abs(rest) < 1e-7 * (np.abs(size) + 1e-3))


def _product(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Of quaternions, scalar first."""
    return np.array([a[0] * b[0] - a[1:] @ b[1:], *(a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:]))])


# A sum without one inside: weights and their letter, summand, letter, last index.
SUM = r"sum\((?:\{([^}]*)\}\[(?:[ic])\]\*)?((?:(?!sum\().)*?) for ([ic]) in 1:(\d+)\)"


class _Terms:
    """Values of rows as they are printed."""

    NAME = r"beam(?:\.\w+(?:\[[\d,]+\])?)+"

    def __init__(self, flat: FlatModel, found: Assembled, places: dict[str, float], rates: list[float]) -> None:
        self.flat, self.places, self.rates = flat, places, dict(zip(places, rates, strict=True))
        self.works = {work.element: work.text for work in found.works}
        self.stresses = {stress.strain: stress.text for stress in found.stresses}

    def value(self, left: str, accelerations: list[float]) -> float:
        self.accelerations = dict(zip(self.places, accelerations, strict=True))
        stressed = re.sub(rf"\bS\(({self.NAME})\)", lambda match: f"({self.stresses[match[1]]})", left)
        text, before = re.sub(rf"Q\(({self.NAME}), ({self.NAME})\)", self._work, stressed), ""
        while text != before:  # inner sums first
            text, before = re.sub(SUM, self._sum, text), text
        text = re.sub(rf"d\(({self.NAME})\)/d\(({self.NAME})\)", self._partial, text)
        text = re.sub(r"spin\((beam\.e\[\d+)\], \{(.*?)\}\)\[(\d)\]", self._spin, text)
        return self._plain(text)

    def _plain(self, text: str) -> float:
        text = re.sub(rf"(?P<a>der\()?(?P<b>der\()?(?P<name>{self.NAME})(?(b)\))(?(a)\))", self._number, text)
        return float(eval(text.replace("^", "**"), {"sin": sin, "cos": cos}))

    def _work(self, match: re.Match[str]) -> str:
        """In the names of the model: those of the element have no component before them."""
        element, coordinate = match[1], match[2]
        own = re.sub(
            r"(?<![\w.\]}[])(?!(?:sum|der|d|for|in|q|i|c)\b)[A-Za-z]", rf"{element}.\g<0>", self.works[element]
        )
        return f"({own.replace('/d(q)', f'/d({coordinate})')})"

    def _spin(self, match: re.Match[str]) -> str:
        """2 e o (0, J alpha + omega x J omega), omega = 2 e* o der(e)."""
        names = [f"{match[1]},{part}]" for part in (1, 2, 3, 4)]
        e, ed, edd = (np.array([of[name] for name in names]) for of in (self.places, self.rates, self.accelerations))
        inertia = np.array([self._plain(each) for each in match[2].split(", ")])
        back = e * [1, -1, -1, -1]
        omega, alpha = (2 * _product(back, each)[1:] for each in (ed, edd))
        torque = inertia * alpha + np.cross(omega, inertia * omega)
        return f"({float(2 * _product(e, np.array([0, *torque]))[int(match[3]) - 1])!r})"

    def _sum(self, match: re.Match[str]) -> str:
        weights, inner, letter, count = match[1], match[2], match[3], int(match[4])
        factors = weights.split(",") if weights else ["1"] * count
        index = rf"(?<=[\[,]){letter}(?=[,\]])"
        terms = [f"{weight}*{re.sub(index, str(k + 1), inner)}" for k, weight in enumerate(factors)]
        return f"({'+'.join(terms)})"

    def _partial(self, match: re.Match[str]) -> str:
        step = 1e-5
        values = []
        for shift in (step, -step):
            places = {**self.places, match[2]: self.places[match[2]] + shift}
            values.append(Evaluator(self.flat, Values(variables=places)).scalar(fx.Variable(match[1])))
        return f"({(values[0] - values[1]) / (2 * step)!r})"

    def _number(self, match: re.Match[str]) -> str:
        found: fx.FlatExpression = fx.Variable(match["name"])
        if match["b"] and match["name"] not in self.places:
            return f"({self._second(match['name'])!r})"
        for _ in range(match[0].count("der(")):
            found = fx.Derivative(found)
        at = Values(variables=self.places, rates=self.rates, accelerations=self.accelerations)
        return f"({Evaluator(self.flat, at).scalar(found)!r})"

    def _second(self, name: str) -> float:
        """The second derivative by time along a parabola."""
        step = 1e-4
        paths = ((self.places[q], self.rates[q], self.accelerations[q], q) for q in self.places)
        whole = [(q, place, rate, acceleration) for place, rate, acceleration, q in paths]
        before, now, after = (
            Evaluator(self.flat, Values(variables={q: x + t * v + t * t * a / 2 for q, x, v, a in whole})).scalar(
                fx.Variable(name)
            )
            for t in (-step, 0.0, step)
        )
        return (before - 2 * now + after) / step**2


def test_a_typical_row_of_a_cable_has_the_masses_of_cubic_functions() -> None:
    """The consistent mass matrix of Hermite's cubics, rho A l/420 (156, 54, 22 l, 13 l, 4 l^2, 3 l^2): J. S.
    Przemieniecki, Theory of Matrix Structural Analysis, section 11.4; and the virtual work of strains: J. Gerstmayr and
    H. Irschik, J. Sound Vib. 318 (2008) 461."""
    told = _line(_told("Cable beam(n = 6, "))
    first, own, next_one = told.split("Share of element")[1:]
    rows = (
        (own, "r[k,j], j = 1…3: density*A*l*(9*der(der(r[k-1,j]))/70 + 13*l*der(der(s[k-1,j]))/420"),
        (own, "13*der(der(r[k,j]))/35 - 11*l*der(der(s[k,j]))/210 - gravity[j]/2) + Q(element[k], r[k,j])"),
        (next_one, "9*der(der(r[k+1,j]))/70 - 13*l*der(der(s[k+1,j]))/420"),
        (next_one, "13*der(der(r[k,j]))/35 + 11*l*der(der(s[k,j]))/210"),
        (next_one, "11*der(der(r[k,j]))/210 + l*der(der(s[k,j]))/105"),
        (own, "13*der(der(r[k-1,j]))/420 + l*der(der(s[k-1,j]))/140"),
        (first, "root[k]: density*A*l^2*(13*der(der(r[1,k]))/420 + l*der(der(root[k]))/105 - l*der(der(s[1,k]))/140"),
        (told, "l*EA*(strain[i] + stretching*der(strain[i]))*d(strain[i])/d(q) for i in 1:5)"),
        (told, "l*EI*curvature[c,i]*d(curvature[c,i])/d(q) for i in 1:3)"),
        (told, "bending = 0"),
    )
    for share, part in rows:
        assert part in share, part


def test_rows_of_another_form_are_not_told() -> None:
    """A pendulum turns: its mass matrix in other coordinates is not constant."""
    pendulum = """model Swing
  coordinate Angle q;
  mass 1 kg at {(1 m)*sin(q), -(1 m)*cos(q), 0};
end Swing;
"""
    flat = flatten_file(SourceFile("swing.lag", pendulum), Sink())
    assert flat is not None and assembled(flat) == ()
    assert "Equations of the coordinates" not in str(lagdsl.compile(swinging_chain()).derive())


def swinging_chain() -> str:
    """Seven coordinates, which are too many to be written out."""
    return """model Chain
  coordinate Angle q[7];
  gravity = -g_n*world.y;
  for i in 1:7 loop
    mass 1 kg at {sum(sin(q[j]) for j in 1:i)*(1 m), -sum(cos(q[j]) for j in 1:i)*(1 m), 0};
  end for;
end Chain;
"""
